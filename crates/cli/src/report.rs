//! `coulter report`: rebuilds report.html from results.

use crate::common::{results_folder, say};
use crate::failure::Failure;
use coulter::output::rebuild_report_with;
use std::path::PathBuf;
use studies::comparison::Unreadable;
use studies::laid_over;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The folder of a run
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Lay the curves of another run (its folder) or of a measurement (CSV) over the plots; repeatable. They are not kept in DIR
    #[arg(long, value_name = "ITEM")]
    with: Vec<PathBuf>,
    /// The body of laid-over runs with several
    #[arg(long, value_name = "NAME", requires = "with")]
    body: Option<String>,
}

pub(super) fn report(arguments: &Arguments) -> Result<(), Failure> {
    let folder = results_folder(&arguments.folder)?;
    let mut curves = Vec::new();
    for item in &arguments.with {
        curves.extend(laid_over(item, arguments.body.as_deref()).map_err(|error| match error {
            Unreadable::Case(error) => Failure::Case(error),
            Unreadable::Other(why) => Failure::Request(why),
        })?);
    }
    let report = rebuild_report_with(folder, &curves).map_err(|e| Failure::Request(e.to_string()))?;
    say(&format!("{}\n", report.display()))
}
