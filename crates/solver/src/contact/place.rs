//! Where points of a surface lie in the grid.

use crate::grid::Grid;
use glam::DVec3;

/// Where a point of a surface lies in the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// The cell of the point, in the block.
    pub(super) cell: [usize; 3],
    /// The cell of the point, in the whole grid.
    pub(super) whole: [usize; 3],
    /// The point, moved by round-off into its cell [m].
    pub(super) probe: DVec3,
    /// Linear shape functions of the low and the high node along each axis.
    pub(super) along: [[f64; 2]; 3],
}

impl Place {
    /// Trilinear shape functions of the cell's nodes.
    pub(super) fn shape_functions(&self) -> [f64; 8] {
        trilinear(&self.along)
    }
}

/// Trilinear shape functions of a cell's nodes from the linear ones along each axis.
pub(super) fn trilinear(along: &[[f64; 2]; 3]) -> [f64; 8] {
    std::array::from_fn(|n| along[0][n & 1] * along[1][n >> 1 & 1] * along[2][n >> 2 & 1])
}

/// Where a point of a surface lies, from its position in the grid, its lever arm and its normal; `None`
/// outside the block.
pub(super) fn place(grid: &Grid, in_grid: DVec3, (arm, normal): (DVec3, DVec3)) -> Option<Place> {
    // A point on a face between two cells belongs to the outer one, a point on an edge to the cell nearer
    // to the body's centre, so that mirror images belong to mirror images of cells.
    let probe = in_grid + 1e-9 * grid.finest() * (normal - 0.5 * arm.signum() * (DVec3::ONE - normal.abs()));
    let faces = &grid.faces;
    let cell = [layer(&faces[0], probe.x)?, layer(&faces[1], probe.y)?, layer(&faces[2], probe.z)?];
    let whole = grid.in_whole(cell);
    grid.owns(whole).then(|| Place { cell, whole, probe, along: linear(grid, cell, in_grid) })
}

/// Linear shape functions of the low and the high node along each axis, each from the opposite face:
/// mirroring in y only swaps them.
fn linear(grid: &Grid, cell: [usize; 3], position: DVec3) -> [[f64; 2]; 3] {
    std::array::from_fn(|axis| {
        let (faces, n) = (&grid.faces[axis], cell[axis]);
        let value = |distance: f64| (distance / grid.width(axis, n)).clamp(0.0, 1.0);
        [value(faces[n + 1] - position[axis]), value(position[axis] - faces[n])]
    })
}

/// Layer of the cell that holds a coordinate, if it is inside the grid.
fn layer(faces: &[f64], x: f64) -> Option<usize> {
    let n = faces.partition_point(|face| *face <= x);
    (n >= 1 && n < faces.len()).then(|| n - 1)
}
