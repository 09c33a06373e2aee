//! `coulter run`: runs a case.

use crate::common::say_json;
use crate::failure::Failure;
use crate::signals;
use coulter::case::estimate::{self, Cost};
use coulter::case::meshes::{self, CoarserMesh};
use coulter::case::{self, Case};
use coulter::output::{OutputError, checkpoint};
use coulter::run::{self, End, RunError, RunOptions, Start};
use coulter::trust::Verdict;
use std::io::Write;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Where to write the results [default: results/NAME]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Overwrite existing results
    #[arg(long, conflicts_with_all = ["resume", "auto_resume"])]
    force: bool,
    /// Threads; 0 for one per core
    #[arg(long, value_name = "N", value_parser = crate::common::threads())]
    threads: Option<u16>,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Take soil under water for drained, whatever its drainage number
    #[arg(long)]
    accept_drained: bool,
    /// Resume from the last checkpoint; start if there is none yet
    #[arg(long)]
    resume: bool,
    /// For schedulers: start, resume, or leave a finished run unchanged
    #[arg(long, conflicts_with = "resume")]
    auto_resume: bool,
    /// Run the case on N meshes, each with cells 1.5 times as wide as the next, to get intervals of drag, vertical force,
    /// sinkage and turn ratio; 3 is usual. The finest is the case's own. Takes about 1.25 times as long as
    /// without, in plane strain some 1.7 times; `check --meshes N` has the figure
    #[arg(long, value_name = "N", value_parser = crate::common::meshes())]
    meshes: Option<usize>,
    /// Print summary.json at the end
    #[arg(long)]
    json: bool,
}

impl Arguments {
    fn start(&self) -> Start {
        match (self.force, self.resume, self.auto_resume) {
            (true, ..) => Start::Replace,
            (_, true, _) => Start::Resume,
            (.., true) => Start::AutoResume,
            _ => Start::Anew,
        }
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    // Before anything else: a signal during the start must be handled like a later one.
    let interrupts = signals::listen();
    let overrides = crate::common::overrides(&arguments.overrides, arguments.accept_drained);
    let mut case = case::load(&arguments.case, &overrides)?;
    if let Some(threads) = arguments.threads {
        case.numerics.threads = usize::from(threads);
    }
    let text = case::text(&arguments.case)?;
    let source_name = arguments.case.display().to_string();
    let typed = case::overridden(&text, &source_name, &overrides)?;
    let coarser = match arguments.meshes {
        Some(count) => meshes::coarser(&case, &typed, &source_name, count)?,
        None => Vec::new(),
    };
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from("results").join(&case.name));
    crate::common::refuse_file(&folder)?;
    let warnings = case::resources::warnings(&cost(&case, &coarser), &folder);
    for warning in &warnings {
        // Where standard error cannot be written, the log still has it.
        let _ = writeln!(std::io::stderr().lock(), "warning: {warning}");
    }
    let options = RunOptions {
        folder: &folder,
        start: arguments.start(),
        quiet: arguments.json,
        warnings: &warnings,
        interrupts: &interrupts,
        typed: &typed,
    };
    let end = match coarser.as_slice() {
        [] => run::run(&case, &options),
        coarser => run::run_meshes(&case, coarser, &options),
    };
    conclude(end, &options, arguments)
}

/// The cost of a case, with the space that the results of the coarser meshes take.
fn cost(case: &Case, coarser: &[CoarserMesh]) -> Cost {
    let mut cost = estimate::cost(case);
    for mesh in coarser {
        cost.output.total_bytes += estimate::cost(&mesh.case).output.total_bytes;
    }
    cost
}

/// What the end of a run means to the caller of the command.
fn conclude(end: Result<End, RunError>, options: &RunOptions, arguments: &Arguments) -> Result<(), Failure> {
    match end {
        Ok(End::Finished(summary)) => {
            if arguments.json {
                say_json(&*summary)?;
            }
            if summary.trust.verdict == Verdict::Broken {
                let why = run::verdict(&summary).join("\n");
                return Err(Failure::Physics(format!("the result must not be used\n{why}")));
            }
            Ok(())
        }
        Ok(End::Stopped(signal, checkpoint)) => Err(Failure::Stopped {
            signal,
            message: format!(
                "stopped; the results so far were written, {}--resume continues from {}",
                arguments.meshes.map_or(String::new(), |count| format!("--meshes {count} ")),
                checkpoint.display()
            ),
        }),
        Err(error @ (RunError::Physics { .. } | RunError::BrokeDownBefore { .. })) => {
            Err(Failure::Physics(error.to_string()))
        }
        Err(RunError::Case(error)) => Err(error.into()),
        Err(error) => Err(refusal(&error, options)),
    }
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
