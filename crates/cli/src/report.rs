//! `coulter report`: rebuilds report.html from results.

use crate::common::say;
use crate::failure::Failure;
use coulter::output::rebuild_report;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The folder of a run
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

pub(super) fn report(arguments: &Arguments) -> Result<(), Failure> {
    if !arguments.folder.is_dir() {
        let shown = arguments.folder.display();
        return Err(Failure::Request(format!(
            "{shown} is not a folder; name the one that `coulter run` wrote"
        )));
    }
    let report = rebuild_report(&arguments.folder).map_err(|e| Failure::Request(e.to_string()))?;
    say(&format!("{}\n", report.display()))
}
