//! What happens in one time step.

pub mod grid;
pub mod state;
