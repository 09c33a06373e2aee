//! `coulter check`: the case as understood, its cost, and warnings about it.

mod cost;
mod describe;
mod groups;

use crate::common::{say, say_json};
use crate::failure::Failure;
use crate::run_time;
use cost::describe_cost;
use coulter::case::estimate::{self, Cost};
use coulter::case::{self, Case, machine, resources};
use describe::describe;
use groups::groups;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

/// Largest number of warnings that are printed.
const MAX_WARNINGS: usize = 20;

pub(super) fn check(arguments: &Arguments) -> Result<(), Failure> {
    let case = case::load(&arguments.case, &arguments.overrides)?;
    let cost = estimate::cost(&case);
    let seconds = run_time::estimate(&case, &cost);
    let folder = PathBuf::from("results").join(&case.name);
    let mut warnings = case::advice(&case);
    warnings.extend(resources::warnings(&cost, &folder));
    if arguments.json {
        return as_json(&case, &cost, seconds, &warnings);
    }
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = describe(&mut text, &case).and_then(|()| describe_cost(&mut text, &case, &cost, seconds));
    for warning in warnings.iter().take(MAX_WARNINGS) {
        let _ = writeln!(text, "warning  {warning}");
    }
    if let Some(more) = warnings.len().checked_sub(MAX_WARNINGS).filter(|more| *more > 0) {
        let _ = writeln!(text, "warning  … and {more} more; --json lists all");
    }
    say(&text)
}

fn as_json(case: &Case, cost: &Cost, seconds: Option<f64>, warnings: &[String]) -> Result<(), Failure> {
    let groups: serde_json::Map<String, serde_json::Value> =
        case.bodies.iter().map(|b| (b.name.clone(), serde_json::json!(groups(case, b)))).collect();
    let document = serde_json::json!({
        "case": case.name, "groups": groups, "cost": cost, "estimated_wall_s": seconds,
        "memory_available_bytes": machine::memory_available(), "warnings": warnings, "resolved": case,
    });
    say_json(&document)
}
