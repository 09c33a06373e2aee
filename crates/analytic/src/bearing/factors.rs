//! Bearing capacity factors N_q, N_c and N_γ of a strip footing.

use crate::earth_pressure::{Face, sokolovskii};
use crate::error::{ModelResult, within};
use std::f64::consts::FRAC_PI_4;

/// Range of the friction angle for the algebraic factors [rad]: 0.1° to 55°.
const RANGE: (f64, f64) = (0.001_745, 0.959_932);

fn friction(angle: f64) -> ModelResult<f64> {
    within("friction angle [rad]", angle, RANGE.0, RANGE.1)
}

/// Surcharge factor N_q = e^{π tan φ} tan²(45° + φ/2); exact. φ in radians, 0.1° to 55°.
///
/// Source: Prandtl (1920), Reissner (1924).
///
/// # Errors
/// If φ is out of range.
pub fn surcharge_factor(friction_angle: f64) -> ModelResult<f64> {
    let phi = friction(friction_angle)?;
    Ok((std::f64::consts::PI * phi.tan()).exp() * (FRAC_PI_4 + 0.5 * phi).tan().powi(2))
}

/// Cohesion factor N_c = (N_q − 1) cot φ; exact. φ in radians, 0.1° to 55°. Source: Prandtl (1920).
///
/// # Errors
/// If φ is out of range.
pub fn cohesion_factor(friction_angle: f64) -> ModelResult<f64> {
    Ok((surcharge_factor(friction_angle)? - 1.0) / friction_angle.tan())
}

/// Weight factor N_γ = (N_q − 1) tan(1.4 φ) of Meyerhof (1963) (recalled, not re-read). φ in radians, 0.1° to
/// 55°.
///
/// # Errors
/// If φ is out of range.
pub fn weight_factor_meyerhof(friction_angle: f64) -> ModelResult<f64> {
    Ok((surcharge_factor(friction_angle)? - 1.0) * (1.4 * friction_angle).tan())
}

/// Weight factor N_γ = 1.5 (N_q − 1) tan φ of Hansen (1970) (recalled, not re-read). φ in radians, 0.1° to
/// 55°.
///
/// # Errors
/// If φ is out of range.
pub fn weight_factor_hansen(friction_angle: f64) -> ModelResult<f64> {
    Ok(1.5 * (surcharge_factor(friction_angle)? - 1.0) * friction_angle.tan())
}

/// Weight factor N_γ = 2 (N_q + 1) tan φ of Vesić (1973) (recalled, not re-read). φ in radians, 0.1° to 55°.
///
/// # Errors
/// If φ is out of range.
pub fn weight_factor_vesic(friction_angle: f64) -> ModelResult<f64> {
    Ok(2.0 * (surcharge_factor(friction_angle)? + 1.0) * friction_angle.tan())
}

/// Weight factor N_γ = (N_q − 1) tan(1.32 φ), the fit of Lyamin et al. (2007) to limit analysis (recalled,
/// not re-read). φ in radians, 0.1° to 55°.
///
/// # Errors
/// If φ is out of range.
pub fn weight_factor_lyamin(friction_angle: f64) -> ModelResult<f64> {
    Ok((surcharge_factor(friction_angle)? - 1.0) * (1.32 * friction_angle).tan())
}

/// Exact weight factor N_γ of a smooth strip: half the self-similar coefficient of a level face, ½ K_n(α = 0,
/// δ = 0).
///
/// φ in radians, 10° to 50°. Source: Sokolovskii (1965); agrees with Martin (2005) to four digits.
///
/// # Errors
/// If φ is out of range.
pub fn weight_factor_exact_smooth(friction_angle: f64) -> ModelResult<f64> {
    let face = Face { friction_angle, wall_friction: 0.0, surface: 0.0, backfill: 0.0 };
    Ok(0.5 * sokolovskii(&face)?.coefficient)
}

/// Martin's N_γ of a rough strip at φ = 5°, 10° … 50°.
const MARTIN_ROUGH: [f64; 10] = [0.1134, 0.4332, 1.181, 2.839, 6.491, 14.75, 34.48, 85.57, 234.2, 742.9];

/// Weight factor N_γ of a rough strip: Martin's exact values, ln N_γ interpolated by cubics in φ.
///
/// φ in radians, 5° to 50°. Source: Martin (2005), IACMAG, method of characteristics (recalled, not re-read).
///
/// # Errors
/// If φ is out of range.
pub fn weight_factor_martin_rough(friction_angle: f64) -> ModelResult<f64> {
    let phi = within("friction angle [rad]", friction_angle, 5_f64.to_radians(), 50_f64.to_radians())?;
    let position = (phi.to_degrees() / 5.0 - 1.0).clamp(0.0, 9.0);
    let first = (position.floor() as usize).saturating_sub(1).min(6);
    let x = position - first as f64;
    // Cubic Lagrange interpolation through the four nearest values.
    let log = (0..4).map(|i| {
        let others = (0..4).filter(|j| *j != i);
        let weight: f64 = others.map(|j| (x - j as f64) / (i as f64 - j as f64)).product();
        weight * MARTIN_ROUGH[first + i].ln()
    });
    Ok(log.sum::<f64>().exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surcharge_factors_are_prandtls() {
        for (phi, n) in [(20., 6.40), (25., 10.66), (30., 18.40), (35., 33.30), (40., 64.20), (45., 134.87)] {
            assert!((surcharge_factor(f64::to_radians(phi)).unwrap() / n - 1.0).abs() < 5e-4);
        }
        assert!((cohesion_factor(0.002).unwrap() - 5.1416).abs() < 0.05);
        assert!(surcharge_factor(1.2).is_err());
    }

    #[test]
    fn smooth_strip_is_exact_and_rough_strip_is_martins() {
        let smooth = [0.2810, 0.6991, 1.579, 3.461, 7.653, 17.58, 43.19, 117.6, 372.0];
        for (n, expected) in smooth.into_iter().enumerate() {
            let found = weight_factor_exact_smooth(f64::to_radians(10.0 + 5.0 * n as f64)).unwrap();
            assert!((found / expected - 1.0).abs() < 5e-4, "{found} for {expected}");
        }
        for (n, expected) in MARTIN_ROUGH.into_iter().enumerate() {
            let phi = f64::to_radians(5.0 + 5.0 * n as f64);
            let found = weight_factor_martin_rough(phi).unwrap();
            assert!((found / expected - 1.0).abs() < 1e-9, "{found} for {expected}");
            if n >= 1 {
                assert!(found > weight_factor_exact_smooth(phi).unwrap());
            }
        }
    }

    #[test]
    fn meyerhof_stays_near_the_rough_strip() {
        for phi in [25.0_f64, 30.0, 35.0, 40.0] {
            let ratio = weight_factor_meyerhof(phi.to_radians()).unwrap()
                / weight_factor_martin_rough(phi.to_radians()).unwrap();
            assert!((ratio - 1.0).abs() < 0.1, "{phi}: {ratio}");
        }
    }
}
