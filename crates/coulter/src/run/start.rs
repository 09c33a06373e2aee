//! How a run begins: from the start, or where an earlier one stopped.

use super::options::{RunError, RunOptions, Start};
use super::part::Part;
use crate::case::case_text;
use crate::case::{self, Case};
use crate::domain::PlacedDomain;
use crate::output::checkpoint::{self, Checkpoint};
use crate::output::folder::{Contents, Lock, Outcome, RunRecord, hash_of, inspect};
use crate::output::{
    OutputError, Results, Summary, clear_all, make_meshes_folder, overlays, require_nothing,
};
use crate::simulation::Simulation;
use solver::precision::Precision;
use std::path::Path;
use std::time::{Duration, Instant};

/// How long an automatic restart waits for an earlier run to end.
const PATIENCE: Duration = Duration::from_secs(60);

/// Locks the folder for this run.
pub(super) fn lock(options: &RunOptions) -> Result<Lock, OutputError> {
    if let Contents::Foreign = inspect(options.folder)? {
        return Err(OutputError::Foreign { path: options.folder.to_path_buf() });
    }
    let began = Instant::now();
    loop {
        match Lock::take(options.folder) {
            Err(OutputError::Busy { .. })
                if options.start == Start::AutoResume
                    && began.elapsed() < PATIENCE
                    && options.interrupts.stopped_by().is_none() =>
            {
                std::thread::sleep(Duration::from_millis(200));
            }
            other => return other,
        }
    }
}

/// The summary of the same run, if it has reached its end before.
pub(super) fn ended_before(case: &Case, folder: &Path) -> Result<Option<Summary>, RunError> {
    let Contents::Run(record) = inspect(folder)? else { return Ok(None) };
    same_case(case, &record, folder)?;
    match record.statistics.outcome {
        Outcome::Finished => Ok(Some(Summary::read(folder)?)),
        Outcome::BrokeDown(cause) => Err(RunError::BrokeDownBefore { cause, folder: folder.to_path_buf() }),
        Outcome::Running | Outcome::Interrupted => Ok(None),
    }
}

fn same_case(case: &Case, record: &RunRecord, folder: &Path) -> Result<(), RunError> {
    if record.case_hash == hash_of(case) {
        return Ok(());
    }
    Err(RunError::OtherCase(folder.to_path_buf()))
}

/// Prepares a folder for a mesh study: clears it if it is to be replaced, and records the case before any mesh is run, so that
/// the folder is known for what it is. Whether the run on the case's own mesh starts anew.
pub(super) fn begin_study(case: &Case, meshes: &[String], options: &RunOptions) -> Result<bool, RunError> {
    let folder = options.folder;
    if matches!(options.start, Start::Resume | Start::AutoResume) {
        if let Contents::Run(record) = inspect(folder)? {
            same_case(case, &record, folder)?;
            make_meshes_folder(folder)?;
            return Ok(false);
        }
    } else if options.start == Start::Replace {
        clear_all(folder)?;
    } else {
        require_nothing(folder)?;
    }
    RunRecord { meshes: meshes.to_vec(), ..RunRecord::of(case) }.write(folder)?;
    make_meshes_folder(folder)?;
    Ok(true)
}

/// The simulation and its folder, new or resumed.
pub(super) fn open<R: Precision>(
    case: &Case,
    options: &RunOptions,
    part: &Part,
) -> Result<(Simulation<R>, Results), RunError> {
    let resumes = matches!(options.start, Start::Resume | Start::AutoResume);
    if resumes && let Contents::Run(record) = inspect(options.folder)? {
        same_case(case, &record, options.folder)?;
        if checkpoint::exists(options.folder) {
            match resume(case, options, part, record.statistics.wall_seconds) {
                Err(RunError::Output(OutputError::Content { path, problem }))
                    if options.start == Start::AutoResume =>
                {
                    let why = format!("started again, because {} cannot be used: {problem}", path.display());
                    return create(case, options, part, Some(&why));
                }
                Err(RunError::Output(OutputError::Content { path, problem })) => {
                    return Err(RunError::Unusable { path, problem });
                }
                other => return other,
            }
        }
        return create(case, options, part, Some("started again, because there was no checkpoint yet"));
    }
    create(case, options, part, None)
}

fn resume<R: Precision>(
    case: &Case,
    options: &RunOptions,
    part: &Part,
    wall_s: f64,
) -> Result<(Simulation<R>, Results), RunError> {
    let (checkpoint, damaged) = Checkpoint::read(options.folder)?;
    if checkpoint.case != case_text(case) {
        return Err(RunError::OtherCase(options.folder.to_path_buf()));
    }
    let simulation = Simulation::resume(case, checkpoint, wall_s);
    let mut results = Results::resume(options.folder, case, &simulation.history, simulation.state.time)?;
    if !part.meshes.is_empty() {
        results.name_meshes(&part.meshes)?;
    }
    if let Some(problem) = damaged {
        checkpoint::forget_last(options.folder)?;
        results.log.line(&format!("fell back to the previous checkpoint: {problem}"))?;
    }
    results
        .log
        .line(&format!("resumed at t = {} s, step {}", simulation.state.time, simulation.state.step))?;
    Ok((simulation, results))
}

fn create<R: Precision>(
    case: &Case,
    options: &RunOptions,
    part: &Part,
    why: Option<&str>,
) -> Result<(Simulation<R>, Results), RunError> {
    let may_replace = options.start == Start::Replace || why.is_some();
    let mut results = Results::create(options.folder, case, may_replace)?;
    results.name_meshes(&part.meshes)?;
    results.write_case_file(case, options.typed)?;
    let simulation = Simulation::new(case);
    let Simulation { model, state, history, .. } = &simulation;
    let [nx, ny, nz] = PlacedDomain::of(&model.grid, state.grid_position).cells();
    let (dt, threads) = (model.time_step(), simulation.threads());
    results.log.line(&format!("{} version {}", case.name, env!("CARGO_PKG_VERSION")))?;
    if let Some(why) = why {
        results.log.line(why)?;
    }
    results.log.line(&format!(
        "grid {nx} x {ny} x {nz}, time step {dt:.4e} s, {} precision, {threads} threads",
        R::NAME
    ))?;
    for note in case::advice(case).iter().chain(options.warnings) {
        results.log.line(&format!("note: {note}"))?;
    }
    overlay_forecast(case, &mut results)?;
    results.fields.write(case, &model.grid, state, history)?;
    simulation.checkpoint().write(options.folder)?;
    Ok((simulation, results))
}

/// Adds the closed forms to the plots. Where they do not apply the log says why; the run does not depend on them.
fn overlay_forecast(case: &Case, results: &mut Results) -> Result<(), OutputError> {
    match overlays(case) {
        Ok(overlays) => results.overlay(overlays),
        Err(why) => results.log.line(&format!("no forecast in the plots: {why}")),
    }
}
