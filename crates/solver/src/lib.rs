//! What happens in one time step of the coupled Eulerian–Lagrangian method.
//!
//! [`model::Model`] is what stays fixed during a run, [`state::State`] is everything that changes, [`step::step`] is the
//! step. Loops over cells live in `cpu`.

pub mod audit;
pub mod cpu;
pub mod error;
pub mod grid;
pub mod model;
pub mod start;
pub mod state;
pub mod step;
