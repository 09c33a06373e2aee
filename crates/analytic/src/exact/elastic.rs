//! Elastic wave speeds and the stress at rest.

use crate::error::{ModelResult, positive, within};

fn constants(modulus: f64, ratio: f64, density: f64) -> ModelResult<(f64, f64, f64)> {
    let ratio = within("Poisson's ratio", ratio, 0.0, 0.499)?;
    Ok((positive("Young's modulus [Pa]", modulus)?, ratio, positive("density [kg/m^3]", density)?))
}

/// Speed of a compression wave √(E(1−ν)/(ρ(1+ν)(1−2ν))) [m/s].
///
/// # Errors
/// Unless E > 0, 0 ≤ ν < 0.5, ρ > 0.
pub fn pressure_wave_speed(modulus: f64, ratio: f64, density: f64) -> ModelResult<f64> {
    let (e, nu, rho) = constants(modulus, ratio, density)?;
    Ok((e * (1.0 - nu) / (rho * (1.0 + nu) * (1.0 - 2.0 * nu))).sqrt())
}

/// Speed of a shear wave √(E/(2ρ(1+ν))) [m/s].
///
/// # Errors
/// As [`pressure_wave_speed`].
pub fn shear_wave_speed(modulus: f64, ratio: f64, density: f64) -> ModelResult<f64> {
    let (e, nu, rho) = constants(modulus, ratio, density)?;
    Ok((e / (2.0 * rho * (1.0 + nu))).sqrt())
}

/// Speed of a wave along a thin bar √(E/ρ) [m/s].
///
/// # Errors
/// As [`pressure_wave_speed`].
pub fn bar_wave_speed(modulus: f64, density: f64) -> ModelResult<f64> {
    let (e, _, rho) = constants(modulus, 0.0, density)?;
    Ok((e / rho).sqrt())
}

/// Coefficient of earth pressure at rest of elastic ground, K₀ = ν/(1 − ν).
///
/// # Errors
/// Unless 0 ≤ ν < 0.5.
pub fn at_rest_coefficient(ratio: f64) -> ModelResult<f64> {
    let nu = within("Poisson's ratio", ratio, 0.0, 0.499)?;
    Ok(nu / (1.0 - nu))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_are_ordered() {
        let (p, s, bar) = (
            pressure_wave_speed(1e7, 0.3, 1600.0).unwrap(),
            shear_wave_speed(1e7, 0.3, 1600.0).unwrap(),
            bar_wave_speed(1e7, 1600.0).unwrap(),
        );
        assert!(s < bar && bar < p);
        assert!((at_rest_coefficient(0.3).unwrap() - 3.0 / 7.0).abs() < 1e-12);
    }
}
