//! The time step of the coupled Eulerian–Lagrangian method.
//!
//! [`model::Model`] is what stays fixed during a run, [`state::State`] is everything that changes, and
//! [`step::step`] takes one step. The vectorised loops over cells are the kernels in `cpu`; only they are
//! written for each precision of the fields. [`precision::Precision`] is what a program needs of either.

pub mod balance;
pub mod bodies;
pub mod boundary;
mod check;
mod compiled;
mod contact;
pub mod cpu;
pub mod device;
mod enclosed;
pub mod energy;
pub mod error;
pub mod exact_sum;
pub mod fields;
mod fit;
pub mod footprint;
mod ghosts;
pub mod grid;
pub mod halo;
pub mod initial;
mod kernels;
pub mod material;
pub mod model;
mod pore_pressure;
pub mod portion;
pub mod precision;
pub mod remap;
mod rest;
mod scalar;
pub mod state;
pub mod step;
pub mod touching;
mod uneven;
pub mod workspace;
