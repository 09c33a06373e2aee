//! The 6×6 inertia of a body about its reference point, in axes of space, by its blocks.

use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::{DMat3, DVec3};

/// Inertia about the reference point: maps a twist to momentum and angular momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SpatialInertia {
    /// Mass [kg].
    pub(crate) mass: f64,
    /// Centre of mass, from the reference point [m].
    pub(crate) arm: DVec3,
    /// Tensor about the centre of mass [kg m²].
    pub(crate) tensor: DMat3,
}

impl SpatialInertia {
    /// Momentum [N s] and angular momentum about the reference point [N m s] of a twist.
    pub(crate) fn momentum(&self, twist: &Twist) -> Wrench {
        let force = self.mass * twist.at(self.arm);
        Wrench { force, moment: self.tensor * twist.angular + self.arm.cross(force) }
    }
}
