//! A shape rotated about y, such as an inclined plate.

use super::{MassProperties, Mesh, Shape, SurfacePoint, inset_in_frame};
use glam::{DMat3, DVec3};

/// Another shape, rotated about the y axis through its origin.
#[derive(Debug)]
pub struct Rotated {
    shape: Box<dyn Shape>,
    rotation: DMat3,
}

impl Rotated {
    /// `shape` rotated by `angle` [rad], positive in the sense of forward rolling: the top moves towards x.
    #[must_use]
    pub fn new(shape: Box<dyn Shape>, angle: f64) -> Self {
        Self { shape, rotation: DMat3::from_rotation_y(angle) }
    }
}

impl Shape for Rotated {
    fn signed_distance(&self, x: DVec3) -> f64 {
        self.shape.signed_distance(self.rotation.transpose() * x)
    }

    fn extent(&self, direction: DVec3) -> f64 {
        self.shape.extent(self.rotation.transpose() * direction)
    }

    fn mass_properties(&self) -> MassProperties {
        self.shape.mass_properties().rotated(self.rotation)
    }

    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        let spacing = DVec3::splat(spacing.min_element());
        let mut points = self.shape.surface_points(spacing, inset_in_frame(inset, self.rotation));
        for point in &mut points {
            (point.position, point.normal) = (self.rotation * point.position, self.rotation * point.normal);
        }
        points
    }

    fn surface_point_count(&self, spacing: DVec3, inset: DVec3) -> f64 {
        let spacing = DVec3::splat(spacing.min_element());
        self.shape.surface_point_count(spacing, inset_in_frame(inset, self.rotation))
    }

    fn is_revolved(&self) -> bool {
        self.shape.is_revolved()
    }

    fn mesh(&self) -> Mesh {
        let mesh = self.shape.mesh();
        Mesh { points: mesh.points.into_iter().map(|x| self.rotation * x).collect(), ..mesh }
    }
}
