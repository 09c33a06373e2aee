//! Davis' operative friction angle: the loss of strength due to non-associated flow.

use crate::error::{ModelResult, within};
use std::f64::consts::FRAC_PI_2;

/// Operative friction angle φ* [rad] of soil that dilates at ψ < φ: tan φ* = cos ψ cos φ tan φ / (1 − sin ψ
/// sin φ).
///
/// Source: Davis (1968), in Soil Mechanics: Selected Topics (recalled, not re-read). φ* = φ for associated
/// flow. Valid for 0 ≤ ψ ≤ φ < 90°, and for −φ ≤ ψ < 0 by the same formula.
///
/// # Errors
/// If φ or ψ is out of range.
pub fn davis_friction_angle(friction_angle: f64, dilation_angle: f64) -> ModelResult<f64> {
    let phi = within("friction angle [rad]", friction_angle, 0.0, FRAC_PI_2 - 1e-6)?;
    let psi = within("dilation angle [rad]", dilation_angle, -phi, phi)?;
    Ok((psi.cos() * phi.sin() / (1.0 - psi.sin() * phi.sin())).atan())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn davis_matches_the_table() {
        let table = [
            (30., [26.6, 27.5, 28.3]),
            (35., [29.8, 31.0, 32.1]),
            (40., [32.7, 34.2, 35.5]),
            (45., [35.3, 36.9, 38.4]),
        ];
        for (phi, row) in table {
            for (psi, expected) in [0., 5., 10.].into_iter().zip(row) {
                let found =
                    davis_friction_angle(f64::to_radians(phi), f64::to_radians(psi)).unwrap().to_degrees();
                assert!((found - expected).abs() < 0.06, "φ={phi} ψ={psi}: {found} for {expected}");
            }
            let same = davis_friction_angle(f64::to_radians(phi), f64::to_radians(phi)).unwrap().to_degrees();
            assert!((same - phi).abs() < 1e-9);
        }
    }
}
