//! The directions in which a body can move: the columns of S.

use crate::gimbal::{Axes, unit_twists};
use crate::motion::Motion;
use crate::twist::Twist;
use glam::DVec3;

/// The free directions of a body: the columns of S.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Directions {
    columns: [Twist; 6],
    number: usize,
}

impl Directions {
    /// The free directions of a body with these motions, whose rotational freedoms have the given axes. A
    /// body that rotates freely needs none of them.
    pub(crate) fn new(motion: &[Motion; 6], axes: &Axes) -> Self {
        let mut directions = Self::default();
        let axes = if motion[3..].iter().all(Motion::is_free) { &DVec3::AXES } else { axes };
        for (n, column) in unit_twists(axes).into_iter().enumerate() {
            if motion[n].is_free() {
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
