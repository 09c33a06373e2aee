//! `coulter run`: runs a case.

use crate::common::say_json;
use crate::failure::Failure;
use crate::signals;
use coulter::case;
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
    /// Resume from the last checkpoint; start if there is none yet
    #[arg(long)]
    resume: bool,
    /// For schedulers: start, resume, or leave a finished run unchanged
    #[arg(long, conflicts_with = "resume")]
    auto_resume: bool,
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
    let mut case = case::load(&arguments.case, &arguments.overrides)?;
    if let Some(threads) = arguments.threads {
        case.numerics.threads = usize::from(threads);
    }
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from("results").join(&case.name));
    crate::common::refuse_file(&folder)?;
    let warnings = case::resources::warnings(&case::estimate::cost(&case), &folder);
    for warning in &warnings {
        // Where standard error cannot be written, the log still has it.
        let _ = writeln!(std::io::stderr().lock(), "warning: {warning}");
    }
    let text = std::fs::read_to_string(&arguments.case).map_err(|e| Failure::Request(e.to_string()))?;
    let typed = case::overridden(&text, &arguments.case.display().to_string(), &arguments.overrides)?;
    let options = RunOptions {
        folder: &folder,
        start: arguments.start(),
        quiet: arguments.json,
        warnings: &warnings,
        interrupts: &interrupts,
        typed: &typed,
    };
    match run::run(&case, &options) {
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
                "stopped; the results so far were written, --resume continues from {}",
                checkpoint.display()
            ),
        }),
        Err(error @ (RunError::Physics { .. } | RunError::BrokeDownBefore { .. })) => {
            Err(Failure::Physics(error.to_string()))
        }
        Err(RunError::Case(error)) => Err(error.into()),
        Err(error) => Err(refusal(&error, &options)),
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
