//! How many cells there are across a body, and how far its contact points keep from its edges.

use super::resolved::Case;
use super::rigid_body::Body;
use super::shapes::{Shape, Size};
use glam::DVec3;

/// Cells across each of the least sizes of a shape, one for each key, in a grid whose fine cells have the
/// widths `cell` [m]; of a slab of plane strain without its width, which is one cell whatever the body.
pub(super) fn cells_across(shape: &Shape, (cell, plane_strain): (DVec3, bool)) -> Vec<(Size, f64)> {
    let sizes: Vec<_> = shape.sizes().into_iter().filter(|s| !(plane_strain && s.axis == Some(1))).collect();
    let narrowest =
        |key| sizes.iter().filter(|s| s.key == key).map(|s| s.length).fold(f64::INFINITY, f64::min);
    // A length along several axes may lie along the widest cells.
    let widest = if plane_strain { cell.x.max(cell.z) } else { cell.max_element() };
    let cells = |size: &Size| size.length / size.axis.map_or(widest, |axis| cell[axis]);
    let least = sizes.iter().filter(|size| size.length == narrowest(size.key));
    least.map(|size| (*size, cells(size))).collect()
}

/// The inset that a thin body reduces, in cell widths, and the portion of its thickness to which it does:
/// four fifths of a thin rim keep contact points. With a quarter a flat disc of one cell found 42 % of its
/// drag on four, with four fifths 108 % (docs/studies/thin-bodies.md).
const USUAL: f64 = 0.5;
const MOST: f64 = 0.1;

impl Case {
    /// Distance between the contact points of a body and its sharp edges, along each of its axes [cell
    /// widths]. Half a cell from both edges would leave a thin rim few points or none; a larger inset that
    /// was asked for stays as it is.
    #[must_use]
    pub fn edge_inset(&self, body: &Body) -> DVec3 {
        let inset = DVec3::splat(self.numerics.edge_inset);
        if self.numerics.edge_inset > USUAL {
            return inset;
        }
        let grid = (self.grid.fine_cell(), self.domain.plane_strain);
        let thinnest = |shape: &Shape| {
            // A frame has no surface.
            let mut across = if shape.sizes().is_empty() { DVec3::ZERO } else { DVec3::INFINITY };
            for (size, cells) in cells_across(shape, grid) {
                for axis in (0..3).filter(|axis| size.axis.is_none_or(|along| along == *axis)) {
                    across[axis] = across[axis].min(cells);
                }
            }
            across
        };
        // Parts may lie side by side and be one: then together.
        let parts = body.parts.iter().map(|part| thinnest(&part.shape));
        inset.min(MOST * parts.fold(thinnest(&body.shape), |sum, part| sum + part))
    }
}
