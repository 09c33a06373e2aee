//! Bearing factors of cones in undrained clay, at the surface and at depth.

use crate::error::{ModelResult, non_negative, positive, within};
use std::f64::consts::PI;

/// Factor N of a cone deep in clay, q = N s_u + σ_v0: 3.4 + 1.6 ln I_r − 1.9 Δ + 1.3 α.
///
/// I_r = G/s_u is the rigidity index, Δ = (σ_v0 − σ_h0)/(2 s_u) the shear at rest, −1 to 1, α the roughness
/// of the cone, 0 to 1. A cone of 60°. Source: Lu, Hu, Randolph & Bugarski (2004), Géotechnique 54(4),
/// 257–267, large-strain finite elements with I_r of 50 to 500.
///
/// # Errors
/// Unless 20 ≤ I_r ≤ 2000 and the others are in range.
pub fn deep_cone_factor(rigidity: f64, shear_at_rest: f64, roughness: f64) -> ModelResult<f64> {
    let rigidity = within("rigidity index G/s_u", rigidity, 20.0, 2000.0)?;
    let delta = within("shear at rest (σ_v − σ_h)/(2 s_u)", shear_at_rest, -1.0, 1.0)?;
    let alpha = within("roughness", roughness, 0.0, 1.0)?;
    Ok(3.4 + 1.6 * rigidity.ln() - 1.9 * delta + 1.3 * alpha)
}

/// Factor N of a cone of the apex angle β [rad] whose shoulder lies `depth` diameters below the ground: V/(A
/// s_u0), s_u0 the strength at the shoulder, without the weight of the soil; `growth` is k D/s_u0.
///
/// Source: Houlsby & Martin (2003), Géotechnique 53(5), 513–520, their fit to lower bounds for β of 60° to
/// 180°, depths to 2.5 D and growths to 5; the formula is as a published leg penetration analysis has it. At
/// the surface a smooth flat base has the exact 5.69; a rough one is 5 % above the exact 6.05.
///
/// # Errors
/// If the angle is not within 30° to 180°, or another input out of range.
pub fn conical_factor(apex: f64, depth: f64, growth: f64, roughness: f64) -> ModelResult<f64> {
    let beta = within("cone angle [rad]", apex, 30_f64.to_radians(), PI)?;
    let depth = non_negative("depth over diameter", depth)?;
    let growth = within("k D/s_u", growth, 0.0, 5.0)?;
    let alpha = within("roughness", roughness, 0.0, 1.0)?;
    let slope = 1.0 / positive("tangent of half the cone angle", (0.5 * beta).tan())?;
    let uniform = 5.69 * (1.0 - 0.21 * (0.5 * beta).cos()) * (1.0 + depth).powf(0.34);
    // Beyond the range of the fit the growth counts as at its end.
    let growing = 0.5 + 0.36 * slope.powf(1.5) - 0.4 * depth.min(2.5).powi(2);
    let base = (uniform + growing * growth)
        * (1.0 + (0.212 * alpha - 0.097 * alpha * alpha) * (1.0 - 0.53 * depth / (1.0 + depth)));
    Ok(base + alpha * slope * (1.0 + slope * growth / 6.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deep_cones_have_ten_to_eleven_times_the_strength() {
        // Weightless clay, smooth, I_r = 100; Teh & Houlsby (1991): (1.67 + I_r/1500)(1 + ln I_r) + 2.4 α −
        // 1.8 Δ.
        assert!((10.0..11.0).contains(&deep_cone_factor(100.0, 0.0, 0.0).unwrap()));
        for (rigidity, delta, alpha) in
            [(50.0, 0.0, 0.0), (100.0, 0.5, 0.5), (300.0, 0.0, 1.0), (500.0, -0.5, 0.5)]
        {
            let found = deep_cone_factor(rigidity, delta, alpha).unwrap();
            let other = (1.67 + rigidity / 1500.0) * (1.0 + f64::ln(rigidity)) + 2.4 * alpha - 1.8 * delta;
            assert!((found / other - 1.0).abs() < 0.16, "{rigidity}: {found}, {other}");
        }
        assert!(deep_cone_factor(5.0, 0.0, 0.0).is_err() && deep_cone_factor(100.0, 2.0, 0.0).is_err());
    }

    #[test]
    fn shallow_cones_meet_the_exact_factors_of_flat_bases() {
        let flat = |alpha: f64| conical_factor(PI, 0.0, 0.0, alpha).unwrap();
        assert!((flat(0.0) - 5.69).abs() < 1e-9 && (flat(1.0) / 6.05 - 1.0).abs() < 0.05);
        // Sharper and smooth bears less, rough more; strength that grows and depth add.
        let at = |apex: f64, depth, growth, alpha| {
            conical_factor(apex.to_radians(), depth, growth, alpha).unwrap()
        };
        assert!(at(60.0, 0.0, 0.0, 0.0) < flat(0.0) && at(60.0, 0.0, 0.0, 1.0) > flat(1.0));
        assert!(at(120.0, 0.0, 1.0, 0.3) > at(120.0, 0.0, 0.0, 0.3));
        assert!(at(120.0, 1.0, 0.0, 0.3) > at(120.0, 0.0, 0.0, 0.3));
        assert!(conical_factor(0.1, 0.0, 0.0, 0.0).is_err());
    }
}
