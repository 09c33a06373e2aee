//! Bodies that are pressed down harder than any soil bears.

use super::values::is_soil;
use crate::own_weight::depth;
use crate::resolved::{Body, Case};
use input::quantity::short;

/// Pressure under a body over weight and strength of the soil at the floor beyond which it is doubted
/// (chosen): cones of dense sand read up to 300 times the stress of the soil's weight.
const HEAVY: f64 = 300.0;

/// Doubts weights and loads of bodies that sink freely.
pub(super) fn loads(case: &Case, doubts: &mut Vec<String>) {
    if is_soil(&case.soil) {
        doubts.extend(case.touching().filter_map(|(_, body)| too_heavy(case, body)));
    }
}

fn too_heavy(case: &Case, body: &Body) -> Option<String> {
    let load = body.pressing_force(case.normal_weight(body))?;
    let size = body.size();
    let pressure = load / (size.x * case.domain.width_of_body(size.y));
    let strength = case.soil.law.cohesion().unwrap_or(0.0);
    let bears = case.soil.unit_weight * depth(case) + strength + case.overburden;
    (bears > 0.0 && pressure > HEAVY * bears).then(|| {
        format!(
            "body.{}: it is pressed down with {} N, {} Pa over its length and width, {} times the stress at the floor of this box: no soil \
             bears that; check the units of its weight, mass and load.",
            body.name,
            short(load),
            short(pressure),
            short(pressure / bears)
        )
    })
}
