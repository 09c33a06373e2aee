//! How the grid of a case is cut into blocks, one for each process of a run.

use case::Case;
use case::model::model;
use solver::grid::{GHOSTS, Grid};
use solver::halo::Halo;
use solver::halo::decomposition::Decomposition;
use solver::model::Model;
use solver::precision::Precision;
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

/// The block of the grid of a valid case that a process has: number and number of all. The whole grid for one
/// of one.
///
/// # Errors
/// When the grid has too few layers of cells for so many blocks.
pub fn of_case<R: Precision>(case: &Case, [rank, blocks]: [usize; 2]) -> Result<Grid, TooManyBlocks> {
    let model = model(case, R::LANES);
    let cut = decompose(&model, blocks)?;
    Ok(model.grid.block(cut.own(rank)))
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

/// When the grid of a run is cut anew next, and how long its block has taken since the last time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Balance {
    /// Step at which the blocks are compared next.
    next: u64,
    /// Steps from there to the time after.
    interval: u64,
    /// Time in steps since the last comparison, without that spent on communication [s].
    seconds: f64,
}

impl Balance {
    /// Steps to the first comparison.
    const FIRST: u64 = 64;
    /// Most steps between two: yielding moves slowly over the grid.
    const LONGEST: u64 = 2048;
    /// Fraction of the time of a step that must be gained.
    const GAIN: f64 = 0.05;

    /// The balance of a run which begins, or goes on, at a step.
    pub(crate) fn from(step: u64) -> Self {
        Self { next: step + Self::FIRST, interval: Self::FIRST, seconds: 0.0 }
    }

    /// Counts a step that took so long without communication [s].
    pub(crate) fn count(&mut self, seconds: f64) {
        self.seconds += seconds;
    }

    /// How the grid is to be cut from now on, if otherwise than now; all blocks must ask at the same steps.
    /// By the time that the blocks have taken, so that slow processors get less, and the cost of rows of
    /// cells within each.
    pub(crate) fn decide(
        &mut self,
        grid: &Grid,
        costs: impl FnOnce() -> Vec<f64>,
        (step, halo): (u64, &Halo),
    ) -> Option<Decomposition> {
        if halo.is_alone() || step < self.next {
            return None;
        }
        self.next = step + self.interval;
        self.interval = (2 * self.interval).min(Self::LONGEST);
        let (seconds, costs) = (std::mem::take(&mut self.seconds), costs());
        let per_cost = seconds / costs.iter().sum::<f64>();
        let own = grid.own[1..].iter().flat_map(|own| [own.start as f64, own.end as f64]);
        let all = halo.gather(own.chain([seconds]).chain(costs.iter().map(|cost| per_cost * cost)).collect());
        let (cost, longest) = joined(grid, &all);
        let whole = grid.uncut();
        let cut = Decomposition::by_cost(&whole, halo.blocks(), &cost)?;
        let gain = 1.0 - cut.highest(&whole, &cost) / longest;
        (gain > Self::GAIN).then_some(cut)
    }
}

/// Cost of every row of the domain from what the blocks have gathered, y fastest, and the time of the slowest
/// [s].
fn joined(grid: &Grid, mut all: &[f64]) -> (Vec<f64>, f64) {
    let [_, rows, planes] = grid.domain.each_ref().map(Range::len);
    let (mut cost, mut longest) = (vec![0.0; rows * planes], 0.0_f64);
    while let Some((&[y0, y1, z0, z1, seconds], rest)) = all.split_first_chunk::<5>() {
        longest = longest.max(seconds);
        let [own_y, own_z] = [(1, y0, y1), (2, z0, z1)].map(|(axis, start, end)| {
            let first = grid.domain[axis].start;
            start as usize - first..end as usize - first
        });
        let (own, others) = rest.split_at(own_y.len() * own_z.len());
        for (k, row) in own_z.zip(own.chunks_exact(own_y.len())) {
            cost[k * rows..][own_y.clone()].copy_from_slice(row);
        }
        all = others;
    }
    (cost, longest)
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
