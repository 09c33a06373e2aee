//! `coulter forecast`: what the closed-form models say of a case.

use super::{Failure, say, say_json};
use crate::case::{self, Spread};
use crate::forecast::{self, Outlook, Range, Stated};
use crate::output::{Sheets, write_forecast};
use std::path::{Path, PathBuf};

/// The curve that is drawn unless another one is asked for.
const USUAL_CURVE: &str = "Z=0.01..0.4";

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file, as for `coulter run`
    case: PathBuf,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Where to write tables and plots [default: nowhere; with --against results/NAME-forecast]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Overwrite an existing forecast
    #[arg(long)]
    force: bool,
    /// The curve of every model against a key, such as Z=0.02..0.4 or soil.friction_angle="30 deg".."45 deg"
    #[arg(long, value_name = "KEY=LOW..HIGH")]
    against: Option<String>,
    /// Logarithmic axes for the curves
    #[arg(long)]
    log: bool,
    /// Points of a curve
    #[arg(long, value_name = "N", default_value_t = 41, value_parser = clap::value_parser!(u16).range(2..=1001))]
    points: u16,
    /// Intervals and Sobol indices from the stated spreads
    #[arg(long)]
    uncertainty: bool,
    /// Standard deviation of a key, such as soil.friction_angle="2 deg"; may be repeated
    #[arg(long = "spread", value_name = "KEY=DEVIATION", requires = "uncertainty")]
    spreads: Vec<String>,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

pub(super) fn forecast(arguments: &Arguments) -> Result<(), Failure> {
    let (case, spreads) = case::load_with_spreads(&arguments.case, &arguments.overrides)?;
    let outlook = forecast::outlook(&case)
        .map_err(|why| Failure::Request(format!("no forecast for this case: {why}")))?;
    let stated = if arguments.uncertainty { stated(arguments, &spreads, &outlook)? } else { Vec::new() };
    let intervals = if stated.is_empty() {
        Vec::new()
    } else {
        forecast::intervals(&outlook, &stated)
            .map_err(|why| Failure::Request(format!("no uncertainty for this case: {why}")))?
    };
    let document = forecast::document(&outlook, &stated, &intervals);
    let files = match folder(arguments, &case.name) {
        Some(folder) => write(arguments, &outlook, &document, &folder)?,
        None => Vec::new(),
    };
    if arguments.json {
        return say_json(&document);
    }
    say(&forecast::table(&outlook));
    if !stated.is_empty() {
        say(&forecast::uncertainty_table(&stated, &intervals));
    }
    if !files.is_empty() {
        let list: Vec<String> = files.iter().map(|f| f.display().to_string()).collect();
        say(&format!("\nwrote {}\n", list.join("\n      ")));
    }
    Ok(())
}

/// The spreads of the case, and those of the command line, which come first where both state one.
fn stated(arguments: &Arguments, spreads: &[Spread], outlook: &Outlook) -> Result<Vec<Stated>, Failure> {
    let typed = arguments.spreads.iter().map(|text| Stated::read(text, &outlook.setting));
    let mut stated: Vec<Stated> = typed.collect::<Result<_, _>>().map_err(Failure::Request)?;
    for spread in spreads {
        let own = Stated::of_case(spread, &outlook.setting).map_err(Failure::Request)?;
        if stated.iter().all(|s| s.variable != own.variable) {
            stated.push(own);
        }
    }
    if stated.is_empty() {
        let message = "--uncertainty needs a spread: --spread soil.friction_angle=\"2 deg\", or \
                       friction_angle = \"35 ± 2 deg\" in the case";
        return Err(Failure::Request(message.into()));
    }
    Ok(stated)
}

/// Where to write, if at all.
fn folder(arguments: &Arguments, name: &str) -> Option<PathBuf> {
    let usual = || PathBuf::from("results").join(format!("{name}-forecast"));
    arguments.output.clone().or_else(|| arguments.against.as_ref().map(|_| usual()))
}

fn write(
    arguments: &Arguments,
    outlook: &Outlook,
    document: &serde_json::Value,
    folder: &Path,
) -> Result<Vec<PathBuf>, Failure> {
    let asked = arguments.against.as_deref().unwrap_or(USUAL_CURVE);
    let range = Range::read(asked, &outlook.setting, usize::from(arguments.points), arguments.log)
        .map_err(|why| Failure::Request(why.to_string()))?;
    let curves = forecast::curves(outlook, &range, arguments.log)
        .map_err(|why| Failure::Request(format!("--against {asked}: {why}")))?;
    let models = forecast::models_table(outlook);
    let sheets = Sheets { models: &models, document, curves: &curves };
    write_forecast(folder, &sheets, arguments.force).map_err(|e| Failure::Request(e.to_string()))
}
