//! The study that a command is given.

use super::folder::{Expanded, expanded};
use crate::failure::Failure;
use std::path::PathBuf;

/// The study file, and where its folder is.
#[derive(Debug, clap::Args)]
pub(super) struct Source {
    /// The study file
    #[arg(value_name = "STUDY.toml", required = true)]
    pub(super) study: Option<PathBuf>,
    /// The quick version: fewer levels, cheaper runs, as the study file says
    #[arg(long)]
    pub(super) quick: bool,
    /// Folder of the study [default: results/NAME, of the quick version results/NAME_quick]
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
}

impl Source {
    /// The study, read, expanded and written into its folder.
    pub(super) fn expanded(&self) -> Result<Expanded, Failure> {
        expanded(&self.study.clone().unwrap_or_default(), self.quick, self.output.as_deref())
    }
}
