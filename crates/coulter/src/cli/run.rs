//! `coulter run`: runs a case.

use super::Failure;
use crate::case;
use std::path::PathBuf;

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
    #[arg(long, value_name = "N")]
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
    let taken = folder.read_dir().is_ok_and(|mut entries| entries.next().is_some());
    if taken && !arguments.force && !arguments.resume {
        let shown = folder.display();
        return Err(Failure::Request(format!(
            "{shown} holds results; --force overwrites them, --resume goes on with them, -o DIR writes elsewhere"
        )));
    }
    let _ = arguments.json;
    Err(Failure::Request("`coulter run` is not built yet".into()))
}
