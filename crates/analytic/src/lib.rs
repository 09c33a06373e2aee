//! Closed-form models of soil–body interaction, from the literature and derived for this project.
//!
//! This crate shares nothing that knows of soil with the solver, so that agreement between the two says
//! something about the soil. SI units and radians throughout; drag is positive when it resists the tow,
//! vertical force positive when the soil pushes the body up, sinkage positive downwards. An input outside the
//! range of a formula is an error; it is never clamped.

pub mod bearing;
pub mod capacity;
pub mod cutting;
pub mod disc;
pub mod earth_pressure;
pub mod error;
pub mod exact;
pub mod forecast;
mod motion;
pub mod penetration;
pub mod pipe;
mod pore_water;
pub mod resistive;
mod soil;
pub mod uncertainty;
pub mod uplift;
pub mod wheel;

pub use error::{ModelError, ModelResult};
pub use forecast::{Forecast, Load, Towing, forecast, reference_force};
pub use motion::{froude, inertia_pressure, slip, turn_ratio};
pub use pore_water::{PoreWater, Suction};
pub use soil::Soil;
