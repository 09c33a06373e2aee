//! What the spread of the inputs makes of the answer.

mod propagate;
mod sequence;
mod spread;
mod towing;

pub use propagate::{Uncertainty, propagate};
pub use sequence::Sequence;
pub use spread::Spread;
pub use towing::{TowingUncertainty, propagate_towing, sweep_table};
