//! What happens in one time step of the coupled Eulerian–Lagrangian method.
//!
//! [`model::Model`] is what stays fixed during a run, [`state::State`] is everything that changes, [`step::step`] is the
//! step. Loops over cells live in `cpu`.
//!
//! The step and its loops are written once, for fields of the type `Real`, and compiled twice: in [`double`] precision
//! and in [`single`].
// The same files on purpose; what widens a number in single precision does nothing in double.
#![allow(clippy::duplicate_mod, clippy::useless_conversion)]

pub mod cpu;
pub mod double;
pub mod error;
pub mod footprint;
pub mod grid;
pub mod model;
pub mod precision;
pub mod single;
pub mod state;

pub use double::{audit, start, step};
