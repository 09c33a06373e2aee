//! What happens in one time step of the coupled Eulerian–Lagrangian method.
//!
//! [`model::Model`] is what stays fixed during a run, [`state::State`] is everything that changes, [`step::step`] is the
//! step. The loops over cells that vectorise are the kernels in `cpu`: they alone are compiled for each precision of the
//! fields, and [`precision::Precision`] is what the step asks of them.

pub mod balance;
pub mod bodies;
pub mod boundary;
mod check;
mod contact;
pub mod cpu;
pub mod energy;
pub mod error;
pub mod fields;
pub mod footprint;
mod ghosts;
pub mod grid;
pub mod halo;
pub mod initial;
pub mod material;
pub mod model;
pub mod precision;
pub mod remap;
mod scalar;
pub mod state;
pub mod step;
pub mod workspace;
