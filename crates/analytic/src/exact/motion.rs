//! Motion of rigid bodies.

use crate::error::{ModelResult, non_negative, positive, within};
use std::f64::consts::FRAC_PI_2;

/// Free-fall distance from rest after t [s] under gravity g [m/s²]: ½ g t² [m].
///
/// # Errors
/// If g or t is negative or not finite.
pub fn fall_distance(gravity: f64, time: f64) -> ModelResult<f64> {
    Ok(0.5 * non_negative("gravity [m/s^2]", gravity)? * non_negative("time [s]", time)?.powi(2))
}

/// Sliding distance from rest after t [s] down a slope of angle θ [rad] with friction μ: ½ g (sin θ − μ cos
/// θ) t² [m], or 0 where friction holds the body.
///
/// # Errors
/// Unless 0 ≤ θ ≤ 90° and g, μ, t are not negative.
pub fn slide_distance(gravity: f64, slope: f64, friction: f64, time: f64) -> ModelResult<f64> {
    let (sin, cos) = within("slope [rad]", slope, 0.0, FRAC_PI_2)?.sin_cos();
    let excess = sin - non_negative("friction", friction)? * cos;
    Ok(fall_distance(gravity, time)? * excess.max(0.0))
}

/// Acceleration of a body rolling down a slope without slip: g sin θ / (1 + I/(m R²)) [m/s²].
///
/// `inertia` I [kg m²], `mass` m [kg], `radius` R [m]. ⅔ g sin θ for a solid disc.
///
/// # Errors
/// If a quantity is out of range.
pub fn rolling_fall_acceleration(
    gravity: f64,
    slope: f64,
    inertia: f64,
    mass: f64,
    radius: f64,
) -> ModelResult<f64> {
    let sin = within("slope [rad]", slope, 0.0, FRAC_PI_2)?.sin();
    let arm = positive("mass [kg]", mass)? * positive("radius [m]", radius)?.powi(2);
    Ok(non_negative("gravity [m/s^2]", gravity)? * sin
        / (1.0 + non_negative("inertia [kg m^2]", inertia)? / arm))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solid_disc_rolls_at_two_thirds() {
        let (m, r) = (3.0, 0.2);
        let a = rolling_fall_acceleration(9.81, 0.3, 0.5 * m * r * r, m, r).unwrap();
        assert!((a / (9.81 * 0.3_f64.sin()) - 2.0 / 3.0).abs() < 1e-12);
        assert_eq!(slide_distance(9.81, 0.1, 0.5, 2.0).unwrap(), 0.0);
        assert!(fall_distance(9.81, f64::NAN).is_err());
    }
}
