//! A slider: one body moves along an axis of another, without rotating against it.

use super::{CLOSURE, Joint, Row, Rows, couples};
use crate::configuration::Configuration;
use crate::pose::Pose;
use crate::wrench::Wrench;
use glam::DVec3;

/// A slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    bodies: [Option<usize>; 2],
    /// A point of the axis in each body, from its reference point [m]; of the ground, in space.
    points: [DVec3; 2],
    /// Axis, and the two directions across it, in each body.
    frames: [[DVec3; 3]; 2],
}

impl Slider {
    /// Through a point of space [m] along an axis, for bodies at the given poses; the pose of the ground is
    /// the identity. A zero axis is taken for z.
    #[must_use]
    pub fn at(point: DVec3, axis: DVec3, bodies: [Option<usize>; 2], poses: [&Pose; 2]) -> Self {
        let axis = axis.try_normalize().unwrap_or(DVec3::Z);
        let (u, v) = axis.any_orthonormal_pair();
        let frames = poses.map(|pose| [axis, u, v].map(|vector| pose.axes().transpose() * vector));
        Self { bodies, points: poses.map(|pose| pose.point_in_body(point)), frames }
    }
}

impl Joint for Slider {
    fn bodies(&self) -> [Option<usize>; 2] {
        self.bodies
    }

    /// d · n = 0 for the offset d of the second body's point from the first's and both directions n across
    /// the axis, which the first body carries: its change in a step is Δt (Δu · n̄ + ω₁ · (n̄ × d̄)) exactly.
    /// And no relative rotation.
    fn rows(&self, [first, second]: [&Configuration; 2], dt: f64) -> Rows {
        let start = second.point_at_start(self.points[1]) - first.point_at_start(self.points[0]);
        let end = second.point_at_end(self.points[1]) - first.point_at_end(self.points[0]);
        let arms = [first.mean(self.points[0]), second.mean(self.points[1])];
        let mut rows = Rows::default();
        for across in &self.frames[0][1..] {
            let mean = first.mean(*across);
            let carried = Wrench::couple(mean.cross(0.5 * (start + end)));
            let gap = start.dot(first.start * *across);
            rows.push(Row {
                wrench: [carried - Wrench::at(arms[0], mean), Wrench::at(arms[1], mean)],
                bias: -CLOSURE * gap / dt,
                compliance: 0.0,
            });
        }
        let [a, b] = self.frames;
        couples([[a[0], b[1]], [a[1], b[2]], [a[2], b[0]]], [first, second], dt, &mut rows);
        rows
    }
}
