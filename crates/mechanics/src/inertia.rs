//! Mass, centre of mass and inertia tensor of a body.

use crate::error::Invalid;
use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

/// Mass properties of a whole body, in its own axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Inertia {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass, from the reference point [m].
    pub centre: DVec3,
    /// Inertia tensor about the centre of mass [kg m²].
    pub tensor: DMat3,
}

impl Inertia {
    /// No mass: for a body all of whose motions are fixed or prescribed.
    pub const NONE: Self = Self { mass: 0.0, centre: DVec3::ZERO, tensor: DMat3::ZERO };

    /// Inertia of a mass [kg] and principal moments [kg m²] along the body's axes; the centre of mass is the
    /// reference point.
    #[must_use]
    pub fn principal(mass: f64, moments: DVec3) -> Self {
        Self { mass, centre: DVec3::ZERO, tensor: DMat3::from_diagonal(moments) }
    }

    /// Inertia of a solid sphere of a mass [kg] and radius [m].
    #[must_use]
    pub fn sphere(mass: f64, radius: f64) -> Self {
        Self::principal(mass, DVec3::splat(0.4 * mass * radius * radius))
    }

    /// Inertia of a solid box of a mass [kg] and edges [m].
    #[must_use]
    pub fn cuboid(mass: f64, edges: DVec3) -> Self {
        let s = edges * edges;
        Self::principal(mass, mass / 12.0 * DVec3::new(s.y + s.z, s.z + s.x, s.x + s.y))
    }

    /// Inertia of a solid disc or cylinder of a mass [kg], radius [m] and thickness along its axle, the
    /// body's y [m].
    #[must_use]
    pub fn disc(mass: f64, radius: f64, thickness: f64) -> Self {
        let across = mass / 12.0 * (3.0 * radius * radius + thickness * thickness);
        Self::principal(mass, DVec3::new(across, 0.5 * mass * radius * radius, across))
    }

    /// The inertia with the centre of mass elsewhere [m, from the reference point].
    #[must_use]
    pub fn with_centre(self, centre: DVec3) -> Self {
        Self { centre, ..self }
    }

    /// Inverse of the tensor [1/(kg m²)]; zero where there is none.
    #[must_use]
    pub fn inverse_tensor(&self) -> DMat3 {
        if self.tensor.determinant() > 0.0 { self.tensor.inverse() } else { DMat3::ZERO }
    }

    /// Whether a solid of these mass properties can exist.
    ///
    /// # Errors
    /// [`Invalid`] unless the mass is positive, the tensor symmetric and positive, and its principal moments
    /// satisfy the triangle inequality: the matrix of second moments ½ tr(I) 1 − I must not have negative
    /// principal values.
    pub fn check(&self) -> Result<(), Invalid> {
        if !(self.mass > 0.0 && self.mass.is_finite() && self.centre.is_finite()) {
            return Err(Invalid::Mass);
        }
        let t = self.tensor;
        let size = t.x_axis.x + t.y_axis.y + t.z_axis.z;
        let is_symmetric = t.abs_diff_eq(t.transpose(), 1e-12 * size);
        if !(size.is_finite() && is_symmetric && is_positive(t, 0.0)) {
            return Err(Invalid::Tensor);
        }
        let second = DMat3::from_diagonal(DVec3::splat(0.5 * size)) - t;
        if is_positive(second, 1e-9 * size) { Ok(()) } else { Err(Invalid::Triangle) }
    }
}

/// Whether a symmetric matrix, with `slack` added to its principal values, is positive definite: its leading
/// minors are positive.
fn is_positive(m: DMat3, slack: f64) -> bool {
    let m = m + DMat3::from_diagonal(DVec3::splat(slack));
    let minor = m.x_axis.x * m.y_axis.y - m.x_axis.y * m.y_axis.x;
    m.x_axis.x > 0.0 && minor > 0.0 && m.determinant() > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solids_exist_and_impossible_tensors_do_not() {
        let moments = |x, y, z| Inertia::principal(1.0, DVec3::new(x, y, z));
        assert_eq!(Inertia::cuboid(2.0, DVec3::new(1.0, 0.1, 3.0)).check(), Ok(()));
        assert_eq!(moments(1.0, 1.0, 2.0).check(), Ok(()), "a thin plate");
        assert_eq!(moments(1.0, 1.0, 2.1).check(), Err(Invalid::Triangle));
        assert_eq!(moments(1.0, -1.0, 1.0).check(), Err(Invalid::Tensor));
        assert_eq!(Inertia { mass: f64::NAN, ..moments(1.0, 1.0, 1.0) }.check(), Err(Invalid::Mass));
    }
}
