//! `coulter check`: the case as understood, its cost, and warnings about it.

mod cost;
mod describe;
mod variation_cost;

use crate::common::{DeviceOption, say, say_json};
use crate::failure::Failure;
use crate::run_time;
use cost::describe_cost;
use coulter::case::estimate::{self, Cost};
use coulter::case::{self, Case, machine, resources};
use coulter::confidence::variations::{Asked, variations};
use coulter::formats;
use coulter::history::reference::Groups;
use coulter::run::{Device, on_device};
use describe::describe;
pub(super) use describe::describe_soil;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use variation_cost::VariationCosts;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Take soil under water for drained, whatever its drainage number
    #[arg(long)]
    accept_drained: bool,
    #[command(flatten)]
    on: DeviceOption,
    /// Also show the meshes that `coulter run --meshes N` would run, and what they cost together
    #[arg(long, value_name = "N", value_parser = crate::common::meshes())]
    meshes: Option<usize>,
    /// Also show the variations that `coulter run --confidence` would run, and what they cost
    #[arg(long)]
    confidence: bool,
    /// Leave out how long a run would take, which takes a second or two to measure
    #[arg(long)]
    untimed: bool,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

/// Time of a run that is mentioned [s]: a month (chosen).
const LONG: f64 = 30.0 * 86400.0;
/// Largest number of warnings that are printed.
const MAX_WARNINGS: usize = 20;

pub(super) fn check(arguments: &Arguments) -> Result<(), Failure> {
    let overrides = crate::common::overrides(&arguments.overrides, arguments.accept_drained);
    let case = case::load(&arguments.case, &overrides)?;
    let cost = estimate::cost(&case);
    let seconds = if arguments.untimed { None } else { run_time::estimate(&case, &cost) };
    let variations = match crate::common::asked(arguments.meshes, arguments.confidence, &[]) {
        Some(asked) => Some(variation_costs(&arguments.case, &overrides, &case, seconds, &asked)?),
        None => None,
    };
    let mut warnings = warnings(&case, &cost);
    if let Some(long) = seconds.filter(|seconds| *seconds > LONG) {
        let time = cost::time_in_words(long);
        warnings.push(format!(
            "The run would take some {time} on this machine: larger cells, a shorter run or softer soil take less."
        ));
    }
    let on_device = said_of_device(&case, arguments.on.device);
    if arguments.json {
        let mut document = document(&case, &cost, seconds, &warnings);
        if let Some(on_device) = on_device {
            document["device"] = serde_json::json!(on_device);
        }
        return as_json(document, variations.as_ref());
    }
    let mut text = described(&case, &cost, seconds);
    if let Some(OnDevice { memory_bytes, says, .. }) = on_device {
        let _ = writeln!(text, "device   {} of its memory; {says}", resources::format_bytes(memory_bytes));
    }
    // Writing to a string cannot fail.
    let _ = variations.iter().try_for_each(|costs| costs.describe(&mut text));
    for warning in warnings.iter().take(MAX_WARNINGS) {
        let _ = writeln!(text, "warning  {warning}");
    }
    if let Some(more) = warnings.len().checked_sub(MAX_WARNINGS).filter(|more| *more > 0) {
        let _ = writeln!(text, "warning  … and {more} more; --json lists all");
    }
    say(&text)
}

/// What a case takes on a device, and whether that can run it.
#[derive(Debug, serde::Serialize)]
struct OnDevice {
    memory_bytes: f64,
    runs: bool,
    says: String,
}

fn said_of_device(case: &Case, device: Device) -> Option<OnDevice> {
    let opened = device.open().transpose()?;
    let verdict =
        opened.and_then(|driver| on_device::require(case, &*driver).map(|()| driver.name().to_owned()));
    let says = match &verdict {
        Ok(name) => format!("it runs on {name}"),
        Err(why) => format!("it does not run: {why}"),
    };
    Some(OnDevice { memory_bytes: on_device::footprint(case), runs: verdict.is_ok(), says })
}

/// A case as understood and what it costs, in words; without the time that it takes, which would have to be
/// measured.
#[must_use]
pub fn check_text(case: &Case) -> String {
    described(case, &estimate::cost(case), None)
}

/// A case as understood, what it costs, and warnings as one JSON document, that of `coulter check --json`.
#[must_use]
pub fn check_document(case: &Case) -> serde_json::Value {
    let cost = estimate::cost(case);
    document(case, &cost, None, &warnings(case, &cost))
}

fn described(case: &Case, cost: &Cost, seconds: Option<f64>) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = describe(&mut text, case).and_then(|()| describe_cost(&mut text, case, cost, seconds));
    text
}

fn warnings(case: &Case, cost: &Cost) -> Vec<String> {
    let folder = PathBuf::from("results").join(&case.name);
    let mut warnings = case::advice(case);
    warnings.extend(resources::warnings(cost, &folder));
    warnings
}

/// The variations of the case, which takes so many seconds if that is known, and what they cost.
fn variation_costs(
    path: &Path,
    overrides: &[String],
    case: &Case,
    seconds: Option<f64>,
    asked: &Asked,
) -> Result<VariationCosts, Failure> {
    let text = case::text(path)?;
    let source_name = path.display().to_string();
    let typed = case::overridden(&text, &source_name, overrides)?;
    Ok(VariationCosts::of(case, seconds, &variations(case, &typed, &source_name, asked)?))
}

fn as_json(mut document: serde_json::Value, variations: Option<&VariationCosts>) -> Result<(), Failure> {
    if let Some(variations) = variations {
        document["variations"] = serde_json::json!(variations);
    }
    say_json(&document)
}

fn document(case: &Case, cost: &Cost, seconds: Option<f64>, warnings: &[String]) -> serde_json::Value {
    let groups: serde_json::Map<String, serde_json::Value> =
        case.bodies.iter().map(|b| (b.name.clone(), serde_json::json!(Groups::of(case, b)))).collect();
    let mut document = serde_json::json!({
        "format": formats::DOCUMENT, "case": case.name, "groups": groups, "cost": cost, "estimated_wall_s": seconds,
        "memory_available_bytes": machine::memory_available(), "warnings": warnings, "motions": motions(case), "resolved": case,
    });
    let surfaces: serde_json::Map<String, serde_json::Value> = case
        .bodies
        .iter()
        .filter_map(|body| Some((body.name.clone(), serde_json::json!(body.shape.mesh_report()?))))
        .collect();
    if !surfaces.is_empty() {
        document["surfaces"] = surfaces.into();
    }
    document
}

/// Every motion in words, by the path of its key.
fn motions(case: &Case) -> serde_json::Map<String, serde_json::Value> {
    let of_bodies = (0..case.bodies.len()).flat_map(|number| case::told_of_body(case, number));
    let of_stages = (0..case.stages.len()).flat_map(|number| case::told_of_stage(case, number));
    of_bodies.chain(of_stages).map(|told| (told.path, told.words.into())).collect()
}
