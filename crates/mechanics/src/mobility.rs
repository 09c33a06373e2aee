//! How a body responds to an impulse: W = S (Sᵀ M S)⁻¹ Sᵀ.

use crate::cayley::outer;
use crate::freedom::Directions;
use crate::spatial::SpatialInertia;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::{DMat3, DVec3};
use numerics::semidefinite;

/// Mobility of a body: the symmetric 6×6 matrix that maps an impulse about the reference point to the change
/// of the twist.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mobility {
    /// Velocity per impulse [1/kg].
    pub linear: DMat3,
    /// Velocity per angular impulse [1/(kg m)]; its transpose is angular velocity per impulse.
    pub coupling: DMat3,
    /// Angular velocity per angular impulse [1/(kg m²)].
    pub angular: DMat3,
}

impl Mobility {
    /// Mobility of an inertia M in the free directions S.
    pub(crate) fn new(inertia: &SpatialInertia, free: &Directions) -> Self {
        let columns = free.columns();
        let n = columns.len();
        let mut matrix = [0.0; 36];
        for (j, column) in columns.iter().enumerate() {
            let momentum = inertia.momentum(column);
            for (i, row) in columns.iter().enumerate() {
                matrix[i * n + j] = momentum.dot(row);
            }
        }
        semidefinite::factor(&mut matrix[..n * n], n);
        let mut mobility = Self { linear: DMat3::ZERO, coupling: DMat3::ZERO, angular: DMat3::ZERO };
        for (j, column) in columns.iter().enumerate() {
            let mut response = [0.0; 6];
            response[j] = 1.0;
            semidefinite::solve(&matrix[..n * n], &mut response[..n]);
            let twist = free.sum(&response);
            mobility.linear += outer(twist.linear, column.linear);
            mobility.coupling += outer(twist.linear, column.angular);
            mobility.angular += outer(twist.angular, column.angular);
        }
        mobility
    }

    /// Change of the twist by an impulse.
    #[must_use]
    #[inline]
    pub fn response(&self, impulse: &Wrench) -> Twist {
        let Wrench { force, moment } = *impulse;
        let c = &self.coupling;
        let coupled = DVec3::new(c.x_axis.dot(force), c.y_axis.dot(force), c.z_axis.dot(force));
        Twist {
            linear: self.linear * force + self.coupling * moment,
            angular: coupled + self.angular * moment,
        }
    }

    /// Change of the velocity of the point at `arm` [m] per impulse there [1/kg]: the body's block of the
    /// Delassus operator.
    #[must_use]
    pub fn at(&self, arm: DVec3) -> DMat3 {
        let cross = DMat3::from_cols(
            DVec3::new(0.0, arm.z, -arm.y),
            DVec3::new(-arm.z, 0.0, arm.x),
            DVec3::new(arm.y, -arm.x, 0.0),
        );
        let half = self.coupling * cross;
        self.linear + half + half.transpose() - cross * self.angular * cross
    }

    /// Response along a unit vector to a unit impulse along it [1/kg]; its inverse is the effective mass.
    #[must_use]
    pub fn along(&self, arm: DVec3, direction: DVec3) -> f64 {
        let impulse = Wrench::at(arm, direction);
        impulse.dot(&self.response(&impulse))
    }
}
