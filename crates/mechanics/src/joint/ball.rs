//! A ball joint: a point of one body stays at a point of the other.

use super::{CLOSURE, Joint, Row, Rows};
use crate::configuration::Configuration;
use crate::pose::Pose;
use crate::wrench::Wrench;
use glam::DVec3;

/// A ball joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// The bodies, by number; `None` for the ground.
    pub bodies: [Option<usize>; 2],
    /// The point in the axes of each body, from its reference point [m]; of the ground, in space.
    pub points: [DVec3; 2],
}

impl Ball {
    /// A ball joint at a point of space [m], for bodies at the given poses; the pose of the ground is the
    /// identity.
    #[must_use]
    pub fn at(point: DVec3, bodies: [Option<usize>; 2], poses: [&Pose; 2]) -> Self {
        Self { bodies, points: poses.map(|pose| pose.point_in_body(point)) }
    }
}

impl Joint for Ball {
    fn bodies(&self) -> [Option<usize>; 2] {
        self.bodies
    }

    /// u₁ + ω₁ × r̄₁ = u₂ + ω₂ × r̄₂, along x, y and z.
    fn rows(&self, [first, second]: [&Configuration; 2], dt: f64) -> Rows {
        let arms = [first.mean(self.points[0]), second.mean(self.points[1])];
        let gap = first.point_at_start(self.points[0]) - second.point_at_start(self.points[1]);
        let mut rows = Rows::default();
        for axis in DVec3::AXES {
            rows.push(Row {
                wrench: [Wrench::at(arms[0], axis), Wrench::at(arms[1], -axis)],
                bias: -CLOSURE * gap.dot(axis) / dt,
                compliance: 0.0,
            });
        }
        rows
    }
}
