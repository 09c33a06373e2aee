//! Ground that is not level, and bodies of other soil in it: whether its surface lies in the box, is known
//! wherever the grid goes, and is its own mirror image where the case is.

use crate::resolved::{Attitude, Case, Domain, Ground, SoilBody};
use glam::DVec3;
use input::problem::Problems;
use input::quantity::plain;

const AXES: [&str; 2] = ["x", "y"];
/// Least spacing of furrows in cells: fewer cannot hold a crest and a trough.
const LEAST_CELLS: f64 = 2.0;

/// Reports uneven ground that does not fit the rest of the case.
pub(super) fn relief(case: &Case, problems: &mut Problems) {
    if case.relief.is_level() && case.soil_bodies.is_empty() {
        return;
    }
    let section = section(case);
    if !matches!(case.ground, Ground::Level { .. }) {
        let message = "an uneven surface, or a soil body, of a column or a bank is not modelled";
        problems.add(section, message, "remove ground.x, ground.y and ground.radius; a heap is a soil body");
        return;
    }
    if case.overburden > 0.0 {
        let message = "a lid does not lie on uneven ground";
        problems.add("ground.overburden", message, "remove `overburden`");
    }
    inside(case, problems);
    mirrored(case, problems);
    resolved(case, problems);
    covered(case, problems);
    for body in &case.soil_bodies {
        placed(case, body, problems);
    }
}

/// The section to which a problem with the surface refers.
fn section(case: &Case) -> String {
    match (&case.relief.map, case.relief.furrows, case.soil_bodies.first()) {
        (Some(_), _, _) => "height_map".to_owned(),
        (None, Some(_), _) => "furrows".to_owned(),
        (None, None, body) => body.map_or_else(String::new, SoilBody::path),
    }
}

/// Whether the surface lies between floor and lid.
fn inside(case: &Case, problems: &mut Problems) {
    if case.relief.is_level() {
        return;
    }
    let Domain { low, high, .. } = case.domain;
    let [lowest, highest] =
        case.relief.of_solver().extremes(case.area()).map(|rise| case.ground.surface() + rise);
    if lowest <= low.z || highest > high.z {
        let message = format!(
            "the soil's surface lies between z = {} and {} m, not inside the box, z = {} to {} m",
            plain(lowest),
            plain(highest),
            plain(low.z),
            plain(high.z)
        );
        problems.add(
            section(case),
            message,
            "enlarge domain.z, or change ground.surface or height_map.datum",
        );
    }
}

/// Whether the surface is its own mirror image in planes of symmetry, and uniform across a slab of plane
/// strain.
fn mirrored(case: &Case, problems: &mut Problems) {
    let Domain { symmetric, symmetric_x, plane_strain, .. } = case.domain;
    let relief = case.relief.of_solver();
    for (axis, is_plane, key) in [(0, symmetric_x, "symmetric_x"), (1, symmetric, "symmetric")] {
        if is_plane && !relief.is_mirrored(axis) {
            let message = format!(
                "the surface of the ground is not its own mirror image in {} = 0 ({key} = true)",
                AXES[axis]
            );
            let cure = format!(
                "remove {key}, and model the whole width; furrows may run across the plane, or have a crest or a trough in it"
            );
            problems.add(section(case), message, cure);
        }
    }
    if plane_strain && !relief.is_uniform_along(1) {
        let message = "the surface of the ground changes along y, across the slab of a plane strain case";
        problems.add(
            section(case),
            message,
            "let furrows run along y (direction = \"90 deg\"), or remove plane_strain",
        );
    }
}

/// Whether cells can show the furrows.
fn resolved(case: &Case, problems: &mut Problems) {
    let Some(furrows) = case.relief.furrows.filter(|_| !problems.ignores_resolution()) else { return };
    let cell = case.grid.fine_cell();
    let [x, y] = furrows.across();
    let across = (x * cell.x).hypot(y * cell.y);
    if furrows.spacing < LEAST_CELLS * across * (1.0 - 1e-9) {
        let message = format!(
            "furrows {} m apart are less than {LEAST_CELLS} cells of {} m apart: the grid does not show them",
            plain(furrows.spacing),
            plain(across)
        );
        problems.add(
            "furrows.spacing",
            message,
            "make grid.cell smaller (8 cells a furrow are advisable), or leave the furrows out",
        );
    }
}

