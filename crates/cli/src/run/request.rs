//! A request to run a case, from whoever makes it: read, checked, and run.

use crate::common::{MOST_THREADS, refuse_file, require_range};
use crate::failure::Failure;
use crate::processes;
use coulter::case::estimate::{self, Cost};
use coulter::case::{self, Case, cores};
use coulter::confidence::variations::{Asked, ErrorSource, MESHES, VariationPlan, variations};
use coulter::interrupts::Interrupts;
use coulter::output::{OutputError, Summary, checkpoint};
use coulter::run::{self, Accuracy, Budget, Device, End, Follower, Request, RunError, RunOptions, Start};
use coulter::simulation::Steerer;
use coulter::trust::Verdict;
use std::path::PathBuf;

/// What is to be run, and how.
#[derive(Clone, Debug)]
pub struct RunRequest {
    /// The text of the case file.
    pub text: String,
    /// Path of the case, as it was given.
    pub source_name: String,
    /// Keys that are set, such as `soil.friction_angle=38 deg`.
    pub overrides: Vec<String>,
    /// Results folder; by default `results/NAME`.
    pub output: Option<PathBuf>,
    /// What to do with a folder that holds a run.
    pub start: Start,
    /// Threads of each process, 0 for as many as [`cores::threads_by_default`]; by default those of the case.
    pub threads: Option<u16>,
    /// Which variations to run, and how long they may take together, if there is a limit.
    pub variations: Option<(Asked, Option<Budget>)>,
    /// How accurate the figures are to be on cells that the run chooses.
    pub accuracy: Option<Accuracy>,
    /// Show no progress.
    pub quiet: bool,
    /// What strains the soil.
    pub device: Device,
}

/// A run that is ready to begin.
#[derive(Debug)]
pub struct PreparedRun {
    /// The case.
    pub case: Case,
    /// Results folder.
    pub folder: PathBuf,
    /// Warnings that memory or disk space may not suffice.
    pub warnings: Vec<String>,
    start: Start,
    quiet: bool,
    device: Device,
    typed: String,
    source_name: String,
    plan: Option<(VariationPlan, Option<Budget>)>,
    accuracy: Option<Accuracy>,
    /// The option that asks for more than the case itself, followed by a space.
    option: String,
}

impl RunRequest {
    /// Reads the case and plans what is run beside it; runs nothing.
    ///
    /// # Errors
    /// [`Failure`] where the case or the request is wrong.
    pub fn prepare(&self) -> Result<PreparedRun, Failure> {
        require_range("threads", self.threads.map(usize::from), 0..=MOST_THREADS)?;
        require_range("meshes", self.variations.as_ref().map(|(asked, _)| asked.meshes), MESHES)?;
        if self.accuracy.as_ref().is_some_and(|accuracy| accuracy.without.contains(&ErrorSource::Mesh)) {
            let why = "accuracy chooses the cells: the mesh cannot be left out of it";
            return Err(Failure::Request(why.to_owned()));
        }
        let mut case = case::parse(&self.text, &self.source_name, &self.overrides)?;
        if let Some(threads) = self.threads {
            case.numerics.threads = usize::from(threads);
        }
        let typed = case::overridden(&self.text, &self.source_name, &self.overrides)?;
        let plan = match &self.variations {
            Some((asked, budget)) => Some((variations(&case, &typed, &self.source_name, asked)?, *budget)),
            None => None,
        };
        let option = match &self.variations {
            _ if self.accuracy.is_some() => "--accuracy … ".to_owned(),
            Some((_, Some(_))) => "--confidence ".to_owned(),
            Some((asked, None)) => format!("--meshes {} ", asked.meshes),
            None => String::new(),
        };
        let folder = self.output.clone().unwrap_or_else(|| PathBuf::from("results").join(&case.name));
        refuse_file(&folder)?;
        let cost = cost(&case, plan.as_ref().map(|(plan, _)| plan));
        let mut warnings = case::resources::warnings(&cost, &folder);
        if case.numerics.threads == 0 {
            warnings.extend(cores::threads_by_default().notes);
        }
        let (start, quiet) = (self.start, self.quiet);
        Ok(PreparedRun {
            case,
            folder,
            warnings,
            start,
            quiet,
            device: self.device,
            typed,
            source_name: self.source_name.clone(),
            plan,
            accuracy: self.accuracy.clone(),
            option,
        })
    }
}

