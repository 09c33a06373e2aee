//! How a run begins: from the start, or where an earlier one stopped.

use super::on_device;
use super::options::{RunError, RunOptions, Start};
use super::processes::Processes;
use crate::blocks;
use crate::output::overlays;
use crate::simulation::Simulation;
use case::Case;
use case::case_text;
use case::model::model;
use report::{Results, Summary, write_case_file};
use results::OutputError;
use results::checkpoint::{self, Checkpoint};
use results::folder::{Contents, Lock, Outcome, RunRecord, hash_of, inspect};
use results::vtk::FieldSeries;
use solver::device::{DeviceError, Driver};
use solver::grid::Grid;
use solver::model::Model;
use solver::precision::Precision;
use std::path::Path;
use std::time::{Duration, Instant};

/// How long an automatic restart waits for an earlier run to end.
const PATIENCE: Duration = Duration::from_secs(60);

/// Locks the folder for this run, if the device that it asks for is there and can run the case.
pub(super) fn lock(case: &Case, options: &RunOptions) -> Result<Lock, RunError> {
    if let Some(why) = objection(case, options)? {
        return Err(DeviceError(why).into());
    }
    Ok(lock_folder(options)?)
}

/// Why the device that a run asks for cannot run a case, if it cannot.
///
/// # Errors
/// [`DeviceError`] if there is no such device.
pub(super) fn objection(case: &Case, options: &RunOptions) -> Result<Option<String>, DeviceError> {
    let Some(driver) = options.device.open()? else { return Ok(None) };
    Ok(on_device::require(case, &*driver).err().map(|error| error.0))
}

