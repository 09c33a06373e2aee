//! How many cells there are across a shape.

use super::Shape;
use super::traits::Size;
use glam::DVec3;

/// The cells in the fine zone of a grid.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FineCells {
    /// Widths of the cells along x, y, z [m].
    pub(crate) widths: DVec3,
    /// Whether the cells are the slab of a plane strain case.
    pub(crate) plane_strain: bool,
}

/// Cells across each of the least sizes of a shape, one for each key, in a grid whose fine cells these
/// are; of a slab of plane strain without its width, which is one cell whatever the body.
pub(crate) fn cells_across(shape: &Shape, cells: FineCells) -> Vec<(Size, f64)> {
    let FineCells { widths: cell, plane_strain } = cells;
    let sizes: Vec<_> = shape.sizes().into_iter().filter(|s| !(plane_strain && s.axis == Some(1))).collect();
    let narrowest =
        |key| sizes.iter().filter(|s| s.key == key).map(|s| s.length).fold(f64::INFINITY, f64::min);
    // A length along several axes may lie along the widest cells.
    let widest = if plane_strain { cell.x.max(cell.z) } else { cell.max_element() };
    let cells = |size: &Size| size.length / size.axis.map_or(widest, |axis| cell[axis]);
    let least = sizes.iter().filter(|size| size.length == narrowest(size.key));
    least.map(|size| (*size, cells(size))).collect()
}
