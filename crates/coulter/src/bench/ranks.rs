//! Measures the speed of the solver in the processes of an MPI run, and how much they communicate.

use super::measure::{Options, case_for};
use super::network::Network;
use crate::blocks::TooManyBlocks;
use crate::simulation::Simulation;
use case::resolved;
use results::domain::PlacedDomain;
use results::formats;
use serde::{Deserialize, Serialize};
use solver::cpu::stopwatch::Stage;
use solver::error::Breakdown;
use solver::grid::Grid;
use solver::halo::Communicator;
use solver::precision::Precision;
use std::time::Instant;

/// What was measured in a number of processes. Times and traffic are those of one step.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct RankMeasurement {
    /// Version of the document.
    pub format: u32,
    /// Name of the case.
    pub case: String,
    /// Precision of the arithmetic.
    pub precision: String,
    /// Number of processes.
    pub ranks: usize,
    /// Threads of each.
    pub threads: usize,
    /// Cells of the whole grid along x, y, z.
    pub cells: [usize; 3],
    /// Cells with soil.
    pub filled_cells: usize,
    /// Steps measured.
    pub steps: u32,
    /// Remaps among the steps.
    pub remaps: u64,
    /// Wall clock [s].
    pub step_s: f64,
    /// Time without communication of the slowest process, and of all on average [s].
    pub compute_s: [f64; 2],
    /// Fraction of the time without communication that contact takes, which every process solves for all.
    pub contact: f64,
    /// Messages to neighbours, most of any process.
    pub messages: f64,
    /// Bytes in messages to neighbours, most of any process.
    pub message_bytes: f64,
    /// Bytes in messages per row of cells at a cut; 0 without cuts.
    pub bytes_per_cut_row: f64,
    /// Messages per cut of a block; 0 without cuts.
    pub messages_per_cut: f64,
    /// Collective operations.
    pub collectives: f64,
    /// Bytes that all processes put into them.
    pub collective_bytes: f64,
    /// Links between the processes; none of one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub network: Option<Network>,
}

/// Why a case cannot be measured in several processes.
#[derive(Debug, thiserror::Error)]
pub enum RankError {
    /// There are more processes than the grid has blocks.
    #[error(transparent)]
    Blocks(#[from] TooManyBlocks),
    /// The physics failed.
    #[error(transparent)]
    Physics(#[from] Breakdown),
}

/// Measures a case in several processes, each with so many threads; the same is returned in each.
///
/// # Errors
/// [`RankError`] when the grid has too few layers, or the physics fails.
pub fn measure_ranks(
    options: &Options,
    communicator: Box<dyn Communicator>,
) -> Result<RankMeasurement, RankError> {
    match options.case.numerics.precision {
        resolved::Precision::Double => measure_in::<f64>(options, communicator),
        resolved::Precision::Single => measure_in::<f32>(options, communicator),
    }
}

/// What one process has to say of itself. Times are those of all steps.
struct Own {
    remaps: u64,
    wall: f64,
    compute: f64,
    contact: f64,
    messages: f64,
    bytes: f64,
    collectives: f64,
    collective_bytes: f64,
    cut_rows: f64,
    cuts: f64,
    filled: f64,
}

fn measure_in<R: Precision>(
    options: &Options,
    mut communicator: Box<dyn Communicator>,
) -> Result<RankMeasurement, RankError> {
    let network = Network::measure(communicator.as_mut());
    let mut simulation = Simulation::<R>::of_block(&case_for(options, options.threads), communicator)?;
    simulation.steps(options.warm_up)?;
    let own = own(&mut simulation, options.steps)?;
    let (steps, ranks) = (f64::from(options.steps), simulation.halo().blocks());
    let sum = |value: f64| simulation.halo().gather(vec![value]).iter().sum::<f64>();
    let most = |value: f64| simulation.halo().gather(vec![value]).into_iter().fold(0.0, f64::max);
    let per = |value: f64, of: f64| if of > 0.0 { value / of } else { 0.0 };
    let [columns, rows, planes] = simulation.model.grid.domain.clone().map(|layers| layers.len());
    Ok(RankMeasurement {
        format: formats::DOCUMENT,
        case: options.case.name.clone(),
        precision: R::NAME.to_owned(),
        ranks,
        threads: simulation.threads(),
        cells: [columns, rows, planes],
        filled_cells: sum(own.filled) as usize,
        steps: options.steps,
        remaps: own.remaps,
        step_s: most(own.wall) / steps,
        compute_s: [most(own.compute), sum(own.compute) / ranks as f64].map(|s| s / steps),
        contact: sum(own.contact) / ranks as f64,
        messages: most(own.messages) / steps,
        message_bytes: most(own.bytes) / steps,
        bytes_per_cut_row: per(sum(own.bytes), steps * sum(own.cut_rows)),
        messages_per_cut: per(sum(own.messages), steps * sum(own.cuts)),
        collectives: most(own.collectives) / steps,
        collective_bytes: sum(own.collective_bytes) / steps,
        network,
    })
}

/// Takes the steps and measures them. Reading the clock in every stage takes time, so that the share of
/// contact is measured by itself, on the steps that follow.
fn own<R: Precision>(simulation: &mut Simulation<R>, steps: u32) -> Result<Own, Breakdown> {
    simulation.halo().meet();
    let remaps = simulation.state.remaps;
    let (before, clock) = (simulation.halo().traffic(), Instant::now());
    simulation.steps(steps)?;
    let remaps = simulation.state.remaps - remaps;
    let (wall, after) = (clock.elapsed().as_secs_f64(), simulation.halo().traffic());
    simulation.stopwatch().start();
    simulation.steps(steps.div_ceil(4))?;
    let stopwatch = simulation.stopwatch().clone();
    let all: f64 = Stage::ALL.iter().map(|stage| stopwatch.seconds(*stage)).sum();
    let grid = &simulation.model.grid;
    let domain = PlacedDomain::of(grid, simulation.state.grid_position);
    let [cuts, cut_rows] = cuts(grid);
    Ok(Own {
        remaps,
        wall,
        compute: wall - (after.seconds - before.seconds),
        contact: stopwatch.seconds(Stage::Contact) / all,
        messages: (after.messages - before.messages) as f64,
        bytes: (after.message_bytes - before.message_bytes) as f64,
        collectives: (after.collectives - before.collectives) as f64,
        collective_bytes: (after.collective_bytes - before.collective_bytes) as f64,
        cut_rows,
        cuts,
        filled: domain.filled_cells(&simulation.state) as f64,
    })
}

/// Number of cuts round a block, and of rows of cells along them.
fn cuts(grid: &Grid) -> [f64; 2] {
    let each = [(1, 0), (1, 1), (2, 0), (2, 1)];
    let cut = each.into_iter().filter(|(axis, end)| grid.is_cut(*axis, *end));
    cut.fold([0.0, 0.0], |[cuts, rows], (axis, _)| [cuts + 1.0, rows + grid.own[3 - axis].len() as f64])
}
