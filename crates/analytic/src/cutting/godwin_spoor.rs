//! Godwin and Spoor: side crescents as an effective width of the blade.

use super::{Blade, CuttingForce, wall_friction};
use crate::earth_pressure::{Face, cohesion_coefficient, sokolovskii, surcharge_coefficient};
use crate::error::{ModelResult, within};
use crate::soil::Soil;
use std::f64::consts::FRAC_PI_2;

/// Effective width [m] of a blade of width w and depth d [m] with the rupture distance m d: w + d
/// [m − (m − 1)/3].
///
/// Source: Godwin & Spoor (1977), J. Agric. Eng. Res. 22, 213–228; Godwin & O'Dogherty (2007) (recalled,
/// medium confidence). Valid above the critical depth, below which the soil fails laterally.
#[must_use]
pub fn effective_width(width: f64, depth: f64, rupture_ratio: f64) -> f64 {
    width + depth * (rupture_ratio - (rupture_ratio - 1.0) / 3.0)
}

/// Force on an upright blade: the exact passive pressure of its centre wedge on Godwin & Spoor's effective
/// width.
///
/// P_n = (½ γ d² K_n + c d K_c + q d K_q)(w + d[m − (m−1)/3]), m = r_f/d; the exact coefficients replace the
/// charts of the paper. Source: as [`effective_width`]. Valid for an upright blade (rake 90°), 10° ≤ φ ≤ 50°.
///
/// # Errors
/// If the soil or the blade is out of range.
pub fn godwin_spoor(soil: &Soil, blade: &Blade) -> ModelResult<CuttingForce> {
    soil.check()?;
    blade.check()?;
    within("blade rake [rad]", blade.rake, FRAC_PI_2 - 1e-9, FRAC_PI_2)?;
    let delta = wall_friction(soil);
    let face =
        Face { friction_angle: soil.friction_angle, wall_friction: delta, surface: FRAC_PI_2, backfill: 0.0 };
    let (field, d) = (sokolovskii(&face)?, blade.depth);
    let pressure = 0.5 * soil.unit_weight * d * field.coefficient
        + soil.cohesion * cohesion_coefficient(&face)?
        + blade.surcharge * surcharge_coefficient(&face)?;
    let thrust = pressure * d * effective_width(blade.width, d, field.rupture_ratio);
    Ok(CuttingForce { drag: thrust, vertical: thrust * delta.tan(), reach: field.rupture_ratio * d })
}
