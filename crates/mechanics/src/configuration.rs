//! Where a body is over one step: at the start, at the end, and in the mean.

use crate::cayley;
use crate::inertia::Inertia;
use crate::pose::Pose;
use crate::spatial::SpatialInertia;
use crate::twist::Twist;
use glam::{DMat3, DQuat, DVec3};

/// Position and attitude of a body over one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Configuration {
    /// Reference point at the start of the step [m].
    pub position: DVec3,
    /// Displacement of the reference point in the step [m].
    pub displacement: DVec3,
    /// Axes of the body at the start.
    pub start: DMat3,
    /// Axes of the body at the end.
    pub end: DMat3,
    /// Angular velocity times the step [rad].
    turn: DVec3,
    /// Axes of the body half-way.
    half: DMat3,
}

impl Configuration {
    /// The ground: it does not move.
    pub const GROUND: Self = Self {
        position: DVec3::ZERO,
        displacement: DVec3::ZERO,
        start: DMat3::IDENTITY,
        end: DMat3::IDENTITY,
        turn: DVec3::ZERO,
        half: DMat3::IDENTITY,
    };

    /// The configuration of a body that starts at a pose and moves at a twist for `dt` [s].
    #[must_use]
    pub fn new(pose: &Pose, twist: &Twist, dt: f64) -> Self {
        let turn = dt * twist.angular;
        let rotated = |by: DQuat| DMat3::from_quat((by * pose.rotation).normalize());
        Self {
            position: pose.position,
            displacement: dt * twist.linear,
            start: pose.axes(),
            end: rotated(cayley::rotation(turn)),
            turn,
            half: rotated(cayley::half_rotation(turn)),
        }
    }

    /// Angular velocity times the step [rad].
    #[must_use]
    pub fn turn(&self) -> DVec3 {
        self.turn
    }

    /// A point of the body [m, body axes, from the reference point] at the start of the step, in space [m].
    #[must_use]
    pub fn point_at_start(&self, point: DVec3) -> DVec3 {
        self.position + self.start * point
    }

    /// Place of a point of the body [m] at the end of the step.
    #[must_use]
    pub fn point_at_end(&self, point: DVec3) -> DVec3 {
        self.position + self.displacement + self.end * point
    }

    /// The mean of a body-fixed vector over the step, in space: of a point, its mean arm from the reference
    /// point [m].
    #[must_use]
    pub fn mean(&self, vector: DVec3) -> DVec3 {
        0.5 * (self.start * vector + self.end * vector)
    }

    /// Inertia that relates the mean momentum to the twist of the step. The tensor is that of the attitude
    /// half-way, stretched as mean arms are shrunk.
    pub(crate) fn mean_inertia(&self, inertia: &Inertia) -> SpatialInertia {
        let stretched = cayley::stretch(self.turn) * self.half;
        SpatialInertia {
            mass: inertia.mass,
            arm: self.mean(inertia.centre),
            tensor: stretched * inertia.tensor * stretched.transpose(),
        }
    }
}
