//! Exact solutions and established scaling laws, for verification.

mod collapse;
mod elastic;
mod growing_strength;
mod motion;

pub use collapse::{Collapse, axisymmetric_collapse, plane_collapse};
pub use elastic::{at_rest_coefficient, bar_wave_speed, pressure_wave_speed, shear_wave_speed};
pub use growing_strength::strip_on_growing_strength;
pub use motion::{fall_distance, rolling_fall_acceleration, slide_distance};
