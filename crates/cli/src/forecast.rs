//! `coulter forecast`: the closed-form models for a case.

use crate::common::{refuse_file, say, say_json};
use crate::failure::Failure;
use analytic::forecast::Body;
use coulter::case::{self, StandardDeviation};
use coulter::forecast::{self, Effort, InputDeviation, Intervals, Outlook, Range};
use coulter::output::{ForecastFiles, write_forecast};
use std::path::{Path, PathBuf};

const DEFAULT_POINTS: u16 = 41;

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
    /// Medians, intervals and Sobol indices of every model from the stated standard deviations
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
    refuse_unused_options(arguments)?;
    let (case, deviations) = case::load_for_forecast(&arguments.case, &arguments.overrides)?;
    let outlook = forecast::outlook(&case)
        .map_err(|why| Failure::Request(format!("there is no forecast for this case: {why}")))?;
    let stated = stated(arguments, &deviations, &outlook)?;
    let effort = if arguments.uncertainty { Effort::Full } else { Effort::Quick };
    let intervals = forecast::intervals(&outlook, stated, effort);
    let document = forecast::document(&outlook, &intervals, arguments.uncertainty);
    let (files, left_out) = match folder(arguments, &case.name) {
        Some(folder) => {
            refuse_file(&folder).and_then(|()| write(arguments, &outlook, &intervals, &document, &folder))?
        }
        None => (Vec::new(), Vec::new()),
    };
    if arguments.json {
        return say_json(&document);
    }
    say(&forecast::table(&outlook, &intervals))?;
    if arguments.uncertainty {
        say(&forecast::uncertainty_table(&intervals))?;
    }
    match left_out.first() {
        Some(first) if left_out.len() > 1 => {
            say(&format!("\n{} points of the curve are left out, such as: {first}\n", left_out.len()))?;
        }
        Some(only) => say(&format!("\n1 point of the curve is left out: {only}\n"))?,
        None => {}
    }
    if !files.is_empty() {
        let list: Vec<String> = files.iter().map(|f| f.display().to_string()).collect();
        say(&format!("\nwrote {}\n", list.join("\n      ")))?;
    }
    Ok(())
}

/// Refuses options that would have no effect.
fn refuse_unused_options(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.against.is_some() || arguments.output.is_some() {
        return Ok(());
    }
    let unused =
        [("--log", arguments.log), ("--points", arguments.points.is_some()), ("--force", arguments.force)];
    match unused.iter().find(|(_, given)| *given) {
        Some((name, _)) => {
            let message =
                format!("{name} applies to curves, but none is written: add --against Z=0.02..0.4 or -o DIR");
            Err(Failure::Request(message))
        }
        None => Ok(()),
    }
}

/// The standard deviations of the command line and of the case; those of the command line take precedence.
fn stated(
    arguments: &Arguments,
    deviations: &[StandardDeviation],
    outlook: &Outlook,
) -> Result<Vec<InputDeviation>, Failure> {
    let typed = arguments.spreads.iter().map(|text| InputDeviation::read(text, &outlook.input));
    let mut stated: Vec<InputDeviation> = typed.collect::<Result<_, _>>().map_err(Failure::Request)?;
    for deviation in deviations {
        let of_case = InputDeviation::of_case(deviation, &outlook.input).map_err(Failure::Request)?;
        if stated.iter().all(|s| s.variable != of_case.variable) {
            stated.push(of_case);
        }
    }
    if stated.len() > forecast::MAX_INPUTS {
        let message =
            format!("at most {} inputs can be uncertain; {} are", forecast::MAX_INPUTS, stated.len());
        return Err(Failure::Request(message));
    }
    if stated.is_empty() && arguments.uncertainty {
        let message = "--uncertainty needs a standard deviation: --spread soil.friction_angle=\"2 deg\", or \
                       friction_angle = \"35 ± 2 deg\" in the case";
        return Err(Failure::Request(message.into()));
    }
    Ok(stated)
}

/// The default curve.
fn default_curve(body: &Body) -> String {
    match body {
        Body::Disc(_) => "Z=0.01..0.4".into(),
        _ => format!("Z=0.01..{:.4}", 0.95 * body.height() / body.length()),
    }
}

/// The folder to write to, if any.
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
) -> Result<(Vec<PathBuf>, Vec<String>), Failure> {
    let default = default_curve(&outlook.input.towing.body);
    let range_text = arguments.against.as_deref().unwrap_or(&default);
    let points = usize::from(arguments.points.unwrap_or(DEFAULT_POINTS));
    let range = Range::read(range_text, &outlook.input, points, arguments.log)
        .map_err(|why| Failure::Request(why.to_string()))?;
    let curves = forecast::curves(outlook, &range, arguments.log)
        .map_err(|why| Failure::Request(format!("--against {range_text}: {why}")))?;
    let models = forecast::models_csv(outlook, intervals);
    let files = ForecastFiles { models: &models, document, curves: &curves };
    let written =
        write_forecast(folder, &files, arguments.force).map_err(|e| Failure::Request(e.to_string()))?;
    Ok((written, curves.left_out))
}
