//! Flow of pore water between the cells: the loops behind [`crate::pore_pressure`].
//!
//! Pressures are those of cells, in double precision whatever the precision of the soil. All sums are taken
//! row by row, then in the order of the rows, so that no bit depends on the number of threads.

mod conductance;
mod rows;
mod solve;

pub(crate) use conductance::find;
pub(crate) use solve::Balance;

use crate::grid::Grid;
use crate::model::Model;

/// Number of arrays over the grid in a workspace.
const ARRAYS: usize = 11;

/// Conductances between the cells, and scratch memory of the conjugate gradients. Arrays cover the grid with
/// its ghosts (see [`Grid::index`]), and are empty where no pore pressure is computed.
#[derive(Debug, Default)]
pub(crate) struct SeepageWorkspace {
    /// Area over distance between each cell and the next one along x, y, z [m]; 0 where no water flows
    /// between the two.
    conductance: [Vec<f64>; 3],
    /// Sum of the conductances of a cell, with those to open water [m]; 0 in cells without a pore pressure of
    /// their own.
    diagonal: Vec<f64>,
    /// Inverse of the diagonal where the pressure is sought [1/m]; 0 elsewhere, and in cells whose water
    /// cavitates.
    inverse: Vec<f64>,
    /// Change of the pressure in a step, times mobility [m²/s].
    change: Vec<f64>,
    /// Water that a cell still takes in beyond what flows to it [m³/s].
    residual: Vec<f64>,
    /// Direction of the search, and what it makes flow out of the cells.
    direction: Vec<f64>,
    product: Vec<f64>,
    /// Fraction of each cell that bodies occupy.
    body_fraction: Vec<f64>,
    /// Rate at which gaps between bodies and the soil of a cell grow [m³/s].
    openings: Vec<f64>,
}

impl SeepageWorkspace {
    /// Workspace for a model; empty for one without pore water.
    pub(crate) fn new(model: &Model) -> Self {
        let zeros = || vec![0.0; if model.pore_water.is_some() { model.grid.entries } else { 0 }];
        Self {
            conductance: std::array::from_fn(|_| zeros()),
            diagonal: zeros(),
            inverse: zeros(),
            change: zeros(),
            residual: zeros(),
            direction: zeros(),
            product: zeros(),
            body_fraction: zeros(),
            openings: zeros(),
        }
    }

    /// Whether a cell has a pore pressure of its own: soil that is not mixed with open water, and connected
    /// to other such soil or to open water.
    pub(crate) fn is_saturated(&self, cell: usize) -> bool {
        self.diagonal[cell] > 0.0
    }

    /// Enters the portions of the cells that bodies occupy: cells and fractions.
    pub(crate) fn set_bodies(&mut self, cells: impl Iterator<Item = (usize, f64)>) {
        self.body_fraction.fill(0.0);
        for (cell, fraction) in cells {
            self.body_fraction[cell] = (self.body_fraction[cell] + fraction).min(1.0);
        }
    }

    /// Enters the rates at which gaps grow between bodies and cells [m³/s], which take in water as soil does
    /// that expands.
    pub(crate) fn open_gaps(&mut self, gaps: impl Iterator<Item = (usize, f64)>) {
        self.openings.fill(0.0);
        gaps.for_each(|(cell, rate)| self.openings[cell] += rate);
    }

    /// Memory in use [bytes].
    pub(crate) fn memory(&self) -> usize {
        ARRAYS * size_of_val(self.diagonal.as_slice())
    }
}

/// Memory of the workspace of a model [bytes].
pub(crate) fn footprint(model: &Model) -> f64 {
    let entries = if model.pore_water.is_some() { model.grid.entries } else { 0 };
    (ARRAYS * entries * size_of::<f64>()) as f64
}

/// Columns of a row of cells in the domain, and whether the row `[q, plane]` of the memory holds any.
fn columns(grid: &Grid, row: usize) -> Option<std::ops::Range<usize>> {
    let inside = grid.inside(0);
    grid.is_inside(grid.row_and_plane(row)).then_some(inside.start + 1..inside.end + 1)
}
