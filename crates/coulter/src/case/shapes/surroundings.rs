//! What a body must fit: the cells of the grid, and the slab of a plane strain case.

use crate::case::problem::Problems;
use crate::case::ranges;
use crate::case::typed::Section;

/// Least number of cells across a body: with fewer, soil fits between its contact points unnoticed.
const MIN_CELLS_ACROSS: f64 = 2.0;

/// What the shape of a body must fit.
#[derive(Clone, Copy)]
pub(in crate::case) struct Surroundings {
    /// Cell size in the fine zone [m].
    pub(in crate::case) cell: f64,
    /// The slab of a plane strain case.
    pub(in crate::case) slab: Option<Slab>,
}

impl Surroundings {
    /// Whether there are enough cells across a body of this width [m], given by a key, to resolve contact; it is refused if
    /// not.
    pub(super) fn resolve(&self, section: &Section, key: &str, width: f64, problems: &mut Problems) -> bool {
        let cells = width / self.cell;
        if cells >= MIN_CELLS_ACROSS * (1.0 - 1e-9) {
            return true;
        }
        let message = format!(
            "only {cells:.2} cells across {}: too few to resolve contact",
            ranges::dotted(section, key)
        );
        let cure = format!(
            "make grid.cell at most {:.4} mm for 2 cells across; 4 or more are advisable",
            1e3 * width / MIN_CELLS_ACROSS
        );
        problems.add(section.location_of(key), message, cure);
        false
    }
}

/// The slab of a plane strain case.
#[derive(Clone, Copy)]
pub(in crate::case) struct Slab {
    /// Its width along y [m].
    pub(in crate::case) width: f64,
    /// Its middle [m].
    pub(in crate::case) middle: f64,
    /// Distance of contact points from sharp edges [m].
    pub(in crate::case) inset: f64,
}

impl Slab {
    /// Width of a body [m]: that of the slab plus the inset of the contact points at both edges, so that the points cover
    /// the slab exactly.
    pub(in crate::case) fn covering_width(&self) -> f64 {
        self.width + 2.0 * self.inset
    }
}
