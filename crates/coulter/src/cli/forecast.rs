//! `coulter forecast`: what the closed-form models say of a case.

use super::{Failure, is_no_file, say, say_json};
use crate::case::{self, Spread};
use crate::forecast::{self, Effort, Intervals, Outlook, Range, Stated};
use crate::output::{Sheets, write_forecast};
use analytic::forecast::Body;
use std::path::{Path, PathBuf};

const USUAL_POINTS: u16 = 41;

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
    /// Points of a curve [default: 41]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=1001))]
    points: Option<u16>,
    /// Medians, intervals and Sobol indices of every model from the stated spreads
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
    nothing_is_ignored(arguments)?;
    let (case, spreads) = case::load_with_spreads(&arguments.case, &arguments.overrides)?;
    let outlook = forecast::outlook(&case)
        .map_err(|why| Failure::Request(format!("no forecast for this case: {why}")))?;
    let stated = stated(arguments, &spreads, &outlook)?;
    let effort = if arguments.uncertainty { Effort::Study } else { Effort::Glance };
    let intervals = forecast::intervals(&outlook, stated, effort);
    let document = forecast::document(&outlook, &intervals, arguments.uncertainty);
    let files = match folder(arguments, &case.name) {
        Some(folder) => {
            is_no_file(&folder).and_then(|()| write(arguments, &outlook, &intervals, &document, &folder))?
        }
        None => Vec::new(),
    };
    if arguments.json {
        return say_json(&document);
    }
    say(&forecast::table(&outlook, &intervals))?;
    if arguments.uncertainty {
        say(&forecast::uncertainty_table(&intervals))?;
    }
    if !files.is_empty() {
        let list: Vec<String> = files.iter().map(|f| f.display().to_string()).collect();
        say(&format!("\nwrote {}\n", list.join("\n      ")))?;
    }
    Ok(())
}

/// Refuses options that would do nothing.
fn nothing_is_ignored(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.against.is_some() || arguments.output.is_some() {
        return Ok(());
    }
    let idle =
        [("--log", arguments.log), ("--points", arguments.points.is_some()), ("--force", arguments.force)];
    match idle.iter().find(|(_, given)| *given) {
        Some((name, _)) => {
            let message =
                format!("{name} is about curves, and none is written: add --against Z=0.02..0.4 or -o DIR");
            Err(Failure::Request(message))
        }
        None => Ok(()),
    }
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
    if stated.is_empty() && arguments.uncertainty {
        let message = "--uncertainty needs a spread: --spread soil.friction_angle=\"2 deg\", or \
                       friction_angle = \"35 ± 2 deg\" in the case";
        return Err(Failure::Request(message.into()));
    }
    Ok(stated)
}

/// The curve that is drawn unless another one is asked for.
fn usual_curve(body: &Body) -> String {
    match body {
        Body::Disc(_) => "Z=0.01..0.4".into(),
        _ => format!("Z=0.01..{:.4}", 0.95 * body.height() / body.length()),
    }
}

/// Where to write, if at all.
fn folder(arguments: &Arguments, name: &str) -> Option<PathBuf> {
    let usual = || PathBuf::from("results").join(format!("{name}-forecast"));
    arguments.output.clone().or_else(|| arguments.against.as_ref().map(|_| usual()))
}

fn write(
    arguments: &Arguments,
    outlook: &Outlook,
    intervals: &Intervals,
    document: &serde_json::Value,
    folder: &Path,
) -> Result<Vec<PathBuf>, Failure> {
    let usual = usual_curve(&outlook.setting.towing.body);
    let asked = arguments.against.as_deref().unwrap_or(&usual);
    let points = usize::from(arguments.points.unwrap_or(USUAL_POINTS));
    let range = Range::read(asked, &outlook.setting, points, arguments.log)
        .map_err(|why| Failure::Request(why.to_string()))?;
    let curves = forecast::curves(outlook, &range, arguments.log)
        .map_err(|why| Failure::Request(format!("--against {asked}: {why}")))?;
    let models = forecast::models_table(outlook, intervals);
    let sheets = Sheets { models: &models, document, curves: &curves };
    write_forecast(folder, &sheets, arguments.force).map_err(|e| Failure::Request(e.to_string()))
}
