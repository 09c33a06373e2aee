//! How far the contact points of a body keep from its edges.

use super::body::Body;
use super::resolved::Case;
use super::shapes::{FineCells, Shape, cells_across};
use glam::DVec3;

/// The inset that a thin body reduces, in cell widths, and the portion of its thickness to which it does:
/// four fifths of a thin rim keep contact points. With a quarter a flat disc of one cell found 42 % of its
/// drag on four, with four fifths 108 % (docs/studies/thin-bodies.md).
const USUAL: f64 = 0.5;
const MOST: f64 = 0.1;

impl Case {
    /// The cells in the fine zone.
    pub(crate) fn fine_cells(&self) -> FineCells {
        FineCells { widths: self.grid.fine_cell(), plane_strain: self.domain.plane_strain }
    }

    /// Distance between the contact points of a body and its sharp edges, along each of its axes [cell
    /// widths]. Half a cell from both edges would leave a thin rim few points or none; a larger inset that
    /// was asked for stays as it is.
    #[must_use]
    pub fn edge_inset(&self, body: &Body) -> DVec3 {
        let inset = DVec3::splat(self.numerics.edge_inset);
        if self.numerics.edge_inset > USUAL {
            return inset;
        }
        let thinnest = |shape: &Shape| {
            // A frame has no surface.
            let mut across = if shape.sizes().is_empty() { DVec3::ZERO } else { DVec3::INFINITY };
            for (size, cells) in cells_across(shape, self.fine_cells()) {
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
