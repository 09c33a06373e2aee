//! Propagation of input uncertainties: intervals and Sobol indices.

mod distribution;
mod propagate;
mod sequence;
mod towing;

pub use distribution::Distribution;
pub use propagate::{Uncertainty, propagate};
pub use sequence::Sequence;
pub use towing::{TowingUncertainty, propagate_towing, sweep_table};
