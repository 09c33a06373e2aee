//! `coulter export-fields`: the fields of a run under the names of Abaqus.

use crate::common::{results_folder, say};
use crate::failure::Failure;
use coulter::output::vtkhdf::write_vtkhdf;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The folder of a run; soil.vtkhdf and body_NAME.vtkhdf are written, or replaced, in DIR/fields
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let written = write_vtkhdf(results_folder(&arguments.folder)?);
    let files = written.map_err(|error| Failure::Request(error.to_string()))?;
    say(&files.iter().map(|file| format!("{}\n", file.display())).collect::<String>())
}
