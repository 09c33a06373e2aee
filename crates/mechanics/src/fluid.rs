//! The fluid at rest that a body moves in: buoyancy and drag.

use crate::wrench::Wrench;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What the fluid round a body does to it. The whole body is in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Fluid {
    /// Mass of the fluid that the body displaces [kg], whose weight lifts the body (Archimedes).
    pub displaced: f64,
    /// Centre of the displaced volume, from the reference point [m].
    pub centre: DVec3,
    /// Drag over the square of the speed, ½ρC_dA [kg/m].
    pub drag: f64,
}

impl Fluid {
    /// No fluid.
    pub const NONE: Self = Self { displaced: 0.0, centre: DVec3::ZERO, drag: 0.0 };

    /// Drag on the body when the centre of its volume has a velocity [m/s]: ½ρC_dA v² against it [N].
    #[must_use]
    pub fn drag(&self, velocity: DVec3) -> DVec3 {
        -self.drag * velocity.length() * velocity
    }

    /// Impulse of buoyancy in a time `dt` [s] under gravity [m/s²], with the centre of the volume at `arm`
    /// from the reference point [m].
    pub(crate) fn buoyancy(&self, arm: DVec3, dt: f64, gravity: DVec3) -> Wrench {
        Wrench::at(arm, -self.displaced * dt * gravity)
    }
}
