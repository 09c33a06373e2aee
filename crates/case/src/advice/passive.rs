//! The passive earth pressure that warnings are measured against.

use analytic::earth_pressure::{Face, rankine};
use std::f64::consts::FRAC_PI_2;

/// Rankine's K_p; infinite where the closed form does not accept the angle.
pub(super) fn passive_coefficient(friction_angle: f64) -> f64 {
    let face = Face { friction_angle, wall_friction: 0.0, surface: FRAC_PI_2, backfill: 0.0 };
    // Without friction K_p = 1, which the formula does not cover.
    if friction_angle == 0.0 { 1.0 } else { rankine(&face).unwrap_or(f64::INFINITY) }
}
