//! `coulter report`: rebuilds report.html from results.

use crate::common::{choices, results_folder, say};
use crate::failure::Failure;
use coulter::output::plots::Units;
use coulter::output::{ReportWishes, rebuild_report_with};
use std::path::PathBuf;
use studies::comparison::Unreadable;
use studies::laid_over;
use studies::measured::{Record, refuse_unused};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The folder of a run
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Lay the curves of another run (its folder) or of a measurement (CSV) over the plots; repeatable. They
    /// are not kept in DIR
    #[arg(long, value_name = "ITEM")]
    with: Vec<PathBuf>,
    /// Draw lengths over d, forces over γtd², and torques over γtd³
    #[arg(long)]
    dimensionless: bool,
    /// What a column of a measured file is: COLUMN=QUANTITY, COLUMN="-QUANTITY [UNIT]" of the other sign,
    /// COLUMN=- to leave it out; may be repeated
    #[arg(long = "column", value_name = "COLUMN=QUANTITY", requires = "with")]
    columns: Vec<String>,
    /// The body of laid-over runs with several
    #[arg(long, value_name = "NAME", requires = "with")]
    body: Option<String>,
}

pub(super) fn report(arguments: &Arguments) -> Result<(), Failure> {
    let folder = results_folder(&arguments.folder)?;
    let choices = choices(&arguments.columns)?;
    let (mut curves, mut records) = (Vec::new(), Vec::new());
    for item in &arguments.with {
        let found = laid_over(item, folder, arguments.body.as_deref(), &choices);
        let (laid, record) = found.map_err(|error| match error {
            Unreadable::Case(error) => Failure::Case(error),
            Unreadable::Other(why) => Failure::Request(why),
        })?;
        curves.extend(laid);
        records.push(record);
    }
    refuse_unused(&choices, records.iter()).map_err(Failure::Request)?;
    let remarks: Vec<String> = records.iter().flat_map(Record::named_remarks).collect();
    let notes: String = remarks.iter().map(|remark| format!("note: {remark}\n")).collect();
    let units = if arguments.dimensionless { Units::Dimensionless } else { Units::Readable };
    let report = rebuild_report_with(folder, ReportWishes { laid_over: curves, remarks, units });
    let report = report.map_err(|e| Failure::Request(e.to_string()))?;
    say(&format!("{notes}{}\n", report.display()))
}
