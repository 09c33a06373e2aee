//! Numerical methods that know nothing of soil: matrices, roots, minima, quadrature, random numbers,
//! distributions and quantiles.
//!
//! Sums run in one fixed order, and the elementary functions are those of the standard library.

pub mod distribution;
pub mod elimination;
pub mod quadrature;
mod quantile;
pub mod quasi_newton;
pub mod random;
pub mod search;
pub mod semidefinite;
pub mod sequence;
pub mod symmetric;

pub use distribution::Distribution;
pub use quantile::{quantile, quantile_of_sorted};
pub use random::Draws;
pub use sequence::Sequence;
