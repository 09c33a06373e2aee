//! The directions in which a body can move: the columns of S, and the twist that is prescribed.

use crate::body::Body;
use crate::gimbal::{Axes, unit_twists};
use crate::twist::Twist;
use glam::DVec3;

/// The free directions of a body: the columns of S.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Directions {
    columns: [Twist; 6],
    number: usize,
}

impl Directions {
    /// The free directions of a body whose rotational freedoms have the given axes. A body that rotates
    /// freely needs none of them.
    pub(crate) fn new(body: &Body, axes: &Axes) -> Self {
        let mut directions = Self::default();
        let axes = if body.rotates_freely() { &DVec3::AXES } else { axes };
        for (n, column) in unit_twists(axes).into_iter().enumerate() {
            if body.motion[n].is_free() {
                directions.columns[directions.number] = column;
                directions.number += 1;
            }
        }
        directions
    }

    /// The columns of S.
    pub(crate) fn columns(&self) -> &[Twist] {
        &self.columns[..self.number]
    }

    /// The twist S v.
    pub(crate) fn sum(&self, speeds: &[f64; 6]) -> Twist {
        self.columns().iter().zip(speeds).fold(Twist::ZERO, |sum, (column, speed)| sum + *speed * *column)
    }
}

/// Twist of the prescribed motions at their speeds; other entries are ignored.
pub(crate) fn driven(body: &Body, speeds: &[f64; 6], axes: &Axes) -> Twist {
    let each = unit_twists(axes).into_iter().zip(speeds).zip(&body.motion);
    let moving = each.filter(|((_, speed), motion)| !motion.is_free() && **speed != 0.0);
    moving.fold(Twist::ZERO, |sum, ((column, speed), _)| sum + *speed * column)
}
