//! How fast the solver is on this machine: cell-steps per core-second, where the time goes, and what the machine could do.

mod table;
mod work;

pub use table::table;

use crate::case::{Case, resolved};
use crate::simulation::Simulation;
use cpu_time::ProcessTime;
use serde::Serialize;
use solver::cpu::machine;
use solver::cpu::stopwatch::{Stage, Stopwatch};
use solver::error::Breakdown;
use solver::precision::Precision;
use std::time::Instant;
use work::Work;

/// The towed disc in the midst of its tow: it starts 20 mm deep, moving, so that there is no need to wait for it.
pub const TOWED_DISC: (&str, [&str; 4]) = (
    include_str!("../../../../cases/towed_disc.toml"),
    [
        "body.disc.sinkage=20 mm",
        "body.disc.forward.start=0 s",
        "body.disc.forward.ramp=10 ms",
        "body.disc.heave.ramp=10 ms",
    ],
);

/// What to measure.
#[derive(Debug)]
pub struct Wish {
    /// The case.
    pub case: Case,
    /// Number of threads to compare with one.
    pub threads: usize,
    /// Steps before the measurement.
    pub warm_up: u32,
    /// Steps that are measured.
    pub steps: u32,
}

/// What was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Measurement {
    /// Name of the case.
    pub case: String,
    /// Precision of the arithmetic.
    pub precision: &'static str,
    /// Threads of the second measurement.
    pub threads: usize,
    /// Cells of the grid along x, y, z.
    pub cells: [usize; 3],
    /// Cells with soil.
    pub filled_cells: usize,
    /// Steps measured.
    pub steps: u32,
    /// Remaps among them.
    pub remaps: u64,
    /// How many steps take as long as a remap, one thread.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steps_in_remap: Option<f64>,
    /// In single precision: speed of one thread over that in double precision.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub times_double: Option<f64>,
    /// In single precision: memory over that of double precision.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory_of_double: Option<f64>,
    /// Million steps of a cell with soil per second of processor time, one thread.
    pub million_cell_steps_per_core_second: f64,
    /// The same of all threads together.
    pub million_cell_steps_per_core_second_threads: f64,
    /// Speed of all threads over that of one, by the wall clock.
    pub speed_up: f64,
    /// Memory of state and workspace per cell of the grid, with or without soil [bytes].
    pub bytes_per_cell: f64,
    /// Traffic with the main memory that one thread can have [GB/s].
    #[serde(rename = "triad_GB_per_s")]
    pub triad: f64,
    /// Multiply-adds that one thread can do in this precision [GFLOP/s]; measured in double precision.
    #[serde(rename = "fma_GFLOP_per_s")]
    pub fma: f64,
    /// The same of all threads.
    #[serde(rename = "triad_threads_GB_per_s")]
    pub triad_threads: f64,
    /// The same of all threads.
    #[serde(rename = "fma_threads_GFLOP_per_s")]
    pub fma_threads: f64,
    /// Share of the cell-steps in which the soil yields.
    pub yielding: f64,
    /// Share of the time by stage, one thread.
    pub split: Split,
    /// Operations of the stages that can be counted [GFLOP/s], one thread.
    #[serde(rename = "achieved_GFLOP_per_s")]
    pub operations: Operations,
    /// Traffic of the Lagrangian stage if each array crosses the bus once [GB/s], one thread.
    #[serde(rename = "achieved_GB_per_s")]
    pub traffic: f64,
}

/// Fractions of the time.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Split {
    /// Strain, trial stress, force coefficients.
    pub lagrange: f64,
    /// Return mapping.
    pub plasticity: f64,
    /// Forces gathered, velocities, displacements.
    pub nodes: f64,
    /// The Eulerian stage.
    pub remap: f64,
    /// Contact and bodies.
    pub contact: f64,
    /// Energy balance and checks.
    pub other: f64,
}

/// Rates of arithmetic [GFLOP/s].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Operations {
    /// Strain, trial stress, force coefficients.
    pub lagrange: f64,
    /// Return mapping.
    pub plasticity: f64,
    /// Forces gathered, velocities, displacements.
    pub nodes: f64,
}

