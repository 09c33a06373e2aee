//! Edges of a triangle mesh, with the triangles on their sides.

/// A side of an edge: an edge of one triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    /// Lower number of the points of the edge.
    pub(super) low: u32,
    /// Higher number of the points of the edge.
    pub(super) high: u32,
    /// The triangle.
    pub(super) triangle: u32,
    /// The edge goes from this corner of the triangle to the next.
    pub(super) corner: u8,
    /// Whether the triangle goes along the edge from the higher to the lower number.
    pub(super) is_backward: bool,
}

/// The sides of all edges; those of one edge follow each other.
pub(super) fn sides(triangles: &[[u32; 3]]) -> Vec<Side> {
    let mut sides = Vec::with_capacity(3 * triangles.len());
    for (triangle, corners) in triangles.iter().enumerate() {
        for corner in 0..3 {
            let (from, to) = (corners[corner], corners[(corner + 1) % 3]);
            let [low, high] = [from.min(to), from.max(to)];
            let (triangle, corner, is_backward) = (triangle as u32, corner as u8, from > to);
            sides.push(Side { low, high, triangle, corner, is_backward });
        }
    }
    sides.sort_unstable();
    sides
}

/// The sides, edge by edge.
pub(super) fn by_edge(sides: &[Side]) -> impl Iterator<Item = &[Side]> {
    sides.chunk_by(|a, b| (a.low, a.high) == (b.low, b.high))
}

/// The triangle beyond each edge of each triangle; where there is none, or more than one, the triangle
/// itself.
pub(super) fn neighbours(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut beyond: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|n| [n; 3]).collect();
    for edge in by_edge(&sides(triangles)) {
        if let [one, other] = edge {
            beyond[one.triangle as usize][usize::from(one.corner)] = other.triangle;
            beyond[other.triangle as usize][usize::from(other.corner)] = one.triangle;
        }
    }
    beyond
}
