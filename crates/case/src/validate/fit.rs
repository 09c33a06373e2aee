//! Whether the bodies fit into the box and the grid, their motion its planes of symmetry, and the ground its
//! boundaries.

use crate::body::MIN_CELLS_ACROSS;
use crate::overlap;
use crate::path::{Paths, path};
use crate::resolved::{Body, Case, Domain, Ground, MOTIONS, Motion, Wall};
use crate::thickness::{ThinPlace, thin_places};
use input::problem::Problems;
use input::quantity::plain;
use mechanics::Pose;

/// Reports bodies that start or move outside the box, and motions that violate its symmetry.
pub(crate) fn bodies_fit(paths: &Paths, domain: &Domain, problems: &mut Problems) {
    for body in paths.bodies {
        if domain.symmetric || domain.plane_strain {
            keeps_to_the_plane(body, domain, problems);
        }
        if domain.symmetric_x {
            keeps_to_the_middle(body, problems);
        }
        if body.has_surface() {
            stays_inside(body, domain, paths, problems);
        }
    }
    apart(paths.bodies, problems);
}

/// Overlap of two bodies at the start that counts as round-off, over the size of the smaller.
const SHARED_FACE: f64 = 1e-9;

/// Reports bodies that overlap at the start; they may share a face.
fn apart(bodies: &[Body], problems: &mut Problems) {
    let placed: Vec<_> = bodies
        .iter()
        .filter(|body| body.has_surface())
        .map(|body| (body, body.solid(), Pose { position: body.position, rotation: body.attitude.of_axle() }))
        .collect();
    for (n, (body, solid, pose)) in placed.iter().enumerate() {
        for (other, beside, there) in &placed[..n] {
            let depth = overlap::depth((solid.as_ref(), pose), (beside.as_ref(), there));
            let smaller = body.size().max_element().min(other.size().max_element());
            if depth > SHARED_FACE * smaller {
                let message = format!(
                    "`{}` and `{}` overlap at the start, by {} mm at least",
                    other.name,
                    body.name,
                    plain(1e3 * depth)
                );
                problems.add(at(body, "shape"), message, "move them apart; they may share a face");
            }
        }
    }
}

/// The path of a key of a body.
fn at(body: &Body, key: &str) -> String {
    format!("body.{}.{key}", body.name)
}

fn keeps_to_the_plane(body: &Body, domain: &Domain, problems: &mut Problems) {
    let plane = if domain.symmetric { "a symmetric" } else { "a plane strain" };
    if domain.symmetric && body.position.y != 0.0 {
        let message = format!("the body is at y = {} m, off the plane of symmetry", plain(body.position.y));
        problems.add(at(body, "y"), message, "remove `y`, or symmetric = true");
    }
    if domain.symmetric {
        is_mirrored(body, 1, problems);
    }
    for (key, angle) in [("yaw", body.attitude.yaw), ("tilt", body.attitude.tilt)] {
        if angle != 0.0 {
            let message = format!("in {plane} case the axle lies along y, without `{key}`");
            problems.add(at(body, key), message, format!("remove `{key}`, or model the whole width"));
        }
    }
    for (n, still, what) in
        [(1, "fixed", "lateral motion"), (3, "locked", "yaw motion"), (4, "locked", "tilt motion")]
    {
        if body.motions()[n] != Motion::Fixed {
            let (key, message) = (MOTIONS[n], format!("{plane} case allows no {what}"));
            let cure = format!("write {key} = \"{still}\", or model the whole width");
            problems.add(at(body, key), message, cure);
        }
    }
}

/// Reports a shape that is not symmetric in the plane of symmetry across an axis.
fn is_mirrored(body: &Body, axis: usize, problems: &mut Problems) {
    if !body.shape.is_mirrored(axis) {
        let (plane, key) = if axis == 0 { ("x", "symmetric_x") } else { ("y", "symmetric") };
        let message = format!("this {} is not its own mirror image in {plane} = 0", body.shape.kind());
        let cure = format!("remove {key} = true; a mesh may have the origin of its file in its middle");
        problems.add(at(body, "shape"), message, cure);
    }
    for part in &body.parts {
        if part.offset[axis] != 0.0 || !part.is_aligned() || !part.shape.is_mirrored(axis) {
            let plane = if axis == 0 { "x" } else { "y" };
            let message = format!("`{}` is not its own mirror image in {plane} = 0", part.name);
            problems.add(format!("body.{}.welded_to", part.name), message, "model the whole width");
        }
    }
}

