//! What happens at one point of soil, or on the skin of one body.
//!
//! Nothing here knows a grid, a file, a thread or the heap of a running simulation: every function takes the numbers
//! of one point and returns the numbers of one point. SI units, radians, tension positive.
//!
//! The formulas of the soil are written once, for numbers of the type `Real`, and compiled twice: in [`double`]
//! precision and in [`single`].
// The same files on purpose; a digit that single precision cannot hold is none too many for double.
#![allow(clippy::duplicate_mod, clippy::excessive_precision)]

pub mod double;
pub mod interface;
pub mod rigid;
pub mod shape;
pub mod single;

pub use double::{
    brick, elastic, limiter, menetrey_willam, mohr_coulomb, strength, tensor, viscosity, von_mises,
};
