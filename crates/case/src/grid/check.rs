//! The cells: whether their faces fill the box.

use super::Grid;
use super::keys::KEYS;
use crate::domain::Domain;
use crate::key::{in_order, in_range};
use glam::DVec3;
use input::problem::Problems;
use input::quantity::plain;

/// Fraction of a cell below which two positions coincide.
const COINCIDE: f64 = 1e-6;

/// Reports what is wrong with the cells of a box.
pub(crate) fn check(grid: &Grid, domain: &Domain, problems: &mut Problems) {
    in_range(KEYS, "grid", "growth", &[grid.growth], problems);
    if !in_range(KEYS, "grid", "cell", &[grid.cell], problems) {
        return;
    }
    aspect(grid.aspect, problems);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let ends = [domain.low[axis], domain.high[axis]];
        let zone = [grid.fine_low[axis], grid.fine_high[axis]];
        let key = format!("fine_{name}");
        if in_order(&format!("grid.{key}"), zone, problems) {
            fine_zone(&key, zone, ends, problems);
        }
        faces(name, &grid.faces[axis], ends, grid.cell, problems);
    }
    if domain.plane_strain && grid.faces[1].len() != 2 {
        let message = "the slab of a plane strain case is one cell wide";
        problems.add("grid.cell", message, "give two faces along y, those of the slab");
    }
}

/// Reports what is wrong with the shape of the cells: their widths along x, y, z over `grid.cell`.
pub(crate) fn aspect(aspect: DVec3, problems: &mut Problems) {
    let widths = aspect.to_array().into_iter().enumerate();
    let mut outside = |(n, width)| !in_range(KEYS, "grid", &format!("aspect[{n}]"), &[width], problems);
    if widths.filter(|width| outside(*width)).count() == 0 && aspect.min_element() > 1.0 {
        let message = "grid.aspect: none of the widths is grid.cell itself";
        let least = plain(aspect.min_element());
        problems.add("grid.aspect", message, format!("divide them by {least}, and multiply grid.cell by it"));
    }
}

/// Whether the fine zone along an axis [m] lies inside the box; reported if not.
pub(crate) fn fine_zone(key: &str, zone: [f64; 2], [low, high]: [f64; 2], problems: &mut Problems) -> bool {
    let is_inside = zone[0] >= low && zone[1] <= high;
    if !is_inside {
        let message = format!("the fine zone is partly outside the box, {} to {} m", plain(low), plain(high));
        problems.add(format!("grid.{key}"), message, format!("change grid.{key} or the domain"));
    }
    is_inside
}

/// Reports faces [m] that do not increase from one end of the box to the other.
fn faces(name: &str, faces: &[f64], [low, high]: [f64; 2], cell: f64, problems: &mut Problems) {
    let increase = faces.windows(2).all(|w| w[0] < w[1] && (w[1] - w[0]).is_finite());
    let (Some(first), Some(last), true) = (faces.first(), faces.last(), faces.len() > 1) else {
        problems.add("grid.cell", format!("there are no cells along {name}"), "give two faces or more");
        return;
    };
    if !increase {
        let message =
            "the cells are too small for their distance from 0: their faces cannot be distinguished";
        problems.add("grid.cell", message, "make grid.cell larger, or move the box closer to 0");
    } else if (first - low).abs().max((last - high).abs()) > COINCIDE * cell {
        let message = format!(
            "the cells along {name} extend over {} to {} m, the box over {} to {} m",
            plain(*first),
            plain(*last),
            plain(low),
            plain(high)
        );
        problems.add("grid.cell", message, "let the first and the last face lie on the box");
    }
}
