//! How the grid of a case is cut into blocks, one for each process of a run.

use solver::grid::{GHOSTS, Grid};
use solver::halo::decomposition::Decomposition;
use solver::model::Model;
use std::ops::Range;

/// Cost of a row of cells without soil over that of one with soil.
const VOID: f64 = 0.02;

/// A grid has too few layers of cells for so many blocks.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the grid has {} x {} layers of cells along y and z, too few for {blocks} processes: each needs {GHOSTS} layers along both; \
     use fewer processes, or threads in their place",
    .layers[0], .layers[1]
)]
pub struct TooManyBlocks {
    /// Number of blocks.
    pub blocks: usize,
    /// Layers of cells of the domain along y and z.
    pub layers: [usize; 2],
}

/// Cuts the grid of a model into a number of blocks of about the same cost at the start.
pub(crate) fn decompose(model: &Model, blocks: usize) -> Result<Decomposition, TooManyBlocks> {
    let [_, rows, planes] = model.grid.domain.each_ref().map(Range::len);
    let top = top_of_soil(model);
    let floor = |k: usize| model.grid.whole[2][model.grid.domain[2].start + k];
    let cost: Vec<f64> =
        (0..rows * planes).map(|row| if floor(row / rows) < top { 1.0 } else { VOID }).collect();
    Decomposition::by_cost(&model.grid, blocks, &cost).ok_or(TooManyBlocks { blocks, layers: [rows, planes] })
}

/// Height below which there may be soil at the start [m].
fn top_of_soil(model: &Model) -> f64 {
    let Grid { whole, .. } = &model.grid;
    let highest = whole[2][whole[2].len() - 1];
    let ground = &model.ground;
    if !ground.is_even() {
        return highest;
    }
    ground.fillings.iter().map(|filling| filling.high.z).fold(f64::NEG_INFINITY, f64::max).min(highest)
}
