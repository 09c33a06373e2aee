//! EN 1997-1 Annex C: the stress field of weightless soil under sloping ground.

use super::Face;
use crate::error::{ModelResult, finite, undefined};
use std::f64::consts::FRAC_PI_2;

/// The coefficient K_n of EN 1997-1 C.2, from which K_γ and K_q follow.
fn rotation_coefficient(face: &Face) -> ModelResult<f64> {
    face.check()?;
    let (phi, delta, beta) = (face.friction_angle, face.wall_friction, face.backfill);
    // A vertical load is inclined to the normal of the slope by the slope angle.
    let load = beta;
    let arc_cosine = |sine: f64| sine.clamp(-1.0, 1.0).acos();
    let ground = 0.5 * (arc_cosine(-load.sin() / phi.sin()) - phi - load);
    let wall = 0.5 * (arc_cosine(delta.sin() / phi.sin()) - phi - delta);
    let tilt = face.surface - FRAC_PI_2;
    let fan = ground + beta - wall - tilt;
    if fan < -1e-12 {
        return undefined(
            "the EN 1997-1 coefficient",
            "the stress field would need a discontinuity (δ < 0 on a steep face)",
        );
    }
    let ratio = (1.0 + phi.sin() * (2.0 * wall + phi).sin()) / (1.0 - phi.sin() * (2.0 * ground + phi).sin());
    finite("the EN 1997-1 coefficient", ratio * (2.0 * fan * phi.tan()).exp())
}

/// EN 1997-1 Annex C's normal passive coefficient of soil weight, K_γ = K_n cos β cos(β − θ), with θ = α −
/// 90°.
///
/// 2m_t = arccos(−sin β₀ / sin φ) − φ − β₀, 2m_w = arccos(sin δ / sin φ) − φ − δ, v = m_t + β − m_w − θ,
/// K_n = (1 + sin φ sin(2m_w + φ)) / (1 − sin φ sin(2m_t + φ)) · e^{2 v tan φ}, with β₀ = β for a vertical
/// load. Source: EN 1997-1:2004, Annex C.2 (recalled, not re-read; its level-ground case equals
/// Lancellotta's). The weight enters as overburden at the depth of each point: an underestimate, by a third
/// and more for an overhanging face.
///
/// # Errors
/// If the angle of the fan would be negative or the angles are not physical.
pub fn eurocode(face: &Face) -> ModelResult<f64> {
    let overburden = face.backfill.cos() * (face.backfill - (face.surface - FRAC_PI_2)).cos();
    if overburden < 1e-12 {
        return undefined(
            "the EN 1997-1 coefficient",
            "there is no soil above a face that is flatter than the ground before it",
        );
    }
    Ok(rotation_coefficient(face)? * overburden)
}

/// EN 1997-1 Annex C's normal coefficient of a uniform vertical surcharge on the slope, K_q = K_n cos²β.
///
/// Source and validity: see [`eurocode`].
///
/// # Errors
/// If the angle of the fan would be negative or the angles are not physical.
pub fn eurocode_surcharge(face: &Face) -> ModelResult<f64> {
    Ok(rotation_coefficient(face)? * face.backfill.cos().powi(2))
}
