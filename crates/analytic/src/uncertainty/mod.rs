//! Propagation of input uncertainties: intervals and Sobol indices.

mod propagate;
mod towing;

pub use numerics::Distribution;
pub use propagate::{Uncertainty, propagate};
pub use towing::{TowingUncertainty, propagate_towing, sweep_table};
