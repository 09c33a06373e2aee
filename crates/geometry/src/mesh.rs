//! A triangle mesh.

use glam::DVec3;

/// A triangle mesh: for graphics, and for the mass properties of a shape without closed forms.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Points in the body frame [m].
    pub points: Vec<DVec3>,
    /// Point indices of each triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}
