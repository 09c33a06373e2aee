//! What the textbooks predict, in closed form.
//!
//! This crate shares nothing with the solver but parameters: their agreement is a scientific claim only because of that.
//! SI units and radians throughout; drag is positive when it resists the tow, vertical force positive when the soil
//! pushes the body up, sinkage positive downwards. A request outside a formula's range is refused, never clamped.

pub mod bearing;
pub mod cutting;
pub mod disc;
pub mod earth_pressure;
pub mod error;
pub mod exact;
pub mod forecast;
mod motion;
mod numeric;
pub mod resistive;
mod soil;
pub mod uncertainty;
pub mod wheel;

pub use error::{Answer, Refusal};
pub use forecast::{Forecast, Load, Towing, forecast};
pub use motion::{froude, inertia_pressure, slip, turn_ratio};
pub use soil::Soil;