fn lock_folder(options: &RunOptions) -> Result<Lock, OutputError> {
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

/// A run that is about to begin or to go on.
pub(super) struct Opened<R: Precision> {
    pub(super) simulation: Simulation<R>,
    pub(super) fields: FieldSeries,
    /// The folder, in the first of several processes.
    pub(super) results: Option<Results>,
}

/// The simulation and its folder, new or resumed.
pub(super) fn open<R: Precision>(case: &Case, options: &RunOptions) -> Result<Opened<R>, RunError> {
    let mut processes = Processes::of(options);
    let resumes = matches!(options.start, Start::Resume | Start::AutoResume);
    let grid = blocks::of_case::<R>(case, processes.place())?;
    let found = if resumes { inspect(options.folder)? } else { Contents::Nothing };
    let exists = checkpoint::exists(options.folder);
    // The first process must not begin to change the folder before all have looked at it.
    processes.agree(Ok(()))?;
    let Contents::Run(record) = found else { return create(case, options, (processes, None)) };
    same_case(case, &record, options.folder)?;
    if !exists {
        let why = "started again, because there was no checkpoint yet".to_owned();
        return create(case, options, (processes, Some(why)));
    }
    match read_checkpoint(case, &grid, options, &mut processes) {
        Ok(read) => resume(case, options, (processes, read, record.statistics.wall_seconds)),
        Err(RunError::Output(OutputError::Content { path, problem })) => match options.start {
            Start::AutoResume => {
                let why = format!("started again, because {} cannot be used: {problem}", path.display());
                create(case, options, (processes, Some(why)))
            }
            _ => Err(RunError::Unusable { path, problem }),
        },
        Err(other) => Err(other),
    }
}

/// The last checkpoint that all processes can read, and what is wrong with the last of all, if it is not
/// that.
fn read_checkpoint<R: Precision>(
    case: &Case,
    grid: &Grid,
    options: &RunOptions,
    processes: &mut Processes,
) -> Result<(Checkpoint<R>, Option<String>), RunError> {
    let folder = options.folder;
    let (text, model) = (case_text(case), Model { grid: grid.clone(), ..model(case, R::LANES) });
    let whole = |checkpoint: Checkpoint<R>| {
        // That of another case is whole, and is refused as such.
        if checkpoint.case != text || checkpoint.is_of(case, &model) {
            return Ok(checkpoint);
        }
        let what = "it does not hold what a checkpoint of its case holds";
        Err(OutputError::content(&checkpoint::path(folder), what))
    };
    let mut all = |read: Result<Checkpoint<R>, OutputError>| match read.and_then(whole) {
        Ok(_) if processes.is_anyone(false) => {
            Err(OutputError::content(&checkpoint::path(folder), "another process cannot read its portion"))
        }
        Ok(checkpoint) => Ok(checkpoint),
        Err(error) => {
            processes.is_anyone(true);
            Err(error)
        }
    };
    let (checkpoint, damaged) = match all(Checkpoint::read_last(folder, grid)) {
        Ok(checkpoint) => (checkpoint, None),
        Err(last) => match all(Checkpoint::read_previous(folder, grid)) {
            Ok(checkpoint) => (checkpoint, Some(last.to_string())),
            Err(_) => return Err(last.into()),
        },
    };
    if checkpoint.case != text {
        return Err(RunError::OtherCase(folder.to_path_buf()));
    }
    Ok((checkpoint, damaged))
}

fn resume<R: Precision>(
    case: &Case,
    options: &RunOptions,
    (mut processes, (checkpoint, damaged), wall_s): (Processes, (Checkpoint<R>, Option<String>), f64),
) -> Result<Opened<R>, RunError> {
    let (history, time, step) = (checkpoint.history.clone(), checkpoint.state.time, checkpoint.state.step);
    let driver = options.device.open()?;
    let results = processes.first_alone(|| {
        let mut results = Results::resume(options.folder, case, &history)?;
        if let Some(problem) = damaged {
            checkpoint::forget_last(options.folder)?;
            results.log.line(&format!("fell back to the previous checkpoint: {problem}"))?;
        }
        results.log.line(&format!("resumed at t = {time} s, step {step}"))?;
        Ok(results)
    })?;
    let fields = FieldSeries::resume(options.folder, time)?;
    let mut simulation = Simulation::resume_block(case, checkpoint, processes.into_communicator(), wall_s)?;
    let results = strained_by(&mut simulation, driver, results)?;
    Ok(Opened { simulation, fields, results })
}

fn create<R: Precision>(
    case: &Case,
    options: &RunOptions,
    (mut processes, why): (Processes, Option<String>),
) -> Result<Opened<R>, RunError> {
    let driver = options.device.open()?;
    let may_replace = options.start == Start::Replace || why.is_some();
    let mut results = processes.first_alone(|| {
        let results = Results::create(options.folder, case, may_replace)?;
        write_case_file(results.dir(), case, options.typed)?;
        Ok(results)
    })?;
    let mut fields = FieldSeries::create(options.folder)?;
    let mut simulation = Simulation::<R>::of_block(case, processes.into_communicator())?;
    results = strained_by(&mut simulation, driver, results)?;
    if let Some(results) = &mut results {
        log_start(&simulation, results, (options, why))?;
        overlay_forecast(case, results)?;
    }
    let Simulation { model, state, history, .. } = &simulation;
    fields.write(case, (&model.grid, simulation.halo()), state, history)?;
    simulation.checkpoint().write(options.folder)?;
    Ok(Opened { simulation, fields, results })
}

/// Has a device strain the soil, if one is asked for, and says so in the log.
fn strained_by<R: Precision>(
    simulation: &mut Simulation<R>,
    driver: Option<Box<dyn Driver>>,
    mut results: Option<Results>,
) -> Result<Option<Results>, RunError> {
    if let Some(driver) = driver {
        let name = driver.name().to_owned();
        simulation.use_device(driver)?;
        if let Some(results) = &mut results {
            results.log.line(&format!("the soil is strained by {name}"))?;
        }
    }
    Ok(results)
}

/// What the log says at the start of a run.
fn log_start<R: Precision>(
    simulation: &Simulation<R>,
    results: &mut Results,
    (options, why): (&RunOptions, Option<String>),
) -> Result<(), OutputError> {
    let Simulation { case, model, .. } = simulation;
    let [nx, ny, nz] = model.grid.domain.clone().map(|layers| layers.len());
    let (dt, threads) = (model.time_step(), simulation.threads());
    let log = &mut results.log;
    log.line(&format!("{} version {}", case.name, env!("CARGO_PKG_VERSION")))?;
    if let Some(why) = why {
        log.line(&why)?;
    }
    let processes = match simulation.halo().blocks() {
        1 => String::new(),
        count => format!("{count} processes, each with "),
    };
    log.line(&format!(
        "grid {nx} x {ny} x {nz}, time step {dt:.4e} s, {} precision, {processes}{threads} threads",
        R::NAME
    ))?;
    for note in case::advice(case).iter().chain(options.warnings) {
        log.line(&format!("note: {note}"))?;
    }
    Ok(())
}

/// Adds the closed forms to the plots. Where they do not apply the log says why; the run does not depend on
/// them.
fn overlay_forecast(case: &Case, results: &mut Results) -> Result<(), OutputError> {
    match overlays(case) {
        Ok(overlays) => results.overlay(overlays),
        Err(why) => results.log.line(&format!("no forecast in the plots: {why}")),
    }
}
