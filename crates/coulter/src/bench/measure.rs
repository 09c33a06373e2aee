//! Measures the speed of the solver on a case.

use super::measurement::{Measurement, Split};
use super::work::Work;
use crate::simulation::Simulation;
use case::{Case, resolved};
use cpu_time::ProcessTime;
use results::domain::PlacedDomain;
use results::formats;
use solver::cpu::machine;
use solver::cpu::stopwatch::{Stage, Stopwatch};
use solver::error::Breakdown;
use solver::precision::Precision;
use std::time::Instant;

/// The towed disc in the midst of its tow: it starts 20 mm deep, moving, so that there is no need to wait for
/// it.
pub const TOWED_DISC: (&str, [&str; 4]) = (
    include_str!("../../cases/light_disc.toml"),
    [
        "body.disc.sinkage=20 mm",
        "body.disc.forward.start=0 s",
        "body.disc.forward.ramp=10 ms",
        "body.disc.heave.ramp=10 ms",
    ],
);

/// What to measure.
#[derive(Debug)]
pub struct Options {
    /// The case.
    pub case: Case,
    /// Number of threads to compare with one.
    pub threads: usize,
    /// Steps before the measurement.
    pub warm_up: u32,
    /// Steps that are measured.
    pub steps: u32,
}

/// Measures a case, with one thread and with several.
///
/// # Errors
/// [`Breakdown`] when the physics fails.
pub fn measure(options: &Options) -> Result<Measurement, Breakdown> {
    match options.case.numerics.precision {
        resolved::Precision::Double => measure_in::<f64>(options),
        resolved::Precision::Single => {
            let mut double = Simulation::<f64>::new(&case_for(options, 1));
            double.steps(options.warm_up)?;
            let seconds = timed(&mut double, options.steps)?.processor;
            let bytes = double.memory() as f64;
            drop(double);
            let single = measure_in::<f32>(options)?;
            let cells = single.cells.iter().product::<usize>() as f64;
            let rate = 1e-6 * single.filled_cells as f64 * f64::from(options.steps) / seconds;
            Ok(Measurement {
                format: formats::DOCUMENT,
                times_double: Some(single.million_cell_steps_per_core_second / rate),
                memory_of_double: Some(single.bytes_per_cell * cells / bytes),
                ..single
            })
        }
    }
}

fn measure_in<R: Precision>(options: &Options) -> Result<Measurement, Breakdown> {
    let limits = [1, options.threads].map(machine::measure);
    // A vector holds as many more numbers as they are shorter.
    let wider = (size_of::<f64>() / size_of::<R>()) as f64;
    let mut lone = Simulation::<R>::new(&case_for(options, 1));
    lone.steps(options.warm_up)?;
    let moving = lone.checkpoint().kept();
    let before = lone.state.remaps;
    let alone = timed(&mut lone, options.steps)?;
    let remaps = lone.state.remaps - before;
    let domain = PlacedDomain::of(&lone.model.grid, lone.state.grid_position);
    let (cells, filled) = (domain.cells(), domain.filled_cells(&lone.state));
    let bytes = lone.memory() as f64;
    drop(lone);
    // Reading the clock takes time, so the split is measured by itself, on the same steps.
    let mut lone = Simulation::<R>::resume(&case_for(options, 1), moving.clone(), 0.0);
    lone.stopwatch().start();
    lone.steps(options.steps)?;
    let stopwatch = lone.stopwatch().clone();
    drop(lone);
    let mut team = Simulation::resume(&case_for(options, options.threads), moving, 0.0);
    let together = timed(&mut team, options.steps)?;
    let cell_steps = filled as f64 * f64::from(options.steps);
    let split = split(&stopwatch);
    let of_one_remap = split.remap / remaps as f64;
    let of_one_step = (1.0 - split.remap) / f64::from(options.steps);
    let returned = stopwatch.returned() as f64;
    // Shares of the processor time: the clock also runs while others have the processor.
    let work = Work { cell_steps, returned, seconds: alone.processor, bytes: size_of::<R>() };
    Ok(Measurement {
        format: formats::DOCUMENT,
        case: options.case.name.clone(),
        precision: R::NAME,
        times_double: None,
        memory_of_double: None,
        threads: team.threads(),
        cells,
        filled_cells: filled,
        steps: options.steps,
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
    /// Wall-clock time [s].
    wall: f64,
    /// Processor time, all threads together [s].
    processor: f64,
}

fn timed(simulation: &mut Simulation<impl Precision>, steps: u32) -> Result<Taken, Breakdown> {
    let (wall, processor) = (Instant::now(), ProcessTime::now());
    simulation.steps(steps)?;
    Ok(Taken { wall: wall.elapsed().as_secs_f64(), processor: processor.elapsed().as_secs_f64() })
}

pub(super) fn case_for(options: &Options, threads: usize) -> Case {
    let mut case = options.case.clone();
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
