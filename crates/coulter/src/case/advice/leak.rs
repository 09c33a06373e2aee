//! Bodies into which soil will leak: sharp tips, edges oblique to the grid, and thin discs, on few cells.
//!
//! From 58 cases that broke, 46 of them by leak, and from cases on three meshes each: cones leak 1.7 to 17 % on 3.5 to 7 cells (15 cases
//! of 15), 1.5 to 2.1 % on 7 to 8, 0.2 to 0.3 % on 13; discs along the tow 2 to 5 % on one cell over their thickness, 1.2 to 1.4 % on
//! two, and none with a yaw; of wedges, of blocks oblique to the grid and of meshes a third to a half on 4 to 6 cells. A run is broken by 1 %.

use crate::case::path::Paths;
use crate::case::quantity::plain;
use crate::case::resolved::{Attitude, Body, Case};
use crate::case::shapes::{Cone, Disc, Shape};
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

/// Cells across a cone below which soil leaks into it.
const CONE: f64 = 12.0;
/// The same in loose sand, in which a cone on eight cells is good, and of a blunt one.
const CONE_THAT_LEAKS_LESS: f64 = 8.0;
/// Relative density up to which sand is loose here (chosen): it leaks at 0.45.
const LOOSE: f64 = 0.35;
/// Angle at the tip from which a cone is blunt [rad] (chosen): those that leaked had 30 and 60°.
const BLUNT: f64 = FRAC_PI_2;
/// Cells over the thickness of a disc along the tow, and of a dished one.
const DISC: f64 = 2.5;
const DISHED: f64 = 1.3;
/// Yaw from which a flat disc takes soil on one face only and does not leak [rad]; chosen: a twentieth of a right angle.
const ACROSS: f64 = 0.08;
/// Cells across a body with edges oblique to the grid.
const OBLIQUE: f64 = 4.5;

/// Warns of bodies into which soil will leak.
pub(super) fn leak(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let depth = case.top_of_ground() - Paths::of(case).of_body(body).low.z;
    // What hardly touches the soil, and what falls into it, is left to the grade.
    if depth <= 0.0 || case.domain.plane_strain {
        return;
    }
    let cell = case.grid.fine_cell();
    for surface in body.surfaces() {
        let Some((part, length, cells, wanted)) = sharp(case, &surface, cell) else { continue };
        if cells < wanted * (1.0 - 1e-9) {
            notes.push(format!(
                "{}: {cells:.1} cells across {part}: soil will leak into it, in like cases 1 to 17 % of its volume, and 1 % breaks a run; \
                 {wanted} cells or more are advisable there, grid.cell = \"{} mm\".",
                surface.name,
                plain((1e4 * length / wanted).floor() / 10.0)
            ));
        }
    }
}

/// The sharp part of a body in words, its length [m], how many cells that is and how many are wanted; `None` for a body without.
fn sharp(case: &Case, body: &Body, cell: DVec3) -> Option<(&'static str, f64, f64, f64)> {
    let widest = cell.max_element();
    match &body.shape {
        Shape::Cone(Cone { diameter, apex, .. }) => {
            let is_loose = case.soil.relative_density().is_some_and(|density| density < LOOSE);
            let wanted = if is_loose || *apex > BLUNT { CONE_THAT_LEAKS_LESS } else { CONE };
            Some(("the cone", *diameter, diameter / widest, wanted))
        }
        Shape::Disc(Disc { thickness, dish: Some(_), .. }) => {
            Some(("the thickness of the dished disc", *thickness, thickness / cell.y, DISHED))
        }
        Shape::Disc(Disc { thickness, .. }) if body.attitude.yaw.abs() < ACROSS => {
            Some(("the thickness of the disc", *thickness, thickness / cell.y, DISC))
        }
        Shape::Wedge(wedge) => {
            let least = wedge.size.min_element();
            Some(("the wedge", least, (wedge.size / cell).min_element(), OBLIQUE))
        }
        Shape::Block(block) if body.attitude != Attitude::default() => Some((
            "the block, oblique to the grid",
            block.size.min_element(),
            block.size.min_element() / widest,
            OBLIQUE,
        )),
        _ => None,
    }
}
