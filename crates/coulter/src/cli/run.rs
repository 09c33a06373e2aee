//! `coulter run`: runs a case.

use super::{Failure, say_json};
use crate::case;
use crate::run::{self, End, Options, RunError};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Where to write the results [default: results/NAME]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Overwrite existing results
    #[arg(long, conflicts_with = "resume")]
    force: bool,
    /// Threads; 0 for one per core
    #[arg(long, value_name = "N", value_parser = super::threads())]
    threads: Option<u16>,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Go on from the last checkpoint
    #[arg(long)]
    resume: bool,
    /// Print summary.json at the end
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut case = case::load(&arguments.case, &arguments.overrides)?;
    if let Some(threads) = arguments.threads {
        case.numerics.threads = usize::from(threads);
    }
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from("results").join(&case.name));
    let text = std::fs::read_to_string(&arguments.case).map_err(|e| Failure::Request(e.to_string()))?;
    let typed = case::overridden(&text, &arguments.case.display().to_string(), &arguments.overrides)?;
    let options = Options {
        folder: &folder,
        force: arguments.force,
        resume: arguments.resume,
        quiet: arguments.json,
        stop: stop_on_signal(),
        typed: &typed,
    };
    match run::run(&case, &options) {
        Ok(End::Finished(summary)) if arguments.json => say_json(&*summary),
        Ok(End::Finished(_)) => Ok(()),
        Ok(End::Stopped(checkpoint)) => Err(Failure::Stopped(format!(
            "stopped; what there is was written, --resume goes on from {}",
            checkpoint.display()
        ))),
        Err(error @ RunError::Physics { .. }) => Err(Failure::Physics(error.to_string())),
        Err(error) => Err(Failure::Request(error.to_string())),
    }
}

/// A flag that the first Ctrl-C (or a batch system's SIGTERM) sets; the second ends the program at once.
fn stop_on_signal() -> &'static AtomicBool {
    static STOP: AtomicBool = AtomicBool::new(false);
    let heard = || {
        if STOP.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    };
    // Without a handler the signal simply ends the program: nothing that was written is lost.
    let _ = ctrlc::set_handler(heard);
    &STOP
}
