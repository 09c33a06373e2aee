//! Whether the soil that a body pushes aside has room: up to the lid, and to the walls.

use crate::case::path::{body_length, path};
use crate::case::resolve::room::{Soil, room};
use crate::case::resolved::{Body, Case};

/// Body lengths to a wall below which it is mentioned; chosen: soil fails over some three sinkages, and a disc seldom
/// sinks deeper than a third of its diameter.
const NEAR: f64 = 1.2;

/// Whether the soil that the body pushes aside has room: up to the lid, and to the walls.
pub(super) fn walls_and_lid(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let need = room(body, &Soil::of(case), case.duration);
    let least = NEAR * body_length(std::slice::from_ref(body));
    let way = path(body, case.duration);
    let (low, high) = (case.domain.low, case.domain.high);
    let moves_back = need.along[0] > need.along[1];
    let ahead = if moves_back { way.low.x - low.x } else { high.x - way.high.x };
    let mut gaps =
        vec![("ahead", ahead, need.along[0].max(need.along[1])), ("below", way.low.z - low.z, need.below)];
    if !case.domain.plane_strain {
        gaps.push(("beside", high.y - way.high.y, need.beside));
    }
    let near: Vec<String> = gaps
        .iter()
        .map(|(side, gap, needed)| (side, gap, needed.max(least)))
        .filter(|(_, gap, wanted)| **gap > 0.0 && **gap < *wanted)
        .map(|(side, gap, wanted)| format!("{gap:.3} m {side}, {wanted:.3} m wanted"))
        .collect();
    if !near.is_empty() {
        notes.push(format!(
            "{}: the walls are near ({}); make the domain larger there.",
            body.name,
            near.join("; ")
        ));
    }
    lid(case, body, need.above, notes);
}

/// Whether the heap that is expected stays below the lid. Soil that fills the box is meant to touch it.
fn lid(case: &Case, body: &Body, heap: f64, notes: &mut Vec<String>) {
    let headroom = case.domain.high.z - case.ground.surface();
    if headroom > 0.0 && heap + case.grid.cell > headroom * (1.0 + 1e-9) {
        notes.push(format!(
            "{}: the lid is low: soil may heap up to {heap:.3} m above the surface, and soil that meets the lid adds to \
             the force; let domain.z end at {:.3} m or higher.",
            body.name,
            case.ground.surface() + heap + 2.0 * case.grid.cell
        ));
    }
}