/// Whether a map knows the ground wherever the grid goes.
fn covered(case: &Case, problems: &mut Problems) {
    let Some(map) = &case.relief.map else { return };
    if let Some(follow) = case.grid.follow
        && let Some(body) = case.bodies.get(follow.body)
    {
        for axis in (0..2).filter(|axis| follow.axes[*axis]) {
            if body.guided().translation[axis].is_free() {
                let message = format!(
                    "how far the grid travels along {} follows from the run, and a height map has an end",
                    AXES[axis]
                );
                let cure = "prescribe the speed of the body that the grid follows, let the grid stand still, or use furrows";
                problems.add("grid.follow", message, cure);
                return;
            }
        }
    }
    for (axis, needed) in case.area().into_iter().enumerate() {
        let [low, high] = map.heights().ends(axis);
        let slack = 1e-9 * (needed[1] - needed[0]);
        if low > needed[0] + slack || high < needed[1] - slack {
            let along = AXES[axis];
            let travels = if case.grid.follow.is_some() {
                ", of a grid that travels with the ghost layers in front of it"
            } else {
                ""
            };
            let message = format!(
                "the map lies over {along} = {} to {} m, the domain over {} to {} m{travels}",
                plain(low),
                plain(high),
                plain(needed[0]),
                plain(needed[1])
            );
            let cure = format!(
                "give a larger map, move it by height_map.origin, or make domain.{along} or the tow shorter"
            );
            problems.add("height_map.file", message, cure);
        }
    }
}

/// Whether a soil body lies in the box, below its lid, and fits its planes of symmetry.
fn placed(case: &Case, body: &SoilBody, problems: &mut Problems) {
    let [low, high] = body.solver_body(0).bounds;
    let Domain { low: floor, high: lid, symmetric, symmetric_x, plane_strain, .. } = case.domain;
    let [x, y] = case.area();
    let box_low = DVec3::new(x[0], y[0], floor.z);
    let box_high = DVec3::new(x[1], y[1], lid.z);
    let path = body.path();
    if high.cmple(box_low).any() || low.cmpge(box_high).any() {
        let [a, b] =
            [low, high].map(|corner| corner.to_array().map(|x| plain(1e-4 * (1e4 * x).round())).join(", "));
        let message = format!("the soil body lies outside the box: from ({a}) to ({b}) m");
        problems.add(format!("{path}.elevation"), message, "move it into the domain, or remove it");
        return;
    }
    if high.z > lid.z {
        let message = format!(
            "the soil body reaches up to z = {} m, above the lid at {} m",
            plain(high.z),
            plain(lid.z)
        );
        problems.add(
            format!("{path}.elevation"),
            message,
            "raise the upper end of domain.z, or lower the body",
        );
    }
    let Attitude { yaw, tilt, pitch } = body.attitude;
    let turned = [yaw != 0.0 || pitch != 0.0, yaw != 0.0 || tilt != 0.0];
    for (axis, is_plane, key) in [(0, symmetric_x, "symmetric_x"), (1, symmetric, "symmetric")] {
        let is_cut = is_plane && low[axis] < 0.0 && high[axis] > 0.0;
        if is_cut && (body.position[axis] != 0.0 || turned[axis] || !body.shape.is_mirrored(axis)) {
            let message = format!(
                "the plane {} = 0 cuts the soil body, which is not its own mirror image in it",
                AXES[axis]
            );
            let cure = format!("put its centre into the plane, without rotation, or remove {key} = true");
            problems.add(format!("{path}.{}", AXES[axis]), message, cure);
        }
    }
    if plane_strain && turned[1] {
        let message = "in a plane strain case a soil body is the same along y, without `yaw` and `tilt`";
        problems.add(format!("{path}.yaw"), message, "remove them, or model the whole width");
    }
}
