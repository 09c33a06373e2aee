//! A run from case to results: steps, samples, fields, checkpoints, report.

use crate::case::{self, Case, resolved};
use crate::forecast;
use crate::output::OutputError;
use crate::output::Results;
use crate::output::checkpoint::Checkpoint;
use crate::output::progress::Progress;
use crate::output::run_record::{Outcome, RunStatistics};
use crate::output::summary::Summary;
use crate::simulation::{Simulation, case_text};
use solver::error::Breakdown;
use solver::precision::Precision;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// How to run.
#[derive(Debug)]
pub struct Options<'a> {
    /// Results folder.
    pub folder: &'a Path,
    /// Replace a result that is there.
    pub force: bool,
    /// Go on from the checkpoint in the folder.
    pub resume: bool,
    /// Show no progress.
    pub quiet: bool,
    /// Set from outside to stop.
    pub stop: &'a AtomicBool,
    /// The case file as typed, with overrides written in; kept beside the results.
    pub typed: &'a str,
}

/// How a run ended.
#[derive(Debug)]
pub enum End {
    /// It came to its end.
    Finished(Box<Summary>),
    /// It was stopped; here is the checkpoint to go on from.
    Stopped(PathBuf),
}

/// Why a run did not come to its end.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// Results could not be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The checkpoint belongs to another case.
    #[error("the checkpoint in {} belongs to another case file; run with --force to start anew", .0.display())]
    OtherCase(PathBuf),
    /// The physics failed.
    #[error("{cause}\nthe state at that time is in {}, the checkpoint in {}", .folder.display(), .checkpoint.display())]
    Physics {
        /// How.
        cause: Breakdown,
        /// Where the results so far are.
        folder: PathBuf,
        /// The checkpoint of the state that failed.
        checkpoint: PathBuf,
    },
}

/// Runs a case and writes its results.
///
/// # Errors
/// [`RunError`] when the physics fails or the results cannot be written.
pub fn run(case: &Case, options: &Options) -> Result<End, RunError> {
    match case.numerics.precision {
        resolved::Precision::Double => run_in::<f64>(case, options),
        resolved::Precision::Single => run_in::<f32>(case, options),
    }
}

fn run_in<R: Precision>(case: &Case, options: &Options) -> Result<End, RunError> {
    let (mut simulation, mut results) = open::<R>(case, options)?;
    let mut progress = Progress::start(case, simulation.state.time, options.quiet);
    let outcome = drive(&mut simulation, &mut results, &mut progress, options)?;
    let statistics = RunStatistics {
        steps: simulation.state.step,
        wall_seconds: simulation.wall_s,
        threads: simulation.threads(),
        outcome: match &outcome {
            Ended::Finished => Outcome::Finished,
            Ended::Stopped => Outcome::Interrupted,
            Ended::Broken(cause) => Outcome::BrokeDown(cause.to_string()),
        },
        warnings: warnings(&simulation),
        advice: case::advice(case),
    };
    let Simulation { model, state, history, .. } = &simulation;
    let checkpoint = simulation.checkpoint().write(options.folder)?;
    let summary = results.finish(case, &model.grid, state, history, &statistics)?;
    let folder = options.folder.to_path_buf();
    let report = folder.join("report.html");
    match outcome {
        Ended::Finished => {
            let wall = simulation.wall_s;
            results.log(&format!("finished after {} steps and {wall:.1} s", state.step))?;
            progress.finish(&format!("done in {wall:.1} s; the report is {}", report.display()));
            Ok(End::Finished(Box::new(summary)))
        }
        Ended::Stopped => {
            results.log(&format!("stopped at t = {} s", state.time))?;
            progress.finish("stopped; --resume goes on from here");
            Ok(End::Stopped(checkpoint))
        }
        Ended::Broken(cause) => {
            results.log(&format!("broke down: {cause}"))?;
            progress.finish("broke down");
            Err(RunError::Physics { cause, folder, checkpoint })
        }
    }
}

enum Ended {
    Finished,
    Stopped,
    Broken(Breakdown),
}

