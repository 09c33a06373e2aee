//! Whether there is enough space for the soil that a body displaces: below the lid, and in front of the
//! walls.

use crate::clearance::{SoilConditions, clearance};
use crate::path::{Paths, body_length};
use crate::resolved::{Body, Case};

/// Distance to a wall, in body lengths, below which it is mentioned; chosen: soil fails over some three
/// sinkages, and a disc seldom sinks deeper than a third of its diameter.
const NEAR: f64 = 1.2;

/// Warns of walls, floor or lid that are too close to the body.
pub(super) fn walls_and_lid(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let need = clearance(body, &SoilConditions::of(case), case.duration);
    let least = NEAR * body_length(std::slice::from_ref(body));
    let swept = Paths::of(case).of_body(body);
    let (low, high) = (case.domain.low, case.domain.high);
    let moves_back = need.along[0] > need.along[1];
    let ahead = if moves_back { swept.low.x - low.x } else { high.x - swept.high.x };
    let mut gaps =
        vec![("ahead", ahead, need.along[0].max(need.along[1])), ("below", swept.low.z - low.z, need.below)];
    if !case.domain.plane_strain {
        let left = high.y - swept.high.y;
        let right = if case.domain.symmetric { left } else { swept.low.y - low.y };
        gaps.push(("to the side", left.min(right), need.sideways));
    }
    let near: Vec<String> = gaps
        .iter()
        .map(|(side, gap, needed)| (side, gap, needed.max(least)))
        // A default box is exactly as far away as recommended, but for rounding.
        .filter(|(_, gap, wanted)| **gap > 0.0 && **gap < *wanted * (1.0 - 1e-9))
        .map(|(side, gap, wanted)| format!("{gap:.3} m {side}, {wanted:.3} m recommended"))
        .collect();
    if !near.is_empty() {
        notes.push(format!(
            "{}: the walls are near ({}); enlarge the domain there.",
            body.name,
            near.join("; ")
        ));
    }
    lid(case, body, need.above, notes);
}

/// Warns where the expected heap may reach the lid. Soil that fills the box touches it by intention.
fn lid(case: &Case, body: &Body, heap: f64, notes: &mut Vec<String>) {
    let headroom = case.domain.high.z - case.top_of_ground();
    if headroom > 0.0 && heap + case.grid.fine_cell().z > headroom * (1.0 + 1e-9) {
        notes.push(format!(
            "{}: the lid is low: soil may heap up {heap:.3} m above the surface, and soil that reaches the lid increases \
             the force; raise the upper end of domain.z to {:.3} m or more.",
            body.name,
            case.top_of_ground() + heap + 2.0 * case.grid.fine_cell().z
        ));
    }
}
