//! `coulter report`: rebuilds report.html from results.

use super::Failure;
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
        return Err(Failure::Request(format!("{shown} is no folder; name the one that `coulter run` wrote")));
    }
    Err(Failure::Request("`coulter report` is not built yet".into()))
}