/// The simulation and its folder, new or where they were left.
fn open<R: Precision>(case: &Case, options: &Options) -> Result<(Simulation<R>, Results), RunError> {
    if options.resume {
        let checkpoint = Checkpoint::read(options.folder)?;
        if checkpoint.case != case_text(case) {
            return Err(RunError::OtherCase(options.folder.to_path_buf()));
        }
        let simulation = Simulation::resume(case, checkpoint);
        let mut results = Results::resume(options.folder, case, &simulation.history, simulation.state.time)?;
        results
            .log(&format!("resumed at t = {} s, step {}", simulation.state.time, simulation.state.step))?;
        return Ok((simulation, results));
    }
    let mut results = Results::create(options.folder, case, options.force)?;
    results.keep_case_file(options.typed)?;
    let simulation = Simulation::new(case);
    let [nx, ny, nz] = simulation.model.grid.cells();
    let (dt, threads) = (simulation.model.time_step(), simulation.threads());
    results.log(&format!("{} version {}", case.name, env!("CARGO_PKG_VERSION")))?;
    results.log(&format!(
        "grid {nx} x {ny} x {nz}, time step {dt:.4e} s, {} precision, {threads} threads",
        R::NAME
    ))?;
    for note in case::advice(case) {
        results.log(&format!("note: {note}"))?;
    }
    overlay_forecast(case, &mut results)?;
    results.write_fields(case, &simulation.model.grid, &simulation.state)?;
    Ok((simulation, results))
}

/// Lays the closed forms over the plots. Where they do not apply the log says why; the run does not depend on them.
fn overlay_forecast(case: &Case, results: &mut Results) -> Result<(), OutputError> {
    match forecast::overlay::overlays(case) {
        Ok(overlays) => results.overlay(overlays),
        Err(why) => results.log(&format!("no forecast beside the results: {why}")),
    }
}

/// Goes from sample to sample until the end, a stop or a breakdown.
fn drive(
    simulation: &mut Simulation<impl Precision>,
    results: &mut Results,
    progress: &mut Progress,
    options: &Options,
) -> Result<Ended, RunError> {
    let interval = simulation.case.output.field_interval;
    let mut next_fields = (simulation.state.time / interval).floor() * interval + interval;
    let mut last_checkpoint = Instant::now();
    while !simulation.is_done() {
        if options.stop.load(Ordering::Relaxed) {
            return Ok(Ended::Stopped);
        }
        if let Err(cause) = simulation.advance() {
            return Ok(Ended::Broken(cause));
        }
        results.append(&simulation.history)?;
        progress.update(simulation.state.time, &simulation.history);
        if simulation.state.time >= next_fields {
            next_fields += interval;
            results.write_fields(&simulation.case, &simulation.model.grid, &simulation.state)?;
        }
        if last_checkpoint.elapsed().as_secs_f64() >= simulation.case.output.checkpoint_interval {
            simulation.checkpoint().write(options.folder)?;
            last_checkpoint = Instant::now();
        }
    }
    Ok(Ended::Finished)
}

/// Doubts that the run itself has raised.
fn warnings(simulation: &Simulation<impl Precision>) -> Vec<String> {
    let mut warnings = Vec::new();
    let Some(energy) = simulation.history.energy.last() else { return warnings };
    let share = |part: f64| if energy.external.abs() > 0.0 { part / energy.external.abs() } else { 0.0 };
    if energy.closure().abs() > 0.01 {
        warnings.push(format!("{:.1} % of the external work is not accounted for", 100.0 * energy.closure()));
    }
    if share(energy.hourglass) > 0.02 {
        warnings.push(format!(
            "hourglass viscosity took {:.1} % of the external work; above 2 % a finer grid is called for",
            100.0 * share(energy.hourglass)
        ));
    }
    if (energy.volume_ratio - 1.0).abs() > 0.005 {
        warnings.push(format!("the soil volume changed by {:.2} %", 100.0 * (energy.volume_ratio - 1.0)));
    }
    for (name, samples) in simulation.history.names.iter().zip(&simulation.history.bodies) {
        if let Some(last) = samples.last()
            && last.leaked_volume > 0.001 * last.embedded_volume
        {
            warnings.push(format!(
                "{:.1} % of the embedded volume of `{name}` is soil that has leaked into it (wanted: 0.1 %)",
                100.0 * last.leaked_volume / last.embedded_volume
            ));
        }
    }
    warnings
}
