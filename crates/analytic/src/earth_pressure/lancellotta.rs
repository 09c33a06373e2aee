//! Lancellotta: the exact stress field of weightless soil under a surcharge, applied to soil with weight.

use super::Face;
use crate::error::{ModelResult, finite, undefined};
use std::f64::consts::FRAC_PI_2;

/// Normal coefficient K_q of a uniform surcharge on level ground: σ_n = q K_q on the face; exact for
/// weightless soil.
///
/// With sin Δ = sin δ / sin φ and the angle of the fan ν = 90° − α + ½(δ+Δ):
/// K_q = (1 + sin φ cos(δ+Δ)) / (1 − sin φ) · e^{2 ν tan φ}.
/// Source: Lancellotta (2002), Géotechnique 52(8), 617–619, for α = 90°; its extension to an inclined face
/// equals EN 1997-1 Annex C for level ground. Valid for |δ| ≤ φ and ν ≥ 0. K_q(α = 0, δ = 0) = N_q.
///
/// # Errors
/// If the ground is not level, if ν would be negative, or if the angles are not physical.
pub fn surcharge_coefficient(face: &Face) -> ModelResult<f64> {
    face.check()?;
    if face.backfill.abs() > 1e-12 {
        return undefined("Lancellotta's coefficient", "it is for level ground; for a slope see EN 1997-1");
    }
    let (phi, sum) = (face.friction_angle, face.wall_friction + face.mobilisation());
    let fan = FRAC_PI_2 - face.surface + 0.5 * sum;
    if fan < -1e-12 {
        return undefined(
            "Lancellotta's coefficient",
            "the stress field would need a discontinuity (δ < 0 on a steep face)",
        );
    }
    let ratio = (1.0 + phi.sin() * sum.cos()) / (1.0 - phi.sin());
    finite("Lancellotta's coefficient", ratio * (2.0 * fan * phi.tan()).exp())
}

/// Lancellotta's normal coefficient K_n of soil with weight: [`surcharge_coefficient`] of a vertical face, a
/// lower bound.
///
/// On an inclined face the overburden at the distance r along it is γ r sin α, so K_n = K_q sin α: too low by
/// a third and more for an overhanging face, where most of the resistance is due to the weight below the
/// edge.
///
/// # Errors
/// As [`surcharge_coefficient`].
pub fn lancellotta(face: &Face) -> ModelResult<f64> {
    Ok(surcharge_coefficient(face)? * face.surface.sin())
}

/// Normal coefficient K_c = (K_q − 1) cot φ of cohesion: σ_n = c K_c, by Caquot's theorem of corresponding
/// states.
///
/// # Errors
/// As [`surcharge_coefficient`].
pub fn cohesion_coefficient(face: &Face) -> ModelResult<f64> {
    Ok((surcharge_coefficient(face)? - 1.0) / face.friction_angle.tan())
}
