//! The pressure on the end of a cone or a pile deep in sand, and the friction on its shaft.

use super::{Stiffness, limit_pressure};
use crate::error::ModelResult;
use crate::soil::Soil;
use std::f64::consts::FRAC_PI_2;

/// Pressure on the end over the limit pressure of a spherical cavity: e^{(π/2 − φ) tan φ}/(1 − sin φ).
///
/// Under the end a wedge of soil at 45° + φ/2 moves with it, and a fan turns the pressure of the cavity into
/// that on the wedge. Source: Vesić (1977), NCHRP Synthesis 42; without the fan, Yasufuku & Hyde (1995).
#[must_use]
pub fn end_factor(friction_angle: f64) -> f64 {
    let phi = friction_angle;
    ((FRAC_PI_2 - phi) * phi.tan()).exp() / (1.0 - phi.sin())
}

/// Pressure [Pa] on the end at a depth [m]: q + c cot φ = (p_lim + c cot φ) e^{(π/2 − φ) tan φ}/(1 − sin φ),
/// with the limit pressure p_lim under the mean stress at rest γ z (1 + 2 K₀)/3.
///
/// # Errors
/// As [`limit_pressure`].
pub fn end_pressure(soil: &Soil, stiffness: &Stiffness, k0: f64, depth: f64) -> ModelResult<f64> {
    let mean = soil.unit_weight * depth * (1.0 + 2.0 * k0) / 3.0;
    let attraction = soil.cohesion / soil.friction_angle.tan();
    let limit = limit_pressure(soil, stiffness, mean)?;
    Ok((limit + attraction) * end_factor(soil.friction_angle) - attraction)
}

/// Nodes and weights of Gauss's rule with five points on 0 to 1.
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_095),
    (0.230_765_344_947_158, 0.239_314_335_249_683),
    (0.5, 0.284_444_444_444_444),
    (0.769_234_655_052_842, 0.239_314_335_249_683),
    (0.953_089_922_969_332, 0.118_463_442_528_095),
];

/// Friction [N] on a shaft of the diameter [m] between two depths [m], whose end lies at the second: τ = 0.03
/// q (h/d)^−½ tan δ, with the end pressure q at that depth and the height h above the end, at least 2 d.
///
/// Source: Lehane, Schneider & Xu (2005), the UWA-05 method, for closed ends, without the part of dilation.
///
/// # Errors
/// What `end` says.
pub fn shaft_friction(
    diameter: f64,
    [top, bottom]: [f64; 2],
    friction: f64,
    end: impl Fn(f64) -> ModelResult<f64>,
) -> ModelResult<f64> {
    let length = bottom - top;
    if length <= 0.0 || friction == 0.0 {
        return Ok(0.0);
    }
    let mut sum = 0.0;
    for (place, weight) in GAUSS {
        let depth = top + place * length;
        let height = ((bottom - depth) / diameter).max(2.0);
        sum += weight * 0.03 * end(depth)? / height.sqrt();
    }
    Ok(std::f64::consts::PI * diameter * length * friction * sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn end_bearing_is_that_of_vesic() {
        // Vesić's N_q = 3/(3 − sin φ) e^{(π/2 − φ) tan φ} tan²(45° + φ/2) I_rr^{4 sin φ/(3 (1 + sin φ))} in
        // incompressible soil.
        let phi = 35_f64.to_radians();
        let soil = Soil {
            friction_angle: phi,
            dilation_angle: 0.0,
            cohesion: 0.0,
            unit_weight: 16e3,
            body_friction: 0.3,
            adhesion_factor: 1.0,
            strength_gradient: 0.0,
        };
        let stiffness = Stiffness { young_modulus: 20e6, poisson_ratio: 0.49 };
        let (depth, k0) = (5.0, 0.5);
        let mean = soil.unit_weight * depth * (1.0 + 2.0 * k0) / 3.0;
        let found = end_pressure(&soil, &stiffness, k0, depth).unwrap() / mean;
        let rigidity: f64 = stiffness.shear_modulus() / (mean * phi.tan());
        let exponent = 4.0 * phi.sin() / (3.0 * (1.0 + phi.sin()));
        let known = 3.0 / (3.0 - phi.sin())
            * ((FRAC_PI_2 - phi) * phi.tan()).exp()
            * (0.25 * std::f64::consts::PI + 0.5 * phi).tan().powi(2)
            * rigidity.powf(exponent);
        assert!((found / known - 1.0).abs() < 0.1, "{found} for {known}");
    }

    #[test]
    fn friction_of_a_uniform_end_pressure_is_known() {
        // Up to 2 d above the end 0.03 q/√2.
        let found = shaft_friction(0.1, [0.9, 1.0], 0.5, |_| Ok(1e6)).unwrap();
        let known = std::f64::consts::PI * 0.1 * 0.1 * 0.5 * 0.03e6 / 2_f64.sqrt();
        assert!((found / known - 1.0).abs() < 1e-9, "{found} for {known}");
        assert_eq!(shaft_friction(0.1, [0.0, 1.0], 0.0, |_| Ok(1e6)).unwrap(), 0.0);
    }
}
