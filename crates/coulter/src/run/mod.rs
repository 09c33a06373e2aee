//! A run from case to results: the loop of the simulation with those who write its results, and the report at
//! its end.

mod accuracy;
mod confidence;
#[cfg(test)]
mod lost_device;
mod observers;
pub mod on_device;
mod options;
mod part;
mod processes;
mod start;
pub mod watch;

use crate::simulation::{Observer, Simulation, Steerer, Stop};
use case::{Case, require_valid, resolved};
use observers::{Checkpoints, Fields, Followed, ProgressBar, Signals, Tables, Watch, statistics};
use report::pictures::Shown;
use report::{Results, Summary, mean_lines};
use results::checkpoint;
use results::folder::{Outcome, StageRecord, clear_beside};
use results::progress::{self, Progress};
use results::trust::Verdict;
use results::vtk::FieldSeries;
use solver::error::Breakdown;
use solver::halo::Halo;
use solver::precision::Precision;
use std::path::Path;
use std::time::Instant;

pub use accuracy::{Accuracy, run_accuracy};
pub use confidence::{Budget, Request, relative_cost, run_confidence};
pub use options::{End, Follower, NoFollower, RunError, RunOptions, Start, alone};
use part::Part;
use processes::Processes;
pub use solver::device::{Device, DeviceError};
use start::{Opened, ended_before, lock, open};

/// Runs a case and writes its results.
///
/// # Errors
/// [`RunError`] when the case is not valid, the physics fails, or the results cannot be read or written.
pub fn run(case: &Case, options: &RunOptions) -> Result<End, RunError> {
    run_followed(case, options, &mut NoFollower)
}

/// Runs a case as [`run()`] does, with a follower that receives every sample and may end the run there.
///
/// # Errors
/// As [`run()`].
pub fn run_followed(case: &Case, options: &RunOptions, follower: &mut dyn Follower) -> Result<End, RunError> {
    require_valid(case)?;
    let mut processes = Processes::of(options);
    if options.device != Device::Processor && processes.place()[1] > 1 {
        let why = "several processes strain the soil on processors alone";
        return Err(DeviceError(why.to_owned()).into());
    }
    let _lock = processes.first_alone(|| lock(case, options))?;
    if options.start == Start::AutoResume
        && let Some(summary) = ended_before(case, options.folder)?
    {
        return Ok(End::Finished(Box::new(summary)));
    }
    if options.start == Start::Replace {
        // Variations of an earlier result are no longer of this one.
        processes.first_alone(|| Ok(clear_beside(options.folder)?))?;
    }
    run_locked_by(case, options, &Part::default(), Leader::Case(follower))
}

