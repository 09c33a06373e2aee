//! A run from case to results: the loop of the simulation with those who write its results, and the report at its end.

mod confidence;
mod meshes;
mod observers;
mod options;
mod part;
mod start;
pub mod watch;

use crate::case::{Case, require_valid, resolved};
use crate::output::checkpoint;
use crate::output::folder::{Outcome, StageRecord, clear_beside};
use crate::output::progress::Progress;
use crate::output::{Results, Summary, mean_lines, study_lines};
use crate::simulation::{Simulation, Stop};
use crate::trust::Verdict;
use observers::{Checkpoints, Fields, Followed, ProgressBar, Signals, Tables, Watch, statistics};
use solver::precision::Precision;
use std::path::Path;
use std::time::Instant;

pub use confidence::{Budget, Request, relative_cost, run_confidence};
pub use meshes::run_meshes;
pub use options::{End, Follower, NoFollower, RunError, RunOptions, Start};
use part::Part;
use start::{ended_before, lock, open};

/// Runs a case and writes its results.
///
/// # Errors
/// [`RunError`] when the case is not valid, the physics fails, or the results cannot be read or written.
pub fn run(case: &Case, options: &RunOptions) -> Result<End, RunError> {
    run_followed(case, options, &mut NoFollower)
}

/// As [`run()`], with someone who is told of every sample and may end the run there.
///
/// # Errors
/// As [`run()`].
pub fn run_followed(case: &Case, options: &RunOptions, follower: &mut dyn Follower) -> Result<End, RunError> {
    require_valid(case)?;
    let _lock = lock(options)?;
    if options.start == Start::AutoResume
        && let Some(summary) = ended_before(case, options.folder)?
    {
        return Ok(End::Finished(Box::new(summary)));
    }
    if options.start == Start::Replace {
        // Those of an earlier mesh study and of variations are no longer of this result.
        clear_beside(options.folder)?;
    }
    run_locked_followed(case, options, &Part::default(), follower)
}

/// Runs a case in a folder that is locked.
fn run_locked(case: &Case, options: &RunOptions, part: &Part) -> Result<End, RunError> {
    run_locked_followed(case, options, part, &mut NoFollower)
}

fn run_locked_followed(
    case: &Case,
    options: &RunOptions,
    part: &Part,
    follower: &mut dyn Follower,
) -> Result<End, RunError> {
    match case.numerics.precision {
        resolved::Precision::Double => run_in::<f64>(case, options, part, follower),
        resolved::Precision::Single => run_in::<f32>(case, options, part, follower),
    }
}

fn run_in<R: Precision>(
    case: &Case,
    options: &RunOptions,
    part: &Part,
    follower: &mut dyn Follower,
) -> Result<End, RunError> {
    let began = Instant::now();
    let (mut simulation, mut results) = open::<R>(case, options, part)?;
    let mut progress = Progress::start(case, simulation.state.time, options.quiet).labelled(&part.label);
    let stop = observed(&mut simulation, &mut results, &mut progress, options, follower)?;
    let outcome = match &stop {
        Stop::Finished => Outcome::Finished,
        Stop::Asked(_) => Outcome::Interrupted,
        Stop::BrokenDown(cause) => Outcome::BrokeDown(cause.to_string()),
    };
    let Simulation { model, state, history, .. } = &simulation;
    let statistics = statistics(&simulation, outcome);
    for StageRecord { name, from_s, to_s } in &statistics.stages {
        results.log.line(&format!("stage {name}: t = {from_s:.6} to {to_s:.6} s"))?;
    }
    let summary = results.finish(case, &model.grid, state, history, &statistics)?;
    let seconds = began.elapsed().as_secs_f64();
    match stop {
        Stop::Finished => {
            checkpoint::forget_previous(options.folder)?;
            results
                .log
                .line(&format!("finished after {} steps, {seconds:.1} s since the start", state.step))?;
            for line in verdict(&summary) {
                results.log.line(&line)?;
            }
            progress.finish(&part.headed(closing_message(&summary, seconds, (options.folder, part))));
            Ok(End::Finished(Box::new(summary)))
        }
        Stop::Asked(why) => {
            results.log.line(&format!("stopped by {why} at t = {} s", state.time))?;
            progress.finish(&part.headed("stopped; --resume continues from here".to_owned()));
            let signal = options.interrupts.stopped_by().unwrap_or_default();
            Ok(End::Stopped(signal, checkpoint::path(options.folder)))
        }
        Stop::BrokenDown(cause) => {
            results.log.line(&format!("broke down: {cause}"))?;
            progress.finish(&part.headed("broke down".to_owned()));
            Err(RunError::Physics {
                cause: Box::new(cause),
                folder: options.folder.to_path_buf(),
                checkpoint: checkpoint::failed_path(options.folder),
            })
        }
    }
}

/// The loop of the run, in the order in which its observers are told of a sample. The state is written before anything else
/// that the end of the run leaves: all that can be rebuilt from it.
fn observed<R: Precision>(
    simulation: &mut Simulation<R>,
    results: &mut Results,
    progress: &mut Progress,
    options: &RunOptions,
    follower: &mut dyn Follower,
) -> Result<Stop, RunError> {
    let Results { tables, fields, log, record, .. } = results;
    let stop = simulation.run(&mut [
        &mut Tables(tables),
        &mut ProgressBar(progress),
        &mut Watch,
        &mut Fields(fields),
        &mut Followed(follower),
        &mut Signals(options.interrupts),
        &mut Checkpoints::new(options.folder, options.interrupts, log, record),
    ])?;
    Ok(stop)
}

/// The last message of a finished run.
fn closing_message(summary: &Summary, seconds: f64, (folder, part): (&Path, &Part)) -> String {
    let report = folder.join("report.html");
    let end = format!("in {seconds:.1} s; the report is {}", report.display());
    if part.is_beside {
        let grade = format!("{}; {end}", summary.trust.verdict.name());
        return [mean_lines(summary), vec![grade]].concat().join("\n");
    }
    match summary.trust.verdict {
        // Why it is broken is reported as an error.
        Verdict::Broken => [vec![format!("ended {end}")], study_lines(summary)].concat().join("\n"),
        Verdict::Good | Verdict::Doubtful => {
            [vec![format!("done {end}")], study_lines(summary), verdict(summary)].concat().join("\n")
        }
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
