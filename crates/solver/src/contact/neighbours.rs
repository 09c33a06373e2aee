//! Bodies next to each other: where one covers the surface of another, no soil touches it.

use crate::model::{BodyModel, Model};
use crate::state::{Pose, State};
use glam::DVec3;

/// How far a point is moved along its normal before it counts as covered, in cell widths: a face that two
/// bodies share lies on the surface of both.
const BEYOND: f64 = 1e-6;

/// The bodies near to one body.
pub(super) struct Neighbours<'a> {
    near: Vec<(&'a BodyModel, &'a Pose)>,
    /// Distance by which a point is moved along its normal [m].
    beyond: f64,
}

impl<'a> Neighbours<'a> {
    /// Neighbours of body number `n`: the others whose boxes come within a cell of its own.
    pub(super) fn of<R>(model: &'a Model, state: &'a State<R>, n: usize) -> Self {
        let cell = model.grid.finest();
        let (low, high) = model.bodies[n].bounds(state.pose(n));
        let others =
            model.bodies.iter().enumerate().filter(|(m, other)| *m != n && other.shape.has_surface());
        let near = others.map(|(m, other)| (other, state.pose(m))).filter(|(other, pose)| {
            let (from, to) = other.bounds(pose);
            (from - cell).cmplt(high).all() && (to + cell).cmpgt(low).all()
        });
        Self { near: near.collect(), beyond: BEYOND * cell }
    }

    /// Whether one of the neighbours covers a point of the surface [m].
    pub(super) fn cover(&self, point: DVec3, normal: DVec3) -> bool {
        let at = point + self.beyond * normal;
        self.near.iter().any(|(body, pose)| {
            body.shape.signed_distance(body.attitude(pose).inverse() * (at - pose.position)) < 0.0
        })
    }
}