/// Who says how the bodies of a run move.
enum Leader<'a> {
    /// The case; with a follower of the run.
    Case(&'a mut dyn Follower),
    /// Another program.
    Steerer(&'a mut dyn Steerer),
}

/// Runs a case as [`run()`] does, as another program steers it; until that ends the run, it has the folder of
/// one that is on.
///
/// # Errors
/// As [`run()`].
pub fn run_steered(case: &Case, options: &RunOptions, steerer: &mut dyn Steerer) -> Result<End, RunError> {
    require_valid(case)?;
    let _lock = lock(case, options)?;
    if options.start == Start::Replace {
        clear_beside(options.folder)?;
    }
    run_locked_by(case, options, &Part::default(), Leader::Steerer(steerer))
}

/// Runs a case in a folder that is locked.
fn run_locked(case: &Case, options: &RunOptions, part: &Part) -> Result<End, RunError> {
    run_locked_by(case, options, part, Leader::Case(&mut NoFollower))
}

fn run_locked_by(case: &Case, options: &RunOptions, part: &Part, leader: Leader) -> Result<End, RunError> {
    match case.numerics.precision {
        resolved::Precision::Double => run_in::<f64>(case, options, part, leader),
        resolved::Precision::Single => run_in::<f32>(case, options, part, leader),
    }
}

fn run_in<R: Precision>(
    case: &Case,
    options: &RunOptions,
    part: &Part,
    leader: Leader,
) -> Result<End, RunError> {
    let began = Instant::now();
    let opened = open::<R>(case, options)?;
    run_opened(opened, began, options, part, leader)
}

/// Runs what has been opened, since `began`.
fn run_opened<R: Precision>(
    opened: Opened<R>,
    began: Instant,
    options: &RunOptions,
    part: &Part,
    leader: Leader,
) -> Result<End, RunError> {
    let Opened { mut simulation, mut fields, mut results } = opened;
    // Of several processes the first keeps the folder; the others have their soil to write.
    let quiet = options.quiet || results.is_none();
    let mut progress = Progress::start(&simulation.case, simulation.state.time, quiet).labelled(&part.label);
    let kept = (&mut fields, results.as_mut());
    let ended = observed(&mut simulation, kept, &mut progress, options, leader).and_then(|stop| {
        let kept = (&mut fields, results.as_mut());
        Ok((conclude(&simulation, &stop, kept, options.folder)?, stop))
    });
    let (summary, stop) = ended.inspect_err(|error| give_up(simulation.halo(), error))?;
    let (state, mut log) = (&simulation.state, results.map(|results| results.log));
    let mut line = |line: &str| log.as_mut().map_or(Ok(()), |log| log.line(line));
    let seconds = began.elapsed().as_secs_f64();
    match stop {
        Stop::Finished => {
            if simulation.halo().rank() == 0 {
                checkpoint::forget_previous(options.folder)?;
            }
            line(&format!("finished after {} steps, {seconds:.1} s since the start", state.step))?;
            verdict(&summary).iter().try_for_each(|own| line(own))?;
            progress.finish(&part.headed(closing_message(&summary, seconds, (options.folder, part))));
            Ok(End::Finished(Box::new(summary)))
        }
        Stop::Asked(why) => {
            line(&format!("stopped by {why} at t = {} s", state.time))?;
            progress.finish(&part.headed("stopped; --resume continues from here".to_owned()));
            let signal = options.interrupts.stopped_by().unwrap_or_default();
            Ok(End::Stopped(signal, checkpoint::path(options.folder)))
        }
        Stop::BrokenDown(cause @ Breakdown::Device { .. }) => {
            line(&format!("interrupted: {cause}"))?;
            progress.finish(&part.headed("interrupted".to_owned()));
            Err(RunError::Lost(Box::new(cause)))
        }
        Stop::BrokenDown(cause) => {
            line(&format!("broke down: {cause}"))?;
            progress.finish(&part.headed("broke down".to_owned()));
            Err(RunError::Physics {
                cause: Box::new(cause),
                folder: options.folder.to_path_buf(),
                checkpoint: checkpoint::failed_path(options.folder),
            })
        }
    }
}

/// Ends all processes when one of them cannot write its results, which the others do not know.
fn give_up(halo: &Halo, error: &RunError) {
    if !halo.is_alone() {
        let message = format!("error: process {}: {error}", halo.rank());
        progress::tell(&format!("{message}; --resume continues from the last checkpoint"), false);
        halo.abort(2);
    }
}

/// The loop of the run, in the order in which its observers get a sample. The state is written before
/// anything else that the end of the run leaves: all that can be rebuilt from it.
fn observed<R: Precision>(
    simulation: &mut Simulation<R>,
    (fields, results): (&mut FieldSeries, Option<&mut Results>),
    progress: &mut Progress,
    options: &RunOptions,
    leader: Leader,
) -> Result<Stop, RunError> {
    let (tables, books) = match results {
        Some(Results { tables, log, record, .. }) => (Some(tables), Some((log, record))),
        None => (None, None),
    };
    let (follower, steerer): (&mut dyn Follower, _) = match leader {
        Leader::Case(follower) => (follower, None),
        Leader::Steerer(steerer) => (&mut NoFollower, Some(steerer)),
    };
    let observers: &mut [&mut dyn Observer<R>] = &mut [
        &mut Tables(tables),
        &mut ProgressBar(progress),
        &mut Watch,
        &mut Fields(fields),
        &mut Followed(follower),
        &mut Signals(options.interrupts),
        &mut Checkpoints::new(options.folder, options.interrupts, books),
    ];
    Ok(match steerer {
        Some(steerer) => simulation.run_steered(observers, steerer)?,
        None => simulation.run(observers)?,
    })
}

/// Writes what the end of a run leaves, also of one that broke down or was stopped; one that was stopped
/// leaves no fields of the time at which it was.
fn conclude<R: Precision>(
    simulation: &Simulation<R>,
    stop: &Stop,
    (fields, results): (&mut FieldSeries, Option<&mut Results>),
    folder: &Path,
) -> Result<Summary, RunError> {
    let outcome = match stop {
        Stop::Finished => Outcome::Finished,
        // A lost device says nothing of the physics: a scheduler may start the run again.
        Stop::Asked(_) | Stop::BrokenDown(Breakdown::Device { .. }) => Outcome::Interrupted,
        Stop::BrokenDown(cause) => Outcome::BrokeDown(cause.to_string()),
    };
    let Simulation { case, model, state, history, .. } = simulation;
    let block = (&model.grid, simulation.halo());
    let statistics = statistics(simulation, outcome);
    if statistics.outcome != Outcome::Interrupted {
        fields.write(case, block, state, history)?;
    }
    let shown = Shown::of(case, block, state, &history.ground_left);
    let summary = match (results, shown) {
        (Some(results), Some(shown)) => {
            for StageRecord { name, from_s, to_s } in &statistics.stages {
                results.log.line(&format!("stage {name}: t = {from_s:.6} to {to_s:.6} s"))?;
            }
            Some(results.finish(case, &shown, history, &statistics)?)
        }
        _ => None,
    };
    simulation.halo().meet();
    summary.map_or_else(|| Ok(Summary::read(folder)?), Ok)
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
        Verdict::Broken => format!("ended {end}"),
        Verdict::Good | Verdict::Doubtful => {
            [vec![format!("done {end}")], verdict(summary)].concat().join("\n")
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
