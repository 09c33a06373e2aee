//! `coulter check`: the case as understood, its cost, and warnings about it.

mod cost;
mod describe;
mod groups;
mod mesh_cost;

use crate::common::{say, say_json};
use crate::failure::Failure;
use crate::run_time;
use cost::describe_cost;
use coulter::case::estimate::{self, Cost};
use coulter::case::{self, Case, machine, resources};
use describe::describe;
pub(super) use describe::describe_soil;
use groups::groups;
use mesh_cost::{MeshCost, describe_meshes};
use std::fmt::Write;
use std::path::{Path, PathBuf};

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
    /// Also show the meshes that `coulter run --meshes N` would run, and what they cost together
    #[arg(long, value_name = "N", value_parser = crate::common::meshes())]
    meshes: Option<usize>,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

/// Largest number of warnings that are printed.
const MAX_WARNINGS: usize = 20;

pub(super) fn check(arguments: &Arguments) -> Result<(), Failure> {
    let overrides = crate::common::overrides(&arguments.overrides, arguments.accept_drained);
    let case = case::load(&arguments.case, &overrides)?;
    let cost = estimate::cost(&case);
    let seconds = run_time::estimate(&case, &cost);
    let meshes = match arguments.meshes {
        Some(count) => meshes(&arguments.case, &overrides, &case, count)?,
        None => Vec::new(),
    };
    let folder = PathBuf::from("results").join(&case.name);
    let mut warnings = case::advice(&case);
    warnings.extend(resources::warnings(&cost, &folder));
    if arguments.json {
        return as_json((&case, &cost, seconds), &meshes, &warnings);
    }
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = describe(&mut text, &case)
        .and_then(|()| describe_cost(&mut text, &case, &cost, seconds))
        .and_then(|()| describe_meshes(&mut text, &meshes));
    for warning in warnings.iter().take(MAX_WARNINGS) {
        let _ = writeln!(text, "warning  {warning}");
    }
    if let Some(more) = warnings.len().checked_sub(MAX_WARNINGS).filter(|more| *more > 0) {
        let _ = writeln!(text, "warning  … and {more} more; --json lists all");
    }
    say(&text)
}

/// The meshes of a study, the coarsest first.
fn meshes(path: &Path, overrides: &[String], case: &Case, count: usize) -> Result<Vec<MeshCost>, Failure> {
    let text = case::text(path)?;
    let source_name = path.display().to_string();
    let typed = case::overridden(&text, &source_name, overrides)?;
    let coarser = case::meshes::coarser(case, &typed, &source_name, count)?;
    let cases = coarser.iter().map(|mesh| &mesh.case).chain([case]);
    Ok(cases.map(MeshCost::of).collect())
}

fn as_json(
    (case, cost, seconds): (&Case, &Cost, Option<f64>),
    meshes: &[MeshCost],
    warnings: &[String],
) -> Result<(), Failure> {
    let groups: serde_json::Map<String, serde_json::Value> =
        case.bodies.iter().map(|b| (b.name.clone(), serde_json::json!(groups(case, b)))).collect();
    let mut document = serde_json::json!({
        "case": case.name, "groups": groups, "cost": cost, "estimated_wall_s": seconds,
        "memory_available_bytes": machine::memory_available(), "warnings": warnings, "resolved": case,
    });
    let surfaces: serde_json::Map<String, serde_json::Value> = case
        .bodies
        .iter()
        .filter_map(|body| Some((body.name.clone(), serde_json::json!(body.shape.mesh_report()?))))
        .collect();
    if !surfaces.is_empty() {
        document["surfaces"] = surfaces.into();
    }
    if !meshes.is_empty() {
        document["meshes"] = serde_json::json!(meshes);
    }
    say_json(&document)
}
