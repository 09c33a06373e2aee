//! Why triangles bound no solid.

use glam::DVec3;

/// Why triangles bound no solid. Places are in the coordinates of the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Defect {
    /// There is no triangle, or none with an area.
    Empty,
    /// A coordinate is not a finite number.
    NotFinite {
        /// Number of the point.
        point: usize,
    },
    /// A triangle refers to a point that does not exist.
    NoSuchPoint {
        /// Number of the triangle.
        triangle: usize,
    },
    /// The surface is not closed.
    Open {
        /// Number of edges with one triangle.
        edges: usize,
        /// The middle of one of these edges [m].
        place: DVec3,
    },
    /// The surface is not closed where two sides of it nearly meet.
    Seam {
        /// Number of edges with one triangle.
        edges: usize,
        /// Distance between the sides where it is widest [m].
        width: f64,
        /// A point where the distance is widest [m].
        place: DVec3,
    },
    /// A part without thickness hangs on the surface.
    Sheet {
        /// Number of triangles of the part.
        triangles: usize,
        /// The middle of one of these triangles [m].
        place: DVec3,
    },
    /// More than two triangles share an edge.
    NotManifold {
        /// Number of such edges.
        edges: usize,
        /// Number of triangles at one of these edges.
        triangles: usize,
        /// Middle of the defect [m].
        place: DVec3,
    },
    /// The surface has only one side, like a Möbius strip or a Klein bottle.
    OneSided {
        /// Where the sides meet [m].
        place: DVec3,
    },
    /// Two parts of the surface overlap.
    Overlap {
        /// Where the surface of one part goes through that of the other [m].
        place: DVec3,
    },
    /// The surface goes through itself.
    Crossing {
        /// Where the surface goes through itself [m].
        place: DVec3,
    },
    /// A part lies inside another one, without being a cavity of it.
    Nested {
        /// A point of the part inside [m].
        place: DVec3,
    },
    /// The surface has too many separate parts.
    Scattered {
        /// Number of separate parts.
        shells: usize,
    },
    /// The surface encloses no volume.
    NoVolume,
}
