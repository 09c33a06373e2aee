//! Coulomb: a wedge on a plane slip surface.

use super::Face;
use crate::error::{ModelResult, finite, undefined};
use std::f64::consts::PI;

/// Coulomb's total passive coefficient K_p, for the thrust P = ½ γ H² K_p [N/m] at δ to the normal of the
/// face.
///
/// With a = 180° − α: K_p = sin²(a−φ) / {sin²a sin(a+δ) [1 − √(sin(φ+δ) sin(φ+β) / (sin(a+δ) sin(a+β)))]²}.
/// Source: Coulomb (1776), in the form of Müller-Breslau (1906) (recalled, not re-read).
///
/// **Domain of existence.** A plane wedge exists only while the square root stays below 1; on level ground
/// that is α > φ + δ. The overhanging face of a shallow disc (α = 13° to 39° at 5 % to 40 % sinkage) lies
/// outside this domain, and near its limit the coefficient is 3 to 10 times too large. For δ > 0 the plane
/// wedge is unsafe well within the domain.
///
/// # Errors
/// If no plane wedge exists or the angles are not physical.
pub fn coulomb_total(face: &Face) -> ModelResult<f64> {
    face.check()?;
    let (phi, delta, beta) = (face.friction_angle, face.wall_friction, face.backfill);
    let a = PI - face.surface;
    let (wall, ground) = ((a + delta).sin(), (a + beta).sin());
    let steepness = (phi + delta).sin().max(0.0) * (phi + beta).sin().max(0.0);
    let ratio = steepness / (wall * ground);
    if wall <= 1e-12 || ground <= 1e-12 || ratio >= 1.0 - 1e-9 {
        return undefined("Coulomb's coefficient", no_wedge(face));
    }
    let bracket = (1.0 - ratio.sqrt()).powi(2);
    finite("Coulomb's coefficient", (a - phi).sin().powi(2) / (a.sin().powi(2) * wall * bracket))
}

/// Coulomb's normal passive coefficient K_n = K_p cos δ sin²α; see [`coulomb_total`] for source and domain.
///
/// # Errors
/// If no plane wedge exists or the angles are not physical.
pub fn coulomb(face: &Face) -> ModelResult<f64> {
    Ok(coulomb_total(face)? * face.wall_friction.cos() * face.surface.sin().powi(2))
}

/// Coulomb's total active coefficient of an upright wall under level ground, for the thrust at δ to its
/// normal.
///
/// K_a = cos²φ / {cos δ [1 + √(sin(φ+δ) sin φ / cos δ)]²}, angles in radians. Source: as [`coulomb_total`].
///
/// # Errors
/// Unless 0 < φ < 90° and |δ| ≤ φ.
pub fn coulomb_active(friction_angle: f64, wall_friction: f64) -> ModelResult<f64> {
    let upright = std::f64::consts::FRAC_PI_2;
    Face { friction_angle, wall_friction, surface: upright, backfill: 0.0 }.check()?;
    let (phi, delta) = (friction_angle, wall_friction);
    let root = ((phi + delta).sin() * phi.sin() / delta.cos()).sqrt();
    Ok(phi.cos().powi(2) / (delta.cos() * (1.0 + root).powi(2)))
}

fn no_wedge(face: &Face) -> String {
    let limit = (face.friction_angle + face.wall_friction).to_degrees();
    format!(
        "a plane wedge exists for faces inclined at more than φ + δ = {limit:.1}° (level ground); this one is \
         inclined at {:.1}°, an overhanging face as of a disc",
        face.surface.to_degrees()
    )
}
