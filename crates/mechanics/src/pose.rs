//! Where a body is and how it is turned.

use crate::cayley;
use crate::twist::Twist;
use glam::{DMat3, DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// Position and attitude of a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Reference point [m].
    pub position: DVec3,
    /// Rotation from the body's axes to those of space; a unit quaternion.
    pub rotation: DQuat,
}

impl Pose {
    /// The body's axes are those of space, its reference point their origin.
    pub const IDENTITY: Self = Self { position: DVec3::ZERO, rotation: DQuat::IDENTITY };

    /// A body that is not turned, with its reference point at `position` [m].
    #[must_use]
    pub fn at(position: DVec3) -> Self {
        Self { position, ..Self::IDENTITY }
    }

    /// Rotation of the body as a matrix; the columns are the body's axes in space.
    #[must_use]
    pub fn axes(&self) -> DMat3 {
        DMat3::from_quat(self.rotation)
    }

    /// A point of the body [m, body axes, from the reference point] in space [m].
    #[must_use]
    pub fn point(&self, point: DVec3) -> DVec3 {
        self.position + self.axes() * point
    }

    /// A point of space [m] in the body's axes [m, from the reference point].
    #[must_use]
    pub fn point_in_body(&self, point: DVec3) -> DVec3 {
        self.axes().transpose() * (point - self.position)
    }

    /// The pose after a step of `dt` [s] at a constant twist; the rotation follows from the Cayley map.
    #[must_use]
    pub fn moved(&self, twist: &Twist, dt: f64) -> Self {
        Self {
            position: self.position + dt * twist.linear,
            rotation: (cayley::rotation(dt * twist.angular) * self.rotation).normalize(),
        }
    }
}

impl Default for Pose {
    fn default() -> Self {
        Self::IDENTITY
    }
}
