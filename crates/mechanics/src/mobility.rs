//! How a body responds to an impulse: W = S (Sᵀ M S)⁻¹ Sᵀ.

use crate::cayley::outer;
use crate::freedom::Directions;
use crate::spatial::SpatialInertia;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::{DMat3, DVec3};
use numerics::semidefinite;

/// Difference of entries that should be alike, over the largest.
const SYMMETRIC: f64 = 1e-6;

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

    /// The mobility of these rows: by velocity along x, y, z and angular velocity about them, per impulse
    /// along and angular impulse about them. `None` unless they are symmetric and no impulse is answered
    /// backwards.
    #[must_use]
    pub fn of(rows: &[[f64; 6]; 6]) -> Option<Self> {
        let size = rows.iter().flatten().fold(0.0_f64, |size, entry| size.max(entry.abs()));
        let is_symmetric =
            (0..6).all(|i| (0..i).all(|j| (rows[i][j] - rows[j][i]).abs() <= SYMMETRIC * size));
        if !(size.is_finite() && is_symmetric && semidefinite::is_semidefinite(rows.as_flattened(), 6)) {
            return None;
        }
        let block = |i: usize, j: usize| {
            DMat3::from_cols_array_2d(&std::array::from_fn(|column| {
                std::array::from_fn(|row| 0.5 * (rows[i + row][j + column] + rows[j + column][i + row]))
            }))
        };
        Some(Self { linear: block(0, 0), coupling: block(0, 3), angular: block(3, 3) })
    }

    /// The mobility in a mechanism that does not let the body move along these twists, and what is left of a
    /// change of its twist there: W − W C (Cᵀ W C)⁻¹ Cᵀ W.
    #[must_use]
    pub fn held(&self, along: &[Twist], change: Twist) -> (Self, Twist) {
        let n = along.len();
        // The impulses that hold are about the same axes as the twists.
        let impulses: Vec<Wrench> =
            along.iter().map(|t| Wrench { force: t.linear, moment: t.angular }).collect();
        let answers: Vec<Twist> = impulses.iter().map(|impulse| self.response(impulse)).collect();
        let mut matrix = vec![0.0; n * n];
        for (i, impulse) in impulses.iter().enumerate() {
            for (j, answer) in answers.iter().enumerate() {
                matrix[i * n + j] = impulse.dot(answer);
            }
        }
        semidefinite::factor(&mut matrix, n);
        let hold = |twist: Twist| {
            let mut held: Vec<f64> = impulses.iter().map(|impulse| impulse.dot(&twist)).collect();
            semidefinite::solve(&matrix, &mut held);
            answers.iter().zip(held).fold(twist, |sum, (answer, impulse)| sum - impulse * *answer)
        };
        let column = |n: usize| {
            let unit = DVec3::AXES[n % 3];
            let impulse =
                if n < 3 { Wrench { force: unit, moment: DVec3::ZERO } } else { Wrench::couple(unit) };
            hold(self.response(&impulse))
        };
        let [linear, angular] = [0, 3].map(|first| [0, 1, 2].map(|n| column(first + n)));
        let of = |columns: [DVec3; 3]| DMat3::from_cols(columns[0], columns[1], columns[2]);
        let mobility = Self {
            linear: of(linear.map(|twist| twist.linear)),
            coupling: of(angular.map(|twist| twist.linear)),
            angular: of(angular.map(|twist| twist.angular)),
        };
        (mobility, hold(change))
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
