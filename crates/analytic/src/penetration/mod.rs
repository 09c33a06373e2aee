//! Cones and piles that are pushed into the ground: the pressure on their end, and the friction on their
//! shaft.

mod cavity;
mod clay;
mod sand;

pub use cavity::{Stiffness, limit_pressure};
pub use clay::{conical_factor, deep_cone_factor};
pub use sand::{end_factor, end_pressure, shaft_friction};
