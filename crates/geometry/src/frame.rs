//! A frame: a body without a surface, such as the beam that carries discs above the ground.

use super::{MassProperties, Mesh, Shape, SurfacePoint};
use glam::DVec3;

/// A body without a surface or a volume: a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame;

impl Shape for Frame {
    /// Distance of a point so far away that no cell is near it [m].
    fn signed_distance(&self, _x: DVec3) -> f64 {
        f64::MAX
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        (DVec3::ZERO, DVec3::ZERO)
    }

    fn extent(&self, _direction: DVec3) -> f64 {
        0.0
    }

    fn mass_properties(&self) -> MassProperties {
        MassProperties::principal(0.0, DVec3::ZERO)
    }

    fn surface_points(&self, _spacing: DVec3, _inset: DVec3) -> Vec<SurfacePoint> {
        Vec::new()
    }

    fn surface_point_count(&self, _spacing: DVec3, _inset: DVec3) -> f64 {
        0.0
    }

    fn has_surface(&self) -> bool {
        false
    }

    fn is_revolved(&self) -> bool {
        true
    }

    fn mesh(&self) -> Mesh {
        Mesh { points: Vec::new(), triangles: Vec::new() }
    }
}
