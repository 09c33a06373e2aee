//! A body by itself: its numbers, its size in cells, its motion.

use super::keys::FIELDS;
use super::{Body, MOTIONS, motion};
use crate::key::checked;
use crate::shapes::{FineCells, Shape, cells_across};
use input::key::{Numbers, in_ranges, numbers as placed};
use input::problem::Problems;
use input::quantity::plain;

/// Least number of cells across a body: with fewer, soil leaks through it.
pub(crate) const MIN_CELLS_ACROSS: f64 = 1.0;

/// Reports what is wrong with a body in a grid of these cells.
pub(crate) fn check(body: &Body, cells: FineCells, problems: &mut Problems) {
    let path = format!("body.{}", body.name);
    shape(&path, &body.shape, cells, problems);
    for part in &body.parts {
        shape(&format!("body.{}", part.name), &part.shape, cells, problems);
    }
    numbers(&path, body, problems);
    for (key, freedom) in MOTIONS.into_iter().zip(body.motions()) {
        motion::check(&format!("{path}.{key}"), &freedom, problems);
    }
}

/// Reports what is wrong with the shape of the body at a path.
pub(crate) fn shape(path: &str, shape: &Shape, cells: FineCells, problems: &mut Problems) {
    let before = problems.len();
    in_ranges(path, &shape.numbers(), problems);
    if let Some(conflict) = shape.conflict().filter(|_| problems.len() == before) {
        problems.add(format!("{path}.{}", conflict.key), conflict.message, conflict.cure);
    }
    if problems.len() == before && !problems.ignores_resolution() {
        resolution(path, shape, cells, problems);
    }
    if let Some(conflict) = shape.plane_strain_conflict().filter(|_| cells.plane_strain) {
        problems.add(format!("{path}.{}", conflict.key), conflict.message, conflict.cure);
    }
}

/// Reports a shape with too few cells across to resolve contact.
fn resolution(path: &str, shape: &Shape, fine: FineCells, problems: &mut Problems) {
    for (size, cells) in cells_across(shape, fine) {
        if cells >= MIN_CELLS_ACROSS * (1.0 - 1e-9) {
            continue;
        }
        let path = format!("{path}.{}", size.key);
        let message = format!("only {cells:.2} cells across {path}: too few to resolve contact");
        let cure = format!(
            "make grid.cell at most {:.4} mm for one cell across; 4 or more are advisable",
            1e3 * fine.widths.min_element() * cells / MIN_CELLS_ACROSS
        );
        problems.add(path, message, cure);
    }
}

/// Reports numbers that are out of range, or too large or too small to compute with.
fn numbers(path: &str, body: &Body, problems: &mut Problems) {
    let all = placed(FIELDS, body);
    let in_range = |names: &[&str], problems: &mut Problems| {
        let asked: Numbers = all.iter().filter(|(key, _)| names.contains(&key.name)).copied().collect();
        checked(asked, problems, |asked, problems| in_ranges(path, asked, problems)).is_some()
    };
    in_range(&["x", "y"], problems);
    if !body.position.z.is_finite() {
        let message = format!("the body is at z = {} m", plain(body.position.z));
        problems.add(format!("{path}.sinkage"), message, "it must be at a finite height");
    }
    in_range(&["yaw", "tilt", "pitch"], problems);
    in_range(&["friction", "adhesion_factor"], problems);
    let is_right = in_range(&["mass", "axle_inertia"], problems);
    if is_right && !(body.mass.is_normal() && body.axle_inertia.is_normal()) {
        let message = format!(
            "mass {:e} kg and moment of inertia {:e} kg m² are outside the range of computable numbers",
            body.mass, body.axle_inertia
        );
        problems.add(path, message, "check the body's weight or mass, its size and its position");
    }
}
