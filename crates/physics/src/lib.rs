//! Material-point physics of soil.
//!
//! Functions take and return the quantities of one point; there are no grids, files, threads or heap
//! allocations in them. SI units, radians, tension positive.
//!
//! The constitutive formulas are written once, for numbers of the type `Real`, and compiled in [`double`] and
//! in [`single`] precision.
// The same files are included on purpose; constants have the digits of double precision.
#![allow(clippy::duplicate_mod, clippy::excessive_precision)]

pub mod double;
pub mod interface;
// Its formulas are those of `double`: `scripts/mutants` changes each once.
#[cfg_attr(false, mutants::skip)]
pub mod single;

pub use double::{
    brick, clay, elastic, law, limiter, menetrey_willam, mohr_coulomb, sand, tensor, viscosity, von_mises,
    yield_law,
};
