//! Whether everything fits together: the bodies and the box, their motion and the symmetry, the grid and the memory.

use crate::case::estimate;
use crate::case::machine;
use crate::case::path::path;
use crate::case::problem::Problems;
use crate::case::quantity::plain;
use crate::case::resolved::{Body, Case, Domain, Motion};
use crate::case::resources::format_bytes;
use crate::case::typed::{Schema, Section};

/// Largest number of time steps.
const MAX_STEPS: f64 = 1e12;

/// Reports bodies that start or move outside the box, and motions that violate its symmetry.
pub(super) fn bodies_fit(
    schema: &Schema,
    bodies: &[Body],
    domain: &Domain,
    duration: f64,
    problems: &mut Problems,
) {
    for (body, section) in bodies.iter().zip(&schema.bodies) {
        if domain.symmetric || domain.plane_strain {
            keeps_to_the_plane(section, body, domain, problems);
        }
        if domain.symmetric_x {
            keeps_to_the_middle(section, body, problems);
        }
        stays_inside(section, body, domain, duration, problems);
    }
}

fn keeps_to_the_plane(section: &Section, body: &Body, domain: &Domain, problems: &mut Problems) {
    let plane = if domain.symmetric { "a symmetric" } else { "a plane strain" };
    if domain.symmetric && body.position.y != 0.0 {
        let message = format!("the body is at y = {} m, off the plane of symmetry", plain(body.position.y));
        problems.add(section.location_of("y"), message, "remove `y`, or symmetric = true");
    }
    if body.translation[1] != Motion::Fixed {
        let message = format!("{plane} case allows no lateral motion");
        problems.add(
            section.location_of("lateral"),
            message,
            "write lateral = \"fixed\", or model the whole width",
        );
    }
}

/// A plane of symmetry across the tow allows no tow, and no rotation about y.
fn keeps_to_the_middle(section: &Section, body: &Body, problems: &mut Problems) {
    if body.position.x != 0.0 {
        let message = format!("the body is at x = {} m, off the plane of symmetry", plain(body.position.x));
        problems.add(section.location_of("x"), message, "remove `x`, or symmetric_x = true");
    }
    if !body.shape.is_symmetric_about_x() {
        let message = "a rotated block is not symmetric about x = 0";
        problems.add(
            section.location_of("orientation"),
            message,
            "remove `orientation`, or symmetric_x = true",
        );
    }
    for (key, still, freedom) in [("forward", "fixed", &body.translation[0]), ("spin", "locked", &body.spin)]
    {
        if *freedom != Motion::Fixed {
            let message = format!("a case that is symmetric about x = 0 allows no `{key}`");
            let cure = format!("write {key} = \"{still}\", or remove symmetric_x = true");
            problems.add(section.location_of(key), message, cure);
        }
    }
}

fn stays_inside(section: &Section, body: &Body, domain: &Domain, duration: f64, problems: &mut Problems) {
    let start = path(body, 0.0);
    let whole = path(body, duration);
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
            "[{}] {message}: it extends over {name} = {:.4} to {:.4} m, the box over {} to {} m",
            section.path,
            whole.low[axis],
            whole.high[axis],
            plain(domain.low[axis]),
            plain(domain.high[axis])
        );
        problems.add(
            section.location_of(key),
            message,
            format!("make domain.{name} wider, or the path shorter"),
        );
    }
    // A wall may extend through the floor, so that no soil passes under it; a body that moves vertically may not.
    let through_the_floor = whole.low.z < domain.low.z && body.translation[2] != Motion::Fixed;
    if through_the_floor || start.high.z <= domain.low.z || start.low.z >= domain.high.z {
        let message = format!(
            "[{}] extends over z = {:.4} to {:.4} m, but the box over {} to {} m",
            section.path,
            whole.low.z,
            whole.high.z,
            plain(domain.low.z),
            plain(domain.high.z)
        );
        let key = if start.low.z < domain.low.z { "sinkage" } else { "heave" };
        problems.add(section.location_of(key), message, "make domain.z deeper, or start the body higher");
    }
}

