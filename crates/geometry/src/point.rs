//! Contact points.

use glam::DVec3;

/// An integration point of the contact on the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Position in the body frame [m].
    pub position: DVec3,
    /// Outward unit normal.
    pub normal: DVec3,
    /// Area of the surface round the point [m²].
    pub area: f64,
    /// Area round the point and its share of what lies within the inset of the edges of its face and has no
    /// points [m²]: over the points of a face they add up to the face.
    pub represents: f64,
}
