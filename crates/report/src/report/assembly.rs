//! The tables about several bodies and the joints between them.

use super::rows::{NONE, value};
use super::summary::{ForceSummary, Summary};
use input::readable::Unit;
use results::folder::{JointRecord, PartRecord, RunRecord};
use serde::Serialize;

/// The bodies together: names and values of the forces.
pub(super) fn all_bodies(summary: &Summary) -> Vec<[String; 2]> {
    let Some(forces) = &summary.all_bodies else { return Vec::new() };
    // Half models have no lateral force.
    let shown = forces.iter().filter(|(force, sum)| {
        matches!(force.figure.name, "drag" | "vertical") || sum.is_some_and(|sum| sum != 0.0)
    });
    shown.map(|(force, sum)| [force.title(), value(*sum, Unit::force)]).collect()
}

/// A part or a joint of the table.
#[derive(Debug, Serialize)]
pub(super) struct ForceRow {
    name: String,
    /// The body that the part belongs to, or kind and bodies of a joint.
    of: String,
    /// Mean force along x, y, z, and the largest.
    forces: [String; 4],
    /// Mean moment about x, y, z.
    moments: [String; 3],
}

impl ForceRow {
    fn new(name: &str, of: String, summary: Option<&ForceSummary>) -> Self {
        let ForceSummary { force, moment, peak_force, .. } = summary.cloned().unwrap_or_default();
        let each = |values: Option<[f64; 3]>, unit: fn(f64) -> Unit| match values {
            Some(values) => values.map(|number| value(Some(number), unit)),
            None => std::array::from_fn(|_| NONE.to_owned()),
        };
        let [x, y, z] = each(force, Unit::force);
        Self {
            name: name.to_owned(),
            of,
            forces: [x, y, z, value(peak_force, Unit::force)],
            moments: each(moment, Unit::torque),
        }
    }
}

/// A row for each part of a body that consists of several.
pub(super) fn part_rows(record: &RunRecord, summary: &Summary) -> Vec<ForceRow> {
    let row = |part: &PartRecord| ForceRow::new(&part.name, part.body.clone(), summary.parts.get(&part.name));
    record.parts.iter().map(row).collect()
}

/// A row for each joint.
pub(super) fn joint_rows(record: &RunRecord, summary: &Summary) -> Vec<ForceRow> {
    let row = |joint: &JointRecord| {
        let of = format!("{}, {}", joint.kind, joint.bodies.join(" – "));
        ForceRow::new(&joint.name, of, summary.joints.get(&joint.name))
    };
    record.joints.iter().map(row).collect()
}