/// Refuses an inset that leaves no contact points: no force could act on the body.
pub(super) fn contact_points_remain(schema: &Schema, case: &Case, problems: &mut Problems) {
    let inset = case.numerics.edge_inset * case.grid.cell;
    for body in &case.bodies {
        let (low, high) = body.shape.solid().bounds();
        if (high - low).min_element() - 2.0 * inset < 1e-6 * case.grid.cell {
            let message = format!("the inset leaves no contact points on body `{}`", body.name);
            let cure = "reduce it; 0.5 is the default";
            problems.add(schema.numerics.location_of("edge_inset"), message, cure);
        }
    }
}

/// Refuses numbers that are too large or too small to compute with, and runs that would take too many steps.
pub(super) fn can_be_computed(schema: &Schema, case: &Case, problems: &mut Problems) {
    let cost = estimate::estimate(case);
    if !(cost.time_step_s > 0.0 && cost.steps <= MAX_STEPS) {
        let message =
            format!("{:.1e} time steps of {:.1e} s are too many to run", cost.steps, cost.time_step_s);
        let cure = "check run.duration, grid.cell, soil.young_modulus and the soil's density";
        problems.add(&schema.soil.location, message, cure);
    }
    for (body, section) in case.bodies.iter().zip(&schema.bodies) {
        let numbers = [body.mass, body.axle_inertia];
        if !numbers.iter().all(|n| n.is_normal() && *n > 0.0) || !body.position.is_finite() {
            let message = format!(
                "mass {:e} kg and moment of inertia {:e} kg m² are outside the range of computable numbers",
                body.mass, body.axle_inertia
            );
            problems.add(
                &section.location,
                message,
                "check the body's weight or mass, its size and its position",
            );
        }
    }
    let increasing = |faces: &Vec<f64>| faces.windows(2).all(|w| w[0] < w[1] && (w[1] - w[0]).is_finite());
    if !case.grid.faces.iter().all(increasing) {
        let message =
            "the cells are too small for their distance from 0: their faces cannot be distinguished";
        problems.add(
            schema.grid.location_of("cell"),
            message,
            "make grid.cell larger, or move the box closer to 0",
        );
    }
}

/// Largest number of contact points of one body: generating them takes some 2 GB.
const MAX_POINTS: f64 = 1e7;

/// Refuses bodies with too many contact points.
pub(super) fn contact_points_are_not_too_many(schema: &Schema, case: &Case, problems: &mut Problems) {
    let Some((name, points)) = estimate::most_contact_points(case) else { return };
    if points <= MAX_POINTS {
        return;
    }
    let message =
        format!("body `{name}` would have {points:.1e} contact points; at most {MAX_POINTS:.0e} are allowed");
    let cure = "make grid.cell or numerics.point_spacing larger, or the body smaller";
    problems.add(schema.grid.location_of("cell"), message, cure);
}

/// Refuses a case that needs more memory than this machine has; nothing of that size has been allocated yet.
pub(super) fn fits_into_memory(schema: &Schema, case: &Case, problems: &mut Problems) {
    let cost = estimate::cost(case);
    let Some(available) = machine::memory_available() else { return };
    if cost.memory_bytes <= available {
        return;
    }
    let message = format!(
        "the grid of {:.3e} cells needs {} of memory, the contact points {}, writing {}; {} are free",
        cost.estimate.cells,
        format_bytes(cost.memory.grid_bytes),
        format_bytes(cost.memory.contact_bytes),
        format_bytes(cost.memory.outputs_bytes),
        format_bytes(available)
    );
    let cure = "make grid.cell larger, or the box or the fine zone smaller";
    problems.add(schema.grid.location_of("cell"), message, cure);
}
