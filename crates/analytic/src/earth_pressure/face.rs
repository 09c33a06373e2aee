//! The plane face that is pushed into the soil.

use crate::error::{ModelResult, within};
use std::f64::consts::FRAC_PI_2;

/// A plane face, the soil before it and their friction; all angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Friction angle of the soil φ [rad].
    pub friction_angle: f64,
    /// Wall friction angle δ [rad]; positive when the face exerts a downward friction force on the soil.
    pub wall_friction: f64,
    /// Inclination α of the face to the horizontal [rad]; π/2 is a vertical wall.
    pub surface: f64,
    /// Slope β of the ground in front of the face [rad], positive upwards.
    pub backfill: f64,
}

impl Face {
    /// A face from angles in degrees.
    #[must_use]
    pub fn degrees(friction_angle: f64, wall_friction: f64, surface: f64, backfill: f64) -> Self {
        Self {
            friction_angle: friction_angle.to_radians(),
            wall_friction: wall_friction.to_radians(),
            surface: surface.to_radians(),
            backfill: backfill.to_radians(),
        }
    }

    /// Checks that the angles are physical; each method has its own, narrower range.
    ///
    /// # Errors
    /// Unless 0 < φ < 90°, |δ| ≤ φ, 0 ≤ α ≤ 90° and |β| ≤ φ.
    pub fn check(&self) -> ModelResult<()> {
        let phi = within("friction angle [rad]", self.friction_angle, 1e-6, FRAC_PI_2 - 1e-6)?;
        within("wall friction [rad]", self.wall_friction, -phi, phi)?;
        within("surface inclination [rad]", self.surface, 0.0, FRAC_PI_2)?;
        within("backfill [rad]", self.backfill, -phi, phi)?;
        Ok(())
    }

    /// Δ with sin Δ = sin δ / sin φ [rad]: the rotation of the principal stress at the face. For a checked
    /// face only.
    pub(crate) fn mobilisation(&self) -> f64 {
        (self.wall_friction.sin() / self.friction_angle.sin()).clamp(-1.0, 1.0).asin()
    }
}
