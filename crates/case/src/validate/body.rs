//! A body by itself: its numbers, its size in cells, its motion.

use crate::cells_across::cells_across;
use crate::numbers::{in_range, in_range_or_infinite};
use crate::resolved::{Body, Case, MOTIONS, Motion};
use crate::shapes::Shape;
use crate::thickness::{ThinPlace, thin_places};
use glam::DVec3;
use input::problem::Problems;
use input::quantity::plain;

/// Least number of cells across a body: with fewer, soil leaks through it.
const MIN_CELLS_ACROSS: f64 = 1.0;

/// Reports what is wrong with a body in a grid whose fine cells have the widths `cell` [m], and that may be
/// one slab.
pub(crate) fn body(body: &Body, (cell, plane_strain): (DVec3, bool), problems: &mut Problems) {
    let path = format!("body.{}", body.name);
    shape(&path, &body.shape, (cell, plane_strain), problems);
    for part in &body.parts {
        shape(&format!("body.{}", part.name), &part.shape, (cell, plane_strain), problems);
    }
    position(&path, body, problems);
    attitude(&path, body, problems);
    surface(&path, body, problems);
    mass(&path, body, problems);
    for (key, freedom) in MOTIONS.into_iter().zip(body.motions()) {
        motion(&format!("{path}.{key}"), &freedom, problems);
    }
}

/// Reports what is wrong with the shape of the body at a path.
pub(crate) fn shape(path: &str, shape: &Shape, (cell, plane_strain): (DVec3, bool), problems: &mut Problems) {
    let before = problems.len();
    for size in shape.sizes() {
        in_range(&format!("{path}.{}", size.key), size.length, problems);
    }
    for (key, number) in shape.other_numbers() {
        in_range(&format!("{path}.{key}"), number, problems);
    }
    if let Some(conflict) = shape.conflict().filter(|_| problems.len() == before) {
        problems.add(format!("{path}.{}", conflict.key), conflict.message, conflict.cure);
    }
    if problems.len() == before && !problems.ignores_resolution() {
        resolution(path, shape, (cell, plane_strain), problems);
    }
    if let Some(conflict) = shape.plane_strain_conflict().filter(|_| plane_strain) {
        problems.add(format!("{path}.{}", conflict.key), conflict.message, conflict.cure);
    }
}

/// Reports a shape with too few cells across to resolve contact.
fn resolution(path: &str, shape: &Shape, grid: (DVec3, bool), problems: &mut Problems) {
    for (size, cells) in cells_across(shape, grid) {
        if cells >= MIN_CELLS_ACROSS * (1.0 - 1e-9) {
            continue;
        }
        let path = format!("{path}.{}", size.key);
        let message = format!("only {cells:.2} cells across {path}: too few to resolve contact");
        let cure = format!(
            "make grid.cell at most {:.4} mm for one cell across; 4 or more are advisable",
            1e3 * grid.0.min_element() * cells / MIN_CELLS_ACROSS
        );
        problems.add(path, message, cure);
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

fn position(path: &str, body: &Body, problems: &mut Problems) {
    in_range(&format!("{path}.x"), body.position.x, problems);
    in_range(&format!("{path}.y"), body.position.y, problems);
    if !body.position.z.is_finite() {
        let message = format!("the body is at z = {} m", plain(body.position.z));
        problems.add(format!("{path}.sinkage"), message, "it must be at a finite height");
    }
}

fn attitude(path: &str, body: &Body, problems: &mut Problems) {
    let attitude = body.attitude;
    for (key, angle) in [("yaw", attitude.yaw), ("tilt", attitude.tilt), ("pitch", attitude.pitch)] {
        in_range(&format!("{path}.{key}"), angle, problems);
    }
}

fn surface(path: &str, body: &Body, problems: &mut Problems) {
    in_range_or_infinite(&format!("{path}.friction"), body.friction, problems);
    if body.adhesion_factor != f64::INFINITY {
        in_range(&format!("{path}.adhesion_factor"), body.adhesion_factor, problems);
    }
}

fn mass(path: &str, body: &Body, problems: &mut Problems) {
    let before = problems.len();
    in_range_or_infinite(&format!("{path}.mass"), body.mass, problems);
    in_range_or_infinite(&format!("{path}.axle_inertia"), body.axle_inertia, problems);
    if problems.len() == before && !(body.mass.is_normal() && body.axle_inertia.is_normal()) {
        let message = format!(
            "mass {:e} kg and moment of inertia {:e} kg m² are outside the range of computable numbers",
            body.mass, body.axle_inertia
        );
        problems.add(path, message, "check the body's weight or mass, its size and its position");
    }
}

/// Reports what is wrong with the motion at a path.
pub(crate) fn motion(path: &str, motion: &Motion, problems: &mut Problems) {
    let mut check = |key: &str, number| in_range(&format!("{path}.{key}"), number, problems);
    match *motion {
        Motion::Fixed => {}
        Motion::Free { load, support, start, ramp } => {
            check("load", load);
            check("start", start);
            check("ramp", ramp);
            if !support.is_finite() {
                let message = format!("the body is supported by {} N until it is released", plain(support));
                problems.add(path, message, "it must be a finite force");
            }
        }
        Motion::Course(ref course) => {
            if !course.numbers().all(f64::is_finite) {
                problems.add(path, "the displacement over time is not finite", "give it finite numbers");
            }
        }
        Motion::Prescribed { before, speed, start, ramp, end } => {
            check("speed", before);
            check("speed", speed);
            check("start", start);
            check("ramp", ramp);
            if end.is_nan() || end < start + ramp {
                let message = "the motion ends before its ramp does";
                problems.add(format!("{path}.end"), message, "set `end` to start + ramp or later");
            }
        }
    }
}
