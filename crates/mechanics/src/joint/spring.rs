//! A spring with a damper between points of two bodies, and a cable, which only pulls.

use super::{Joint, Row, Rows};
use crate::configuration::Configuration;
use crate::pose::Pose;
use crate::wrench::Wrench;
use glam::DVec3;

/// A spring with a damper, or a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// The bodies, by number; `None` for the ground.
    pub bodies: [Option<usize>; 2],
    /// Ends of the spring in the axes of each body, from its reference point [m]; of the ground, in space.
    pub points: [DVec3; 2],
    /// Force per extension [N/m].
    pub stiffness: f64,
    /// Force per rate of extension [N s/m].
    pub damping: f64,
    /// Length without force [m].
    pub length: f64,
    /// Whether the spring can only pull: a cable.
    pub is_cable: bool,
}

impl Spring {
    /// A spring between two points of space [m], without force at their distance, for bodies at the given
    /// poses; no damping.
    #[must_use]
    pub fn between(ends: [DVec3; 2], bodies: [Option<usize>; 2], poses: [&Pose; 2], stiffness: f64) -> Self {
        let points = [poses[0].point_in_body(ends[0]), poses[1].point_in_body(ends[1])];
        let length = ends[0].distance(ends[1]);
        Self { bodies, points, stiffness, damping: 0.0, length, is_cable: false }
    }

    /// Extension [m] of the spring where its ends are this far apart [m]; 0 for a slack cable.
    fn extension(&self, distance: f64) -> f64 {
        let extension = distance - self.length;
        if self.is_cable { extension.max(0.0) } else { extension }
    }
}

impl Joint for Spring {
    fn bodies(&self) -> [Option<usize>; 2] {
        self.bodies
    }

    /// The change of the length in a step is Δt J u exactly, and the force that of the mean length. A cable
    /// is slack for a whole step or not at all.
    fn rows(&self, [first, second]: [&Configuration; 2], dt: f64) -> Rows {
        let start = first.point_at_start(self.points[0]) - second.point_at_start(self.points[1]);
        let end = first.point_at_end(self.points[0]) - second.point_at_end(self.points[1]);
        let resistance = 0.5 * self.stiffness * dt + self.damping;
        let distances = start.length() + end.length();
        let mut rows = Rows::default();
        let is_slack = self.is_cable && start.length() <= self.length;
        if is_slack || distances == 0.0 || resistance == 0.0 {
            return rows;
        }
        let along = (start + end) / distances;
        let arms = [first.mean(self.points[0]), second.mean(self.points[1])];
        rows.push(Row {
            wrench: [Wrench::at(arms[0], along), Wrench::at(arms[1], -along)],
            bias: -self.stiffness * (start.length() - self.length) / resistance,
            compliance: 2.0 / (dt * resistance),
        });
        rows
    }

    fn energy(&self, [first, second]: [&Configuration; 2]) -> f64 {
        let distance = first.point_at_start(self.points[0]).distance(second.point_at_start(self.points[1]));
        0.5 * self.stiffness * self.extension(distance).powi(2)
    }
}
