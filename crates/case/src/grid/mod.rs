//! The grid of a case, in SI units.

mod check;
mod fitting;
mod grading;
mod keys;
mod read;
mod usual;

pub(crate) use check::check;
pub(crate) use keys::{FOLLOW, KEYS};
pub(crate) use read::{cells, follow, grid};
pub(crate) use usual::{is_towed, rest, usual};

use glam::DVec3;
use serde::Serialize;
use solver::model::Follow;

/// Cell sizes: uniform inside the fine zone, growing geometrically outside it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Grid {
    /// Cell size h in the fine zone [m]: the smallest width of its cells.
    pub cell: f64,
    /// Widths of the cells in the fine zone along x, y, z over `cell`; one of them is 1.
    pub aspect: DVec3,
    /// Low corner of the fine zone [m].
    pub fine_low: DVec3,
    /// High corner of the fine zone [m].
    pub fine_high: DVec3,
    /// Ratio of a cell's width to its inner neighbour's outside the fine zone (1 = uniform).
    pub growth: f64,
    /// The body that the grid follows, if it does not stand still; the box and the faces are then those at
    /// the start.
    pub follow: Option<Follow>,
    /// Face positions along x, y, z that follow from the above [m].
    pub faces: [Vec<f64>; 3],
}

/// Size and shape of the cells in the fine zone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cells {
    /// The smallest width [m].
    pub(crate) size: f64,
    /// Widths along x, y, z over it.
    pub(crate) aspect: DVec3,
}

impl Grid {
    /// Widths along x, y, z of the cells in the fine zone [m].
    #[must_use]
    pub fn fine_cell(&self) -> DVec3 {
        self.cell * self.aspect
    }
}