/// A plane of symmetry across the tow allows no tow, and no rotation about y or z.
fn keeps_to_the_middle(body: &Body, problems: &mut Problems) {
    if body.position.x != 0.0 {
        let message = format!("the body is at x = {} m, off the plane of symmetry", plain(body.position.x));
        problems.add(at(body, "x"), message, "remove `x`, or symmetric_x = true");
    }
    is_mirrored(body, 0, problems);
    let pitch = if body.shape.solid().is_revolved() { 0.0 } else { body.attitude.pitch };
    for (key, angle) in [("yaw", body.attitude.yaw), ("pitch", pitch)] {
        if angle != 0.0 {
            let message = format!("a body with a {key} is not symmetric about x = 0");
            problems.add(at(body, key), message, format!("remove `{key}`, or symmetric_x = true"));
        }
    }
    for (n, still) in [(0, "fixed"), (3, "locked"), (5, "locked")] {
        let key = MOTIONS[n];
        if body.motions()[n] != Motion::Fixed {
            let message = format!("a case that is symmetric about x = 0 allows no `{key}`");
            let cure = format!("write {key} = \"{still}\", or remove symmetric_x = true");
            problems.add(at(body, key), message, cure);
        }
    }
}

fn stays_inside(body: &Body, domain: &Domain, paths: &Paths, problems: &mut Problems) {
    let start = path(body, 0.0);
    let whole = paths.of_body(body);
    for (axis, name, key) in [(0, "x", "forward"), (1, "y", "lateral")] {
        // In plane strain the slab cuts through the body; a plane of symmetry cuts through any body.
        let (low_open, high_open) = match axis {
            1 => (domain.symmetric || domain.plane_strain, domain.plane_strain),
            _ => (domain.symmetric_x, false),
        };
        let leaves = |low: f64, high: f64| {
            !low_open && low < domain.low[axis] || !high_open && high > domain.high[axis]
        };
        let (message, key) = if leaves(start.low[axis], start.high[axis]) {
            ("starts outside the box", name)
        } else if leaves(whole.low[axis], whole.high[axis]) {
            ("leaves the box on its path", key)
        } else {
            continue;
        };
        let message = format!(
            "[body.{}] {message}: it extends over {name} = {:.4} to {:.4} m, the box over {} to {} m",
            body.name,
            whole.low[axis],
            whole.high[axis],
            plain(domain.low[axis]),
            plain(domain.high[axis])
        );
        problems.add(at(body, key), message, format!("make domain.{name} wider, or the path shorter"));
    }
    // A wall may extend through the floor, so that no soil passes under it; a body that moves vertically may
    // not.
    let through_the_floor = whole.low.z < domain.low.z && body.guided().translation[2] != Motion::Fixed;
    if through_the_floor || start.high.z <= domain.low.z || start.low.z >= domain.high.z {
        let message = format!(
            "[body.{}] extends over z = {:.4} to {:.4} m, but the box over {} to {} m",
            body.name,
            whole.low.z,
            whole.high.z,
            plain(domain.low.z),
            plain(domain.high.z)
        );
        let (key, cure) = if start.low.z >= domain.high.z {
            ("sinkage", "make domain.z higher, or start the body lower")
        } else if start.low.z < domain.low.z {
            ("sinkage", "make domain.z deeper, or start the body higher")
        } else {
            ("heave", "make domain.z deeper, or the path shorter")
        };
        problems.add(at(body, key), message, cure);
    }
}

/// Reports walls of bodies from files that are too thin to resolve contact; the rounding of STL makes none
/// so.
pub(super) fn walls(case: &Case, problems: &mut Problems) {
    let places =
        case.touching().flat_map(|(_, body)| thin_places(case, body, MIN_CELLS_ACROSS * (1.0 - 1e-5)));
    for ThinPlace { path, cells, wall } in places {
        let Some((thickness, place)) = wall else { continue };
        let message = format!(
            "only {cells:.2} cells across {path} where it is thinnest, {:.4} mm at {place}: too few to resolve contact, and soil \
             would pass through it",
            1e3 * thickness
        );
        let cure = format!(
            "make grid.cell at most {:.4} mm for one cell across, or the wall thicker; 4 or more are advisable",
            1e3 * case.grid.fine_cell().min_element() * cells / MIN_CELLS_ACROSS
        );
        problems.add(path, message, cure);
    }
}

/// Reports boundaries at constant stress that the ground or a grid that follows a body contradicts.
pub(super) fn constant_stress(case: &Case, problems: &mut Problems) {
    let domain = &case.domain;
    if !domain.yields() {
        return;
    }
    if matches!(case.ground, Ground::Column { .. }) {
        let message =
            "no ground lies beyond the boundaries of a column, which has none to bear its stress at rest";
        problems.add("domain", message, "write \"smooth\" or \"fixed\" instead of \"pressure\"");
    }
    let is_covered = case.ground.surface() >= domain.high.z;
    if domain.lid() == Wall::Pressure && !(is_covered && case.overburden > 0.0) {
        let message = "a lid of constant pressure needs soil up to the lid and the pressure on it";
        let cure =
            "give ground.overburden, and let domain.z end at ground.surface; a free surface needs no lid";
        problems.add("domain.z_walls", message, cure);
    }
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let follows = case.grid.follow.is_some_and(|follow| follow.axes[axis]);
        if follows && domain.walls[axis].contains(&Wall::Pressure) {
            let message = format!(
                "there are no walls along {name} in a grid that follows a body: ground enters there already"
            );
            problems.add(format!("domain.{name}_walls"), message, "remove it");
        }
    }
}
