//! A hinge: two bodies share a point and an axis.

use super::{Ball, Joint, Row, Rows, couples};
use crate::configuration::Configuration;
use crate::pose::Pose;
use crate::wrench::Wrench;
use glam::DVec3;

/// A hinge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hinge {
    ball: Ball,
    /// The axis in the first body.
    axis: DVec3,
    /// Two directions of the second body, perpendicular to its axis.
    across: [DVec3; 2],
    /// Torque of friction in the bearing [N m].
    friction: f64,
    /// Torque of a drive on the second body about the axis [N m].
    drive: f64,
}

/// Rate of rotation below which friction in a bearing is viscous, so that it holds a hinge at rest without
/// chatter [rad/s]; chosen: a disc of 0.4 m creeps by 0.2 mm in a second.
const CREEP: f64 = 1e-3;
/// A row cannot state a torque, only one that yields to the rate: by so much of it per rad/s.
const DRIVE_YIELDS: f64 = 1e-9;

impl Hinge {
    /// A hinge with an axis of space through the point of a ball joint, for bodies at the given poses. A zero
    /// axis is taken for y.
    #[must_use]
    pub fn new(ball: Ball, axis: DVec3, poses: [&Pose; 2]) -> Self {
        let axis = axis.try_normalize().unwrap_or(DVec3::Y);
        let (u, v) = axis.any_orthonormal_pair();
        let in_body = |body: usize, vector: DVec3| poses[body].axes().transpose() * vector;
        Self {
            ball,
            axis: in_body(0, axis),
            across: [in_body(1, u), in_body(1, v)],
            friction: 0.0,
            drive: 0.0,
        }
    }

    /// The hinge with friction in its bearing: a torque [N m] against the relative rotation, whatever the
    /// load and the rate.
    #[must_use]
    pub fn with_friction(self, torque: f64) -> Self {
        Self { friction: torque, ..self }
    }

    /// The hinge with a drive, or a brake: a constant torque [N m] of the first body on the second about the
    /// axis.
    #[must_use]
    pub fn with_drive(self, torque: f64) -> Self {
        Self { drive: torque, ..self }
    }

    /// A hinge at a point of space [m] along an axis, for bodies at the given poses; the pose of the ground
    /// is the identity.
    #[must_use]
    pub fn at(point: DVec3, axis: DVec3, bodies: [Option<usize>; 2], poses: [&Pose; 2]) -> Self {
        Self::new(Ball::at(point, bodies, poses), axis, poses)
    }
}

impl Joint for Hinge {
    fn bodies(&self) -> [Option<usize>; 2] {
        self.ball.bodies
    }

    /// The rows of the ball joint, and a · b = 0 for both directions b across. Friction is a damper whose
    /// torque at the rate of the step is that of the bearing; a drive shares its row, since two bodies have
    /// six relative motions.
    fn rows(&self, bodies: [&Configuration; 2], dt: f64) -> Rows {
        let mut rows = self.ball.rows(bodies, dt);
        couples(self.across.map(|across| [self.axis, across]), bodies, dt, &mut rows);
        if self.friction > 0.0 || self.drive != 0.0 {
            let [first, second] = bodies;
            let axis = first.mean(self.axis);
            let rate = (first.turn() - second.turn()).dot(axis) / dt;
            let damping = self.friction / rate.abs().max(CREEP) + DRIVE_YIELDS * self.drive.abs();
            let couple = Wrench::couple(axis);
            rows.push(Row {
                wrench: [couple, -1.0 * couple],
                bias: -self.drive / damping,
                compliance: 2.0 / (dt * damping),
            });
        }
        rows
    }
}
