//! Volume, centroid and moments of inertia of a homogeneous solid.

use super::mesh::Mesh;
use glam::{DMat3, DVec3};

/// Mass properties of a homogeneous solid, in the body frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// Volume [m³].
    pub volume: f64,
    /// Centroid [m].
    pub centroid: DVec3,
    /// Inertia tensor about the centroid, per mass [m²].
    pub inertia: DMat3,
}

impl MassProperties {
    /// Mass properties of a solid with the centroid at the origin and its principal axes along x, y, z, about
    /// which the moments of inertia per mass [m²] are given.
    pub(super) fn principal(volume: f64, inertia: DVec3) -> Self {
        Self { volume, centroid: DVec3::ZERO, inertia: DMat3::from_diagonal(inertia) }
    }

    /// Mass properties of the solid that a closed triangle mesh bounds: sums over the tetrahedra between its
    /// triangles and the origin (Tonon 2004).
    #[must_use]
    pub fn of_mesh(mesh: &Mesh) -> Self {
        let (mut volume, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle.map(|n| mesh.points[n as usize]);
            let own = a.dot(b.cross(c)) / 6.0;
            let sum = a + b + c;
            volume += own;
            first += 0.25 * own * sum;
            // ∫ x xᵀ over a tetrahedron with a corner at the origin.
            let moments = [a, b, c, sum].map(|x| outer(x, x)).into_iter().fold(DMat3::ZERO, |m, x| m + x);
            second += 0.05 * own * moments;
        }
        let centroid = first / volume;
        let second = second * (1.0 / volume) - outer(centroid, centroid);
        let trace = second.x_axis.x + second.y_axis.y + second.z_axis.z;
        Self { volume, centroid, inertia: DMat3::IDENTITY * trace - second }
    }

    /// Mass properties of the solid rotated about the origin.
    pub(super) fn rotated(&self, rotation: DMat3) -> Self {
        Self {
            volume: self.volume,
            centroid: rotation * self.centroid,
            inertia: rotation * self.inertia * rotation.transpose(),
        }
    }

    /// Mass properties of the solid moved [m].
    pub(super) fn moved(&self, by: DVec3) -> Self {
        Self { centroid: self.centroid + by, ..*self }
    }

    /// Mass properties of several solids of one density together.
    pub(super) fn sum(solids: impl Iterator<Item = Self>) -> Self {
        let solids: Vec<Self> = solids.collect();
        let volume: f64 = solids.iter().map(|solid| solid.volume).sum();
        let centroid = solids.iter().map(|solid| solid.volume * solid.centroid).sum::<DVec3>() / volume;
        let about = |solid: &Self| {
            let arm = solid.centroid - centroid;
            (solid.inertia + DMat3::IDENTITY * arm.length_squared() - outer(arm, arm))
                * (solid.volume / volume)
        };
        Self { volume, centroid, inertia: solids.iter().map(about).fold(DMat3::ZERO, |sum, own| sum + own) }
    }

    /// Moment of inertia per mass about the body's y axis, the axle [m²].
    #[must_use]
    pub fn about_axle(&self) -> f64 {
        self.inertia.y_axis.y + self.centroid.x.powi(2) + self.centroid.z.powi(2)
    }
}

/// a bᵀ.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