/// Measures a case, with one thread and with several.
///
/// # Errors
/// [`Breakdown`] when the physics fails.
pub fn measure(wish: &Wish) -> Result<Measurement, Breakdown> {
    match wish.case.numerics.precision {
        resolved::Precision::Double => measure_in::<f64>(wish),
        resolved::Precision::Single => {
            let mut double = Simulation::<f64>::new(&case_for(wish, 1));
            double.steps(wish.warm_up)?;
            let seconds = timed(&mut double, wish.steps)?.processor;
            let bytes = double.memory() as f64;
            drop(double);
            let single = measure_in::<f32>(wish)?;
            let cells = single.cells.iter().product::<usize>() as f64;
            let rate = 1e-6 * single.filled_cells as f64 * f64::from(wish.steps) / seconds;
            Ok(Measurement {
                times_double: Some(single.million_cell_steps_per_core_second / rate),
                memory_of_double: Some(single.bytes_per_cell * cells / bytes),
                ..single
            })
        }
    }
}

fn measure_in<R: Precision>(wish: &Wish) -> Result<Measurement, Breakdown> {
    let limits = [1, wish.threads].map(machine::measure);
    // A vector holds as many more numbers as they are shorter.
    let wider = (size_of::<f64>() / size_of::<R>()) as f64;
    let mut lone = Simulation::<R>::new(&case_for(wish, 1));
    lone.steps(wish.warm_up)?;
    let moving = lone.checkpoint().kept();
    let before = lone.state.remaps;
    let alone = timed(&mut lone, wish.steps)?;
    let remaps = lone.state.remaps - before;
    let filled = lone.state.soil.fraction.iter().filter(|f| **f != R::default()).count();
    let bytes = lone.memory() as f64;
    drop(lone);
    // Reading the clock takes time, so the split is measured by itself, on the same steps.
    let mut lone = Simulation::<R>::resume(&case_for(wish, 1), moving.clone(), 0.0);
    lone.stopwatch().start();
    lone.steps(wish.steps)?;
    let stopwatch = lone.stopwatch().clone();
    drop(lone);
    let mut team = Simulation::resume(&case_for(wish, wish.threads), moving, 0.0);
    let together = timed(&mut team, wish.steps)?;
    let cells = team.model.grid.cells();
    let cell_steps = filled as f64 * f64::from(wish.steps);
    let split = split(&stopwatch);
    let of_one_remap = split.remap / remaps as f64;
    let of_one_step = (1.0 - split.remap) / f64::from(wish.steps);
    let returned = stopwatch.returned() as f64;
    // Shares of the processor time: the clock also runs while others have the processor.
    let work = Work { cell_steps, returned, seconds: alone.processor, bytes: size_of::<R>() };
    Ok(Measurement {
        case: wish.case.name.clone(),
        precision: R::NAME,
        times_double: None,
        memory_of_double: None,
        threads: team.threads(),
        cells,
        filled_cells: filled,
        steps: wish.steps,
        remaps,
        steps_in_remap: (remaps > 0).then(|| of_one_remap / of_one_step),
        million_cell_steps_per_core_second: 1e-6 * cell_steps / alone.processor,
        million_cell_steps_per_core_second_threads: 1e-6 * cell_steps / together.processor,
        speed_up: alone.wall / together.wall,
        bytes_per_cell: bytes / cells.iter().product::<usize>() as f64,
        triad: limits[0].triad,
        fma: wider * limits[0].fma,
        triad_threads: limits[1].triad,
        fma_threads: wider * limits[1].fma,
        yielding: returned / cell_steps,
        split,
        operations: work.operations(&split),
        traffic: work.traffic(&split),
    })
}

/// What a number of steps took.
struct Taken {
    /// By the wall clock [s].
    wall: f64,
    /// Of processor time, all threads together [s].
    processor: f64,
}

fn timed(simulation: &mut Simulation<impl Precision>, steps: u32) -> Result<Taken, Breakdown> {
    let (wall, processor) = (Instant::now(), ProcessTime::now());
    simulation.steps(steps)?;
    Ok(Taken { wall: wall.elapsed().as_secs_f64(), processor: processor.elapsed().as_secs_f64() })
}

fn case_for(wish: &Wish, threads: usize) -> Case {
    let mut case = wish.case.clone();
    case.numerics.threads = threads;
    case
}

fn split(stopwatch: &Stopwatch) -> Split {
    let seconds: f64 = Stage::ALL.iter().map(|stage| stopwatch.seconds(*stage)).sum();
    let fraction = |stage| stopwatch.seconds(stage) / seconds;
    Split {
        lagrange: fraction(Stage::Lagrange),
        plasticity: fraction(Stage::Plasticity),
        nodes: fraction(Stage::Nodes),
        remap: fraction(Stage::Remap),
        contact: fraction(Stage::Contact),
        other: fraction(Stage::Other),
    }
}
