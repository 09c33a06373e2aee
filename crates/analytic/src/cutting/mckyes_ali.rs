//! McKyes and Ali: a centre wedge on a plane slip surface with circular side crescents.

use super::{Blade, CuttingForce, wall_friction};
use crate::error::{ModelResult, undefined};
use crate::soil::Soil;
use numerics::search::minimum;
use std::f64::consts::{FRAC_PI_2, PI};

/// Factors of one blade: P = (γ d² N_γ + c d N_c + q d N_q) w, at δ to the blade's normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuttingFactors {
    /// N_γ of the soil weight.
    pub weight: f64,
    /// N_c of the cohesion.
    pub cohesion: f64,
    /// N_q of the surcharge.
    pub surcharge: f64,
    /// Failure angle b to the horizontal [rad].
    pub failure_angle: f64,
    /// Rupture distance over depth r/d.
    pub rupture_ratio: f64,
}

/// Factors of McKyes & Ali for friction φ, wall friction δ, rake ρ [rad] and width over depth w/d.
///
/// r = d (cot ρ + cot b), s = r √(1 − (cot ρ/(cot ρ + cot b))²), D = [cot(ρ+δ) + cot(b+φ)] sin(ρ+δ);
/// N_γ = (r/2d)(1 + 2s/3w)/D, N_q = (r/d)(1 + s/w)/D, N_c = (1 + cot b cot(b+φ))(1 + s/w)/D, where b
/// minimises N_γ. Source: McKyes & Ali (1977), J. Terramech. 14(2), 43–51 (recalled and re-derived). In plane
/// strain it is Coulomb's wedge and overestimates as much (9.96 against the exact 7.77 at φ = 35°, δ = ⅔φ).
/// Valid for 10° ≤ φ ≤ 50°, 10° ≤ ρ ≤ 90°, ρ + δ + b + φ < 180°.
///
/// # Errors
/// If no wedge exists.
pub fn mckyes_ali_factors(
    phi: f64,
    delta: f64,
    rake: f64,
    width_over_depth: f64,
) -> ModelResult<CuttingFactors> {
    let weight = |b: f64| factors(phi, delta, rake, width_over_depth, b).map_or(f64::INFINITY, |f| f.weight);
    let highest = (PI - rake - delta - phi).min(FRAC_PI_2) - 1e-6;
    let (low, steps) = (1e-3, 40);
    if highest <= low {
        return undefined("McKyes and Ali's wedge", "rake and friction leave no wedge");
    }
    let step = (highest - low) / f64::from(steps);
    let scan = (0..=steps).map(|n| low + step * f64::from(n));
    let best =
        scan.fold((low, f64::INFINITY), |best, b| if weight(b) < best.1 { (b, weight(b)) } else { best });
    let (b, _) = minimum((best.0 - step).max(low), (best.0 + step).min(highest), 45, weight);
    match factors(phi, delta, rake, width_over_depth, b) {
        Some(found) => Ok(found),
        None => undefined("McKyes and Ali's wedge", "rake and friction leave no wedge"),
    }
}

fn factors(phi: f64, delta: f64, rake: f64, ratio: f64, b: f64) -> Option<CuttingFactors> {
    let cot = |x: f64| 1.0 / x.tan();
    let reach = cot(rake) + cot(b);
    let side = reach * (1.0 - (cot(rake) / reach).powi(2)).max(0.0).sqrt();
    let divisor = (cot(rake + delta) + cot(b + phi)) * (rake + delta).sin();
    if !(divisor > 1e-9 && reach > 0.0) {
        return None;
    }
    let found = CuttingFactors {
        weight: 0.5 * reach * (1.0 + 2.0 * side / (3.0 * ratio)) / divisor,
        cohesion: (1.0 + cot(b) * cot(b + phi)) * (1.0 + side / ratio) / divisor,
        surcharge: reach * (1.0 + side / ratio) / divisor,
        failure_angle: b,
        rupture_ratio: reach,
    };
    found.weight.is_finite().then_some(found)
}

/// Force on a blade after McKyes & Ali; see [`mckyes_ali_factors`] for equation, source and validity.
///
/// H = P sin(ρ + δ), F_V = −P cos(ρ + δ).
///
/// # Errors
/// If the soil or the blade is out of range, or no wedge exists.
pub fn mckyes_ali(soil: &Soil, blade: &Blade) -> ModelResult<CuttingForce> {
    soil.check()?;
    blade.check()?;
    let (delta, d) = (wall_friction(soil), blade.depth);
    let n = mckyes_ali_factors(soil.friction_angle, delta, blade.rake, blade.width / d)?;
    let pressure =
        soil.unit_weight * d * n.weight + soil.cohesion * n.cohesion + blade.surcharge * n.surcharge;
    let thrust = pressure * d * blade.width;
    let angle = blade.rake + delta;
    // The soil reacts along −P: a blade of low rake is drawn down, a steep rough one pushed up.
    Ok(CuttingForce {
        drag: thrust * angle.sin(),
        vertical: -thrust * angle.cos(),
        reach: n.rupture_ratio * d,
    })
}
