//! Runs of the solver for a calibration: each in a folder of its own, left where it is, resumed where it was
//! stopped.

use super::closed::first_problem;
use super::data::MeasuredCurve;
use super::space::Space;
use crate::files;
use crate::measured::Record;
use crate::sheet::short;
use crate::sources::{RunSource, local_means, read_run, rising};
use coulter::case::{self, Case, CaseError};
use coulter::interrupts::Interrupts;
use coulter::output::Inside;
use coulter::run::{self, Device, End, RunError, RunOptions, Start};
use coulter::trust::Verdict;
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::xxh3_64;

/// How a run of the solver at values of the unknowns went.
#[derive(Clone, Debug, PartialEq)]
pub enum RunOutcome {
    /// The curves of the run: values as residuals see them.
    Curves(Vec<f64>),
    /// The run is broken, or its curves do not reach where was measured.
    Failed(String),
    /// The case refuses the values; nothing was run.
    Refused(String),
}

/// One point of the design, with what the solver made of it.
#[derive(Clone, Debug, PartialEq)]
pub struct SolverPoint {
    /// Values of the unknowns.
    pub values: Vec<f64>,
    /// Folders of the runs at the point, one for each measurement with keys of its own.
    pub folders: Vec<PathBuf>,
    /// Outcome of the runs.
    pub outcome: RunOutcome,
    /// The worst grade of the runs.
    pub verdict: Option<Verdict>,
}

/// Why the solver cannot go on.
#[derive(Debug, thiserror::Error)]
pub enum SolverError {
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A signal stopped the solver.
    #[error("stopped")]
    Stopped(i32),
    /// A folder or a file; says what to do.
    #[error("{0}")]
    Other(String),
}

/// What all runs have in common.
#[derive(Debug)]
pub struct Solver<'a> {
    /// The case file.
    pub case: &'a Path,
    /// Keys of the case that are set besides the unknowns.
    pub overrides: &'a [String],
    /// The unknowns.
    pub space: &'a Space,
    /// The measurements.
    pub records: &'a [Record],
    /// The measured curves that are taken from each run.
    pub curves: &'a [MeasuredCurve],
    /// Where the folders of the runs lie.
    pub folder: &'a Path,
    /// Threads of a run; `None` for what the case says.
    pub threads: Option<usize>,
    /// What strains the soil.
    pub device: Device,
    /// Requests to stop.
    pub interrupts: &'a Interrupts,
}

