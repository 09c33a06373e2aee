//! Dimensionless numbers of a body's motion: slip, Froude number, and the pressure due to inertia.

/// Slip s of a wheel from its turn ratio ωr/v: 1 − v/(ωr) where it is driven (ωr > v), otherwise ωr/v − 1.
///
/// −1 is a locked wheel, 0 free rolling, 1 spinning on the spot; below −1 the wheel turns backwards. Source:
/// the usual definition in terramechanics (Wong, Theory of Ground Vehicles): the difference of the two speeds
/// over the larger one.
#[must_use]
pub fn slip(turn_ratio: f64) -> f64 {
    if turn_ratio > 1.0 { 1.0 - 1.0 / turn_ratio } else { turn_ratio - 1.0 }
}

/// Turn ratio ωr/v at slip s < 1, the inverse of [`slip`].
#[must_use]
pub fn turn_ratio(slip: f64) -> f64 {
    if slip > 0.0 { 1.0 / (1.0 - slip) } else { 1.0 + slip }
}

/// Froude number v²/(g z) of a motion at v [m/s] through soil z [m] deep, under gravity g [m/s²].
#[must_use]
pub fn froude(speed: f64, gravity: f64, depth: f64) -> f64 {
    speed * speed / (gravity * depth)
}

/// Contribution of inertia to the mean passive pressure on a smooth vertical face that moves at v [m/s] into
/// soil of density ρ [kg/m³]: 2 ρ v² [Pa], independent of the friction angle.
///
/// Soil at rest enters the moving wedge at ρ v z [kg/s per metre] and takes on its velocity, v forwards and v
/// tan β upwards (β = 45° − φ/2); with the reaction of the slip surface that is a thrust of ρ v² z (1 + tan β
/// tan(β + φ)) = 2 ρ v² z. Over the static thrust ½ γ z² K_p it is 4 Fr/K_p. Source: momentum balance of
/// Rankine's wedge, derived for this project; 2 is also the inertia factor of McKyes' wedge in this case
/// (recalled, not re-read). Valid for slow motion, where the wedge is still the static one.
#[must_use]
pub fn inertia_pressure(density: f64, speed: f64) -> f64 {
    2.0 * density * speed * speed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slip_has_one_sign_convention_and_is_continuous_at_rolling() {
        assert_eq!([slip(0.0), slip(1.0), slip(0.5), slip(2.0)], [-1.0, 0.0, -0.5, 0.5]);
        assert!((slip(1.0 / 0.7) - 0.3).abs() < 1e-15, "a slip of 0.3 is 0.3, not 0.4286");
        assert_eq!(slip(f64::INFINITY), 1.0);
        for ratio in [-0.5, 0.0, 0.3, 1.0, 1.2, 3.0] {
            assert!((turn_ratio(slip(ratio)) - ratio).abs() < 1e-15);
        }
    }

    #[test]
    fn inertia_is_that_of_the_momentum_of_rankines_wedge() {
        let (density, gravity, speed, depth) = (1600.0, 9.81, 0.3, 0.1);
        for phi in [0.0, 20.0, 35.0, 45.0].map(f64::to_radians) {
            let beta = std::f64::consts::FRAC_PI_4 - 0.5 * phi;
            let added = density * speed * speed * (1.0 + beta.tan() * (beta + phi).tan());
            assert!((inertia_pressure(density, speed) / added - 1.0).abs() < 1e-12);
            let passive = (0.5 * density * gravity * depth) / beta.tan().powi(2);
            let ratio = 4.0 * froude(speed, gravity, depth) * beta.tan().powi(2);
            assert!((inertia_pressure(density, speed) / passive / ratio - 1.0).abs() < 1e-12);
        }
    }
}
