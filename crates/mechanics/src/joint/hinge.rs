//! A hinge: two bodies share a point and an axis.

use super::{Ball, CLOSURE, Joint, Row, Rows};
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
}

impl Hinge {
    /// With an axis of space through the point of a ball joint, for bodies at the given poses. A zero axis is taken for y.
    #[must_use]
    pub fn new(ball: Ball, axis: DVec3, poses: [&Pose; 2]) -> Self {
        let axis = axis.try_normalize().unwrap_or(DVec3::Y);
        let (u, v) = axis.any_orthonormal_pair();
        let in_body = |body: usize, vector: DVec3| poses[body].axes().transpose() * vector;
        Self { ball, axis: in_body(0, axis), across: [in_body(1, u), in_body(1, v)] }
    }

    /// At a point of space [m] along an axis, for bodies at the given poses; the pose of the ground is the identity.
    #[must_use]
    pub fn at(point: DVec3, axis: DVec3, bodies: [Option<usize>; 2], poses: [&Pose; 2]) -> Self {
        Self::new(Ball::at(point, bodies, poses), axis, poses)
    }
}

impl Joint for Hinge {
    fn bodies(&self) -> [Option<usize>; 2] {
        self.ball.bodies
    }

    /// Those of the ball joint, and a · b = 0 for both directions b across: its change in a step is
    /// Δt (ω₁ − ω₂) · (ā × b̄) exactly.
    fn rows(&self, bodies: [&Configuration; 2], dt: f64) -> Rows {
        let mut rows = self.ball.rows(bodies, dt);
        let [first, second] = bodies;
        for across in self.across {
            let couple = Wrench::couple(first.mean(self.axis).cross(second.mean(across)));
            let gap = (first.start * self.axis).dot(second.start * across);
            rows.push(Row { wrench: [couple, -1.0 * couple], bias: -CLOSURE * gap / dt, compliance: 0.0 });
        }
        rows
    }
}