impl Solver<'_> {
    /// The case of a measurement at values, and its text.
    fn case(&self, record: &Record, values: &[f64]) -> Result<(Case, String, Vec<String>), CaseError> {
        let name = self.case.display().to_string();
        let unknowns = self.space.overrides(values);
        let unknowns = unknowns.map_err(|why| CaseError::unreadable(&name, why, "narrow the priors"))?;
        let all = [self.overrides, &unknowns, &record.settings].concat();
        let mut case = case::load(self.case, &all)?;
        if let Some(threads) = self.threads {
            case.numerics.threads = threads;
        }
        let typed = case::overridden(&case::text(self.case)?, &name, &all)?;
        Ok((case, typed, all))
    }

    /// Why the case refuses values; `None` where it can be run.
    #[must_use]
    pub fn refusal(&self, values: &[f64]) -> Option<String> {
        let unknowns = match self.space.overrides(values) {
            Ok(unknowns) => unknowns,
            Err(why) => return Some(why),
        };
        let problem = |record: &Record| {
            let all = [self.overrides, &unknowns, &record.settings].concat();
            case::load(self.case, &all).err().map(|error| first_problem(&error))
        };
        // Keys of a single measurement do not decide whether values of the soil are possible.
        self.records.first().and_then(problem)
    }

    /// Runs the case at values, or reads what was run before.
    ///
    /// # Errors
    /// [`SolverError`] where a signal stops it or a folder cannot be used.
    pub fn run(&self, values: &[f64]) -> Result<SolverPoint, SolverError> {
        let mut point = SolverPoint {
            values: values.to_vec(),
            folders: Vec::new(),
            outcome: RunOutcome::Curves(Vec::new()),
            verdict: None,
        };
        let mut sources: Vec<(Vec<String>, RunSource)> = Vec::new();
        for (number, record) in self.records.iter().enumerate() {
            let known = sources.iter().position(|(settings, _)| *settings == record.settings);
            let source = match known {
                Some(known) => known,
                None => match self.one(record, values, &mut point)? {
                    Ok(source) => {
                        sources.push((record.settings.clone(), source));
                        sources.len() - 1
                    }
                    Err(outcome) => {
                        point.outcome = outcome;
                        return Ok(point);
                    }
                },
            };
            let curves = self.curves.iter().filter(|curve| curve.record == number);
            for curve in curves {
                if let Some(why) = apart(curve, &sources[source].1) {
                    return Err(SolverError::Other(why));
                }
                match (taken(curve, &sources[source].1), &mut point.outcome) {
                    (Ok(values), RunOutcome::Curves(list)) => list.extend(values),
                    (Err(why), outcome) => *outcome = RunOutcome::Failed(why),
                    _ => {}
                }
            }
        }
        Ok(point)
    }

    /// The run of one measurement.
    fn one(
        &self,
        record: &Record,
        values: &[f64],
        point: &mut SolverPoint,
    ) -> Result<Result<RunSource, RunOutcome>, SolverError> {
        let (case, typed, all) = match self.case(record, values) {
            Ok(found) => found,
            Err(error) => return Ok(Err(RunOutcome::Refused(first_problem(&error)))),
        };
        let name = format!("{:016x}", xxh3_64(all.join("\n").as_bytes()));
        let folder = files::folder(&Inside::of(self.folder, name));
        let folder = folder.map_err(|error| SolverError::Other(error.to_string()))?;
        point.folders.push(folder.clone());
        let path = self.case.display().to_string();
        let options = RunOptions {
            device: self.device,
            ..RunOptions::quiet(&folder, Start::AutoResume, &typed, &path, self.interrupts)
        };
        match run::run(&case, &options) {
            Ok(End::Finished(summary)) => {
                let verdict = summary.trust.verdict;
                point.verdict = Some(point.verdict.map_or(verdict, |worst| worst.max(verdict)));
                if verdict == Verdict::Broken {
                    let why = run::verdict(&summary).join("; ");
                    return Ok(Err(RunOutcome::Failed(format!("graded broken: {why}"))));
                }
                let source = read_run(&folder, None).map_err(SolverError::Other)?;
                Ok(Ok(source))
            }
            Ok(End::Stopped(signal, _)) => Err(SolverError::Stopped(signal)),
            Err(error @ (RunError::Physics { .. } | RunError::BrokeDownBefore { .. })) => {
                point.verdict = Some(Verdict::Broken);
                Ok(Err(RunOutcome::Failed(error.to_string().lines().next().unwrap_or_default().to_owned())))
            }
            Err(error) => Err(SolverError::Other(error.to_string())),
        }
    }
}

/// The values of a curve from a run, as residuals see them.
fn taken(curve: &MeasuredCurve, source: &RunSource) -> Result<Vec<f64>, String> {
    let values = match curve.abscissa {
        None => {
            let mean = source.steady_mean(curve.quantity);
            vec![mean.map(|(mean, _)| mean)]
        }
        Some(abscissa) => {
            let x = source.record.values(abscissa).ok_or_else(|| missing(curve, abscissa.name()))?;
            let y =
                source.record.values(curve.quantity).ok_or_else(|| missing(curve, curve.quantity.name()))?;
            local_means(&rising(x, y), &curve.at)
        }
    };
    let seen = |(point, value): (usize, &Option<f64>)| {
        let value =
            value.ok_or_else(|| format!("{}: the run does not reach {}", curve.name, curve.at[point]))?;
        let why = || format!("{}: {value} at {} has no logarithm", curve.name, curve.at[point]);
        curve.seen(point, value).ok_or_else(why)
    };
    values.iter().enumerate().map(seen).collect()
}

/// Why a curve and a run have no point in common, which no values of the unknowns change.
fn apart(curve: &MeasuredCurve, source: &RunSource) -> Option<String> {
    let abscissa = curve.abscissa?;
    let ends = |values: &[f64]| {
        values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(*v), high.max(*v)])
    };
    let [run, measured] = [ends(source.record.values(abscissa)?), ends(&curve.at)];
    (measured[0] > run[1] || measured[1] < run[0]).then(|| {
        let shown = |[low, high]: [f64; 2]| format!("{} to {} {}", short(low), short(high), abscissa.unit());
        format!(
            "{}: measured at a {} of {}, and the run goes from {}: no point in common; check units and signs of the file, and how far the \
             case goes",
            curve.name,
            abscissa.name(),
            shown(measured),
            shown(run)
        )
    })
}

fn missing(curve: &MeasuredCurve, column: &str) -> String {
    format!("{}: a run has no {column}; measure along displacement, sinkage or time", curve.name)
}
