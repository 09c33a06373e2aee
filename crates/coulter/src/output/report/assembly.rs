//! The tables about several bodies and the joints between them.

use super::rows::{NONE, value};
use super::summary::{AllBodies, JointSummary, Summary};
use crate::output::folder::{JointRecord, RunRecord};
use crate::output::units::Unit;
use serde::Serialize;

/// The bodies together: names and values of the forces.
pub(super) fn all_bodies(summary: &Summary) -> Vec<[String; 2]> {
    let Some(AllBodies { drag, vertical, lateral }) = summary.all_bodies else { return Vec::new() };
    let line = |name: &str, force| [name.to_owned(), value(force, Unit::force)];
    let mut lines = vec![line("Drag", drag), line("Vertical force", vertical)];
    if lateral.is_some_and(|force| force != 0.0) {
        lines.push(line("Lateral force", lateral));
    }
    lines
}

/// A joint of the table.
#[derive(Debug, Serialize)]
pub(super) struct JointRow {
    name: String,
    kind: String,
    bodies: String,
    /// Mean force along x, y, z, and the largest.
    forces: [String; 4],
    /// Mean moment about x, y, z.
    moments: [String; 3],
}

/// A row for each joint.
pub(super) fn joint_rows(record: &RunRecord, summary: &Summary) -> Vec<JointRow> {
    let row = |joint: &JointRecord| {
        let JointSummary { force, moment, peak_force, .. } =
            summary.joints.get(&joint.name).cloned().unwrap_or_default();
        let each = |values: Option<[f64; 3]>, unit: fn(f64) -> Unit| match values {
            Some(values) => values.map(|number| value(Some(number), unit)),
            None => std::array::from_fn(|_| NONE.to_owned()),
        };
        let [x, y, z] = each(force, Unit::force);
        JointRow {
            name: joint.name.clone(),
            kind: joint.kind.clone(),
            bodies: joint.bodies.join(" – "),
            forces: [x, y, z, value(peak_force, Unit::force)],
            moments: each(moment, Unit::torque),
        }
    };
    record.joints.iter().map(row).collect()
}
