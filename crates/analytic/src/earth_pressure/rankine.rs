//! Rankine: a half-space at failure.

use super::Face;
use crate::error::{ModelResult, undefined};
use std::f64::consts::FRAC_PI_2;

/// Rankine's normal passive coefficient K_n of a vertical face, thrust parallel to the ground.
///
/// K_p = cos β (cos β + √(cos²β − cos²φ)) / (cos β − √(cos²β − cos²φ)), K_n = K_p cos β.
/// Source: Rankine (1857), as in any soil mechanics text (recalled, not re-read). For β = 0 it is tan²(45° +
/// φ/2). Valid for a vertical face, |β| ≤ φ; without wall friction: δ is not used.
///
/// # Errors
/// If the face is not vertical or the angles are not physical.
pub fn rankine(face: &Face) -> ModelResult<f64> {
    face.check()?;
    if (face.surface - FRAC_PI_2).abs() > 1e-9 {
        return undefined("Rankine's coefficient", "it is for a vertical face only");
    }
    let (phi, beta) = (face.friction_angle, face.backfill);
    let root = (beta.cos().powi(2) - phi.cos().powi(2)).max(0.0).sqrt();
    Ok(beta.cos().powi(2) * (beta.cos() + root) / (beta.cos() - root))
}
