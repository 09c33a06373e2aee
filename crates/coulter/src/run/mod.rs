//! A run from case to results: steps, samples, fields, checkpoints, report.

mod options;
mod start;
pub mod watch;

use crate::case::{self, Case, resolved};
use crate::interrupts::Request;
use crate::output::Results;
use crate::output::checkpoint;
use crate::output::progress::Progress;
use crate::output::run_record::{Outcome, RunStatistics};
use crate::output::summary::Summary;
use crate::simulation::Simulation;
use crate::trust::Verdict;
use solver::error::Breakdown;
use solver::precision::Precision;
use std::path::Path;
use std::time::Instant;

pub use options::{End, RunError, RunOptions, Start};
use start::{ended_before, lock, open};
use watch::watch;

/// Runs a case and writes its results.
///
/// # Errors
/// [`RunError`] when the case is not valid, the physics fails, or the results cannot be read or written.
pub fn run(case: &Case, options: &RunOptions) -> Result<End, RunError> {
    case::require_valid(case)?;
    let _lock = lock(options)?;
    if options.start == Start::AutoResume
        && let Some(summary) = ended_before(case, options.folder)?
    {
        return Ok(End::Finished(Box::new(summary)));
    }
    match case.numerics.precision {
        resolved::Precision::Double => run_in::<f64>(case, options),
        resolved::Precision::Single => run_in::<f32>(case, options),
    }
}

fn run_in<R: Precision>(case: &Case, options: &RunOptions) -> Result<End, RunError> {
    let began = Instant::now();
    let (mut simulation, mut results) = open::<R>(case, options)?;
    let mut progress = Progress::start(case, simulation.state.time, options.quiet);
    let ended = advance(&mut simulation, &mut results, &mut progress, options)?;
    let outcome = match &ended {
        Ended::Finished => Outcome::Finished,
        Ended::Stopped(_) => Outcome::Interrupted,
        Ended::Broken(cause) => Outcome::BrokeDown(cause.to_string()),
    };
    let statistics = statistics(&simulation, outcome);
    // The state first: everything else can be rebuilt from it.
    let checkpoint = match ended {
        Ended::Broken(_) => simulation.checkpoint().write_failed(options.folder)?,
        Ended::Finished | Ended::Stopped(_) => simulation.checkpoint().write(options.folder)?,
    };
    let Simulation { model, state, history, .. } = &simulation;
    let summary = results.finish(case, &model.grid, state, history, &statistics)?;
    let seconds = began.elapsed().as_secs_f64();
    match ended {
        Ended::Finished => {
            checkpoint::forget_previous(options.folder)?;
            results.log(&format!("finished after {} steps, {seconds:.1} s since the start", state.step))?;
            for line in verdict(&summary) {
                results.log(&line)?;
            }
            progress.finish(&closing_message(&summary, seconds, options.folder));
            Ok(End::Finished(Box::new(summary)))
        }
        Ended::Stopped(signal) => {
            results.log(&format!("stopped by signal {signal} at t = {} s", state.time))?;
            progress.finish("stopped; --resume continues from here");
            Ok(End::Stopped(signal, checkpoint))
        }
        Ended::Broken(cause) => {
            results.log(&format!("broke down: {cause}"))?;
            progress.finish("broke down");
            Err(RunError::Physics {
                cause: Box::new(cause),
                folder: options.folder.to_path_buf(),
                checkpoint,
            })
        }
    }
}

fn statistics(simulation: &Simulation<impl Precision>, outcome: Outcome) -> RunStatistics {
    RunStatistics {
        steps: simulation.state.step,
        wall_seconds: simulation.wall_s,
        threads: simulation.threads(),
        outcome,
        advice: case::advice(&simulation.case),
    }
}

/// The last message of a finished run.
fn closing_message(summary: &Summary, seconds: f64, folder: &Path) -> String {
    let report = folder.join("report.html");
    let end = format!("in {seconds:.1} s; the report is {}", report.display());
    match summary.trust.verdict {
        // Why it is broken is reported as an error.
        Verdict::Broken => format!("ended {end}"),
        Verdict::Good | Verdict::Doubtful => format!("done {end}\n{}", verdict(summary).join("\n")),
    }
}

/// The verdict and the checks behind it, one line each.
#[must_use]
pub fn verdict(summary: &Summary) -> Vec<String> {
    let trust = &summary.trust;
    let mut lines = vec![format!("trust: {}", trust.verdict.name())];
    lines.extend(
        trust.concerns().iter().map(|c| format!("  {}: {}; {}", c.verdict.name(), c.line(), c.advice)),
    );
    lines
}

enum Ended {
    Finished,
    Stopped(i32),
    Broken(Breakdown),
}

/// Advances from sample to sample until the end, a stop or a breakdown.
fn advance(
    simulation: &mut Simulation<impl Precision>,
    results: &mut Results,
    progress: &mut Progress,
    options: &RunOptions,
) -> Result<Ended, RunError> {
    let interval = simulation.case.output.field_interval;
    let between = simulation.case.output.checkpoint_interval;
    let mut last_checkpoint = Instant::now();
    while !simulation.is_done() {
        let is_due = || last_checkpoint.elapsed().as_secs_f64() >= between;
        match simulation.advance_unless(|| options.interrupts.is_pending() || is_due()) {
            Err(cause) => return Ok(Ended::Broken(cause)),
            Ok(false) => {}
            Ok(true) => {
                results.append(&simulation.history)?;
                progress.update(simulation.state.time, &simulation.history);
                if let Err(cause) = watch(simulation) {
                    return Ok(Ended::Broken(cause));
                }
                if results.fields_are_due(simulation.state.time, interval) {
                    results.write_fields(&simulation.case, &simulation.model.grid, &simulation.state)?;
                }
            }
        }
        let request = options.interrupts.take();
        if let Some(Request::Stop(signal)) = request {
            return Ok(Ended::Stopped(signal));
        }
        if request.is_some() || is_due() {
            simulation.checkpoint().write(options.folder)?;
            results.write_statistics(&statistics(simulation, Outcome::Running))?;
            results.log(&format!("checkpoint at t = {} s", simulation.state.time))?;
            last_checkpoint = Instant::now();
        }
    }
    Ok(Ended::Finished)
}