/// The cost of a case, with the space that the results of its variations take, and the memory of the largest.
fn cost(case: &Case, plan: Option<&VariationPlan>) -> Cost {
    let mut cost = estimate::cost(case);
    let varied = plan.iter().flat_map(|plan| plan.variations.iter().map(|variation| &variation.case));
    for beside in varied {
        let beside = estimate::cost(beside);
        cost.output.total_bytes += beside.output.total_bytes;
        cost.memory_bytes = cost.memory_bytes.max(beside.memory_bytes);
    }
    cost
}

impl PreparedRun {
    fn options<'a>(&'a self, interrupts: &'a Interrupts) -> RunOptions<'a> {
        RunOptions {
            folder: &self.folder,
            start: self.start,
            quiet: self.quiet,
            warnings: &self.warnings,
            interrupts,
            typed: &self.typed,
            source_name: &self.source_name,
            communicator: processes::communicator,
            device: self.device,
        }
    }

    /// Runs the case to its end, or until `interrupts` ask to stop; `follower` gets every sample of a case
    /// that is run without others beside it, and may stop it. The summary may be that of a broken run:
    /// see [`graded`].
    ///
    /// # Errors
    /// [`Failure`] where the run broke down, was stopped (signal 0: by the follower), or could not read or
    /// write its results.
    pub fn run(&self, interrupts: &Interrupts, follower: &mut dyn Follower) -> Result<Box<Summary>, Failure> {
        let options = self.options(interrupts);
        let end = match (&self.accuracy, &self.plan) {
            (Some(accuracy), _) => run::run_accuracy(&self.case, accuracy, &options),
            (None, Some((plan, budget))) => {
                run::run_confidence(&self.case, Request { plan, budget: *budget }, &options)
            }
            (None, None) => run::run_followed(&self.case, &options, follower),
        };
        self.conclude(end, &options)
    }

    /// Runs the case as another program steers it, as [`PreparedRun::run`].
    ///
    /// # Errors
    /// As [`PreparedRun::run`].
    pub fn run_steered(
        &self,
        interrupts: &Interrupts,
        steerer: &mut dyn Steerer,
    ) -> Result<Box<Summary>, Failure> {
        let options = self.options(interrupts);
        self.conclude(run::run_steered(&self.case, &options, steerer), &options)
    }

    /// What the end of a run means to whoever asked for it.
    fn conclude(&self, end: Result<End, RunError>, options: &RunOptions) -> Result<Box<Summary>, Failure> {
        match end {
            Ok(End::Finished(summary)) => Ok(summary),
            Ok(End::Stopped(signal, checkpoint)) => Err(Failure::Stopped {
                signal,
                message: format!(
                    "stopped; the results so far were written, {}--resume continues from {}",
                    self.option,
                    checkpoint.display()
                ),
            }),
            Err(error @ (RunError::Physics { .. } | RunError::BrokeDownBefore { .. })) => {
                Err(Failure::Physics(error.to_string()))
            }
            Err(error @ RunError::Lost(_)) => Err(Failure::Request(format!(
                "{error}\n{}--resume continues from the last checkpoint, without --device on the processor",
                self.option
            ))),
            Err(RunError::Case(error)) => Err(error.into()),
            Err(RunError::Elsewhere) => Err(Failure::Elsewhere(2)),
            Err(error) => Err(refusal(&error, options)),
        }
    }
}

/// A result that may be used.
///
/// # Errors
/// [`Failure::Physics`] where it is graded broken.
pub fn graded(summary: &Summary) -> Result<(), Failure> {
    if summary.trust.verdict == Verdict::Broken {
        let why = run::verdict(summary).join("\n");
        return Err(Failure::Physics(format!("the result must not be used\n{why}")));
    }
    Ok(())
}

/// Why a run could not be started, or its results not be written.
fn refusal(error: &RunError, options: &RunOptions) -> Failure {
    let message = error.to_string();
    match (error, options.interrupts.stopped_by()) {
        // Stopped while waiting for the lock.
        (RunError::Output(OutputError::Busy { .. }), Some(signal)) => Failure::Stopped { signal, message },
        (RunError::Output(OutputError::File { .. }), _) if checkpoint::exists(options.folder) => {
            Failure::Request(format!(
                "{message}\nearlier results are intact; once this is fixed, --resume continues from the last checkpoint"
            ))
        }
        _ => Failure::Request(message),
    }
}
