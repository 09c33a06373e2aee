//! How thin the bodies of a case are in cells, where they are thinnest and soil may touch them.

use super::path::range;
use super::resolved::{Body, Case};
use super::shapes::{FineCells, Shape, cells_across};
use geometry::ThinSearch;
use glam::{DMat3, DVec3};
use mechanics::Motion;

/// A thin place of a body.
#[derive(Clone, Debug)]
pub(super) struct ThinPlace {
    /// Path of the key that says so.
    pub(super) path: String,
    /// Cells across.
    pub(super) cells: f64,
    /// Of a shape from a file, the thickness of its wall [m] and the place in words.
    pub(super) wall: Option<(f64, String)>,
}

/// The thinnest places of a body and its parts with fewer than so many cells across: by its own measures, and
/// of a shape from a file by rays through it, below the height to which soil may heap up.
pub(super) fn thin_places(case: &Case, body: &Body, fewer_than: f64) -> Vec<ThinPlace> {
    let frame = DMat3::from_quat(body.attitude.of_axle());
    let pitch = |angle: f64| DMat3::from_rotation_y(angle);
    let own = (&body.name, &body.shape, frame * pitch(body.attitude.pitch), DVec3::ZERO);
    let parts = body.parts.iter().map(|part| {
        let rotation = frame * DMat3::from_quat(part.rotation) * pitch(part.pitch);
        (&part.name, &part.shape, rotation, frame * part.offset)
    });
    let cell = turning(body, case.grid.fine_cell());
    let cells = FineCells { widths: cell, ..case.fine_cells() };
    let highest = highest_in_soil(case, body);
    let thinnest = |(name, shape, rotation, offset): (&String, &Shape, DMat3, DVec3)| {
        let Some(mesh) = shape.mesh() else {
            return by_measures(name, shape, cells, fewer_than);
        };
        let thin = shape.thinnest(&ThinSearch {
            cell: cell.max_element(),
            cells: &|direction| (rotation * direction / cell).length(),
            counts: &|place| (body.position + offset + rotation * place).z < highest,
            fewer_than,
        })?;
        let wall = Some((thin.thickness, mesh.place_in_file(thin.place)));
        Some(ThinPlace { path: format!("body.{name}.file"), cells: thin.cells, wall })
    };
    std::iter::once(own)
        .chain(parts)
        .filter(|(_, shape, ..)| shape.has_surface())
        .filter_map(thinnest)
        .collect()
}

fn is_moving(motion: &Motion) -> bool {
    *motion != Motion::Fixed
}

/// Widths of the cells; along all axes in which a body turns the widest.
fn turning(body: &Body, cell: DVec3) -> DVec3 {
    if body.steers() {
        DVec3::splat(cell.max_element())
    } else if is_moving(body.spin()) {
        let widest = cell.x.max(cell.z);
        DVec3::new(widest, cell.y, widest)
    } else {
        cell
    }
}

/// Height of the places of a body at the start [m] below which soil may touch them on its path; infinite
/// where the path is not known.
fn highest_in_soil(case: &Case, body: &Body) -> f64 {
    let turns = body.steers() || is_moving(body.spin());
    if turns || body.is_connected() || body.guided().translation[2].is_free() {
        return f64::INFINITY;
    }
    let [lowest, _] = range(body, case.duration);
    // In front of a body soil heaps up no higher than that is deep (chosen).
    let depth = case.top_of_ground() - (body.position.z + body.bounds().0.z + lowest.z);
    case.top_of_ground() + depth.max(0.0) + case.grid.fine_cell().z - lowest.z
}

/// The thinnest of the lengths that describe a shape.
fn by_measures(name: &str, shape: &Shape, cells: FineCells, fewer_than: f64) -> Option<ThinPlace> {
    let sizes = cells_across(shape, cells).into_iter().filter(|(_, cells)| *cells < fewer_than);
    let (size, cells) = sizes.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(ThinPlace { path: format!("body.{name}.{}", size.key), cells, wall: None })
}
