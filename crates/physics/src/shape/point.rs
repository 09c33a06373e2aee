//! Contact points.

use glam::DVec3;

/// An integration point of the contact on the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Position in the body frame [m].
    pub position: DVec3,
    /// Outward unit normal.
    pub normal: DVec3,
    /// Area represented by the point [m²].
    pub area: f64,
}
