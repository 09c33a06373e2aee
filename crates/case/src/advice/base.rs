//! Whether the flat base of a body that is held at its depth lies on a face of the grid.

use crate::resolved::{Body, Case, Motion};
use glam::DVec3;
use input::quantity::plain;

/// Distance from the nearest face over the height of the cell below which a base lies on it (chosen).
const NEAR: f64 = 0.1;
/// Part of the plan of a body above which its lowest facets are a base (chosen: those of a round body are a
/// few per cent).
const FLAT: f64 = 0.2;

/// Contact acts on whole cells: a base within one lies as good as a part of a cell deeper or higher.
pub(super) fn within_cell(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let is_held = body.guided().translation[2] == Motion::Fixed
        && !body.steers()
        && body.staged.is_none()
        && *body.spin() == Motion::Fixed;
    let surface = case.ground.surface();
    let Some(base) = flat_base(body).filter(|base| is_held && *base < surface) else { return };
    let cell = case.grid.faces[2].windows(2).find(|cell| (cell[0]..cell[1]).contains(&base));
    let Some([low, high]) = cell.and_then(|cell| cell.first_chunk()) else { return };
    let inside = (base - low).min(high - base) / (high - low);
    if inside > NEAR {
        let sinkage = |face: &f64| format!("{} mm", plain(1e3 * (surface - face)));
        notes.push(format!(
            "body.{}: its base lies {inside:.2} cells inside a cell, and the force on it may be off by half; a sinkage of {} or {}, or \
             another grid.cell, puts it on a face.",
            body.name,
            sinkage(high),
            sinkage(low)
        ));
    }
}

/// The height of the lowest facets of a body [m], if they are flat and a good part of its plan.
fn flat_base(body: &Body) -> Option<f64> {
    let frame = body.attitude.of_axle();
    let mesh = body.solid().mesh();
    let points: Vec<DVec3> = mesh.points.iter().map(|point| frame * *point).collect();
    let (low, size) = (body.bounds().0.z, body.size());
    let at = |n: &u32| points[*n as usize];
    let is_low = |corners: &&[u32; 3]| corners.iter().all(|n| at(n).z - low < 1e-6 * size.max_element());
    let area = |[a, b, c]: &[u32; 3]| 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).length();
    let flat: f64 = mesh.triangles.iter().filter(is_low).map(area).sum();
    (flat > FLAT * size.x * size.y).then_some(body.position.z + low)
}
