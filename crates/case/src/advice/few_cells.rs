//! Warnings of too few cells across a body and over its sinkage, with how far the answer moves on finer ones.

use super::motions::{is_above_ground, lowest};
use crate::resolved::{Body, Case, Motion};
use crate::thickness::{self, ThinPlace};
use crate::tow::Measures;

/// Cells across which a body is resolved well, and those below which soil leaks through it: measured on a
/// tray and a bucket of sheet.
const ENOUGH_CELLS: f64 = 4.0;
const TIGHT_CELLS: f64 = 2.0;

/// Below how many cells over width, contact chord or sinkage the drag, vertical force or sinkage of random
/// cases changed by how much on cells two thirds as wide, in the median and in nine of ten:
/// `scripts/reliability/random_cases.py --changes`, docs/reference/reliability.md.
const CHANGES: [(f64, [f64; 2]); 2] = [(TIGHT_CELLS, [0.18, 0.38]), (ENOUGH_CELLS, [0.08, 0.29])];

/// How far the answer changes on finer cells, where there are so few.
fn change(cells: f64) -> Option<String> {
    let (_, [median, most]) = CHANGES.into_iter().find(|(below, _)| cells < below * (1.0 - 1e-9))?;
    Some(format!(
        "with so few, random cases changed by {:.0} % in the median, and by up to {:.0} % in nine of ten, on cells two thirds as wide",
        100.0 * median,
        100.0 * most
    ))
}

/// Warns where there are few cells across a body, in the plane of its tow, or over the sinkage at which it is
/// held.
pub(super) fn resolution(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let Measures { extent: mut size, thickness, cell } = Measures::of(case, body, case.grid.fine_cell());
    size.y = thickness;
    if case.domain.plane_strain {
        size.y = f64::INFINITY;
    }
    let cells = size / cell;
    let narrow = thinnest(case, body, cells.min_element(), notes);
    let wide = cells.x.min(cells.z);
    if wide < 10.0 && wide > narrow {
        notes.push(format!(
            "{}: {wide:.1} cells across in the plane of the tow; 16 or more are advisable.",
            body.name
        ));
    }
    sinkage(case, body, notes);
}

/// Warns where there are few cells across a body, or across a part of it that is thinner; returns the least
/// number of them. `side` is that across the narrowest side of its box.
fn thinnest(case: &Case, body: &Body, side: f64, notes: &mut Vec<String>) -> f64 {
    let (enough, slack) = (ENOUGH_CELLS * (1.0 - 1e-9), 1.0 - 1e-3);
    let thin = thickness::thin_places(case, body, enough);
    let thin = thin.into_iter().min_by(|a, b| a.cells.total_cmp(&b.cells));
    let (cells, what) = match thin {
        Some(ThinPlace { cells, wall: Some((thickness, place)), .. }) if cells * slack < side => {
            (cells, format!("where it is thinnest, {:.4} mm at {place}", 1e3 * thickness))
        }
        Some(ThinPlace { cells, path, wall: None }) if cells < side * slack => (cells, path),
        _ => (side, "its narrowest side".to_owned()),
    };
    if let Some(change) = change(cells) {
        let leaks = if cells < TIGHT_CELLS { ", and soil leaks through it" } else { "" };
        notes.push(format!("{}: {cells:.1} cells across {what}: {change}{leaks}.", body.name));
    }
    cells
}

/// Warns where few cells cover the sinkage of a body that is held or moved vertically and towed.
fn sinkage(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let [x, y, z] = &body.guided().translation;
    let is_towed = [x, y].into_iter().any(|motion| !matches!(motion, Motion::Fixed));
    if !is_towed || z.is_free() || body.steers() || !case.is_even() || is_above_ground(case, body) {
        return;
    }
    let cells = (case.ground.surface() - lowest(case, body)) / case.grid.fine_cell().z;
    if let Some(change) = change(cells) {
        notes.push(format!("{}: {cells:.1} cells over its sinkage: {change}.", body.name));
    }
}

#[cfg(test)]
mod tests {
    use crate::{advice, parse};

    #[test]
    fn few_cells_over_the_sinkage_of_a_body_that_is_held_and_towed_are_doubted() {
        let notes = |more: &str| {
            let text = format!(
                "format = 2\nsoil = {{ law = 'mohr-coulomb', friction_angle = '32 deg', unit_weight = '15 kN/m^3', young_modulus = '1 MPa' }}\n\
                 domain = {{ x = ['-0.3 m', '0.3 m'], y = ['-0.3 m', '0.3 m'], z = ['-0.3 m', '0.2 m'] }}\ngrid = {{ cell = '12.5 mm', growth = 1.3 }}\n\
                 run = {{ duration = '0.5 s' }}\n[body.plate]\nshape = 'block'\nsize = ['0.1 m', '0.1 m', '0.1 m']\nfriction = 0.3\n{more}\n"
            );
            advice(&parse(&text, "case.toml", &[]).unwrap()).join("\n")
        };
        let towed = "forward = { speed = '0.1 m/s' }";
        for (more, words) in [
            (
                format!("sinkage = '12.5 mm'\n{towed}"),
                Some("plate: 1.0 cells over its sinkage: with so few, random cases changed by 18 %"),
            ),
            (
                format!("sinkage = '37.5 mm'\n{towed}"),
                Some("plate: 3.0 cells over its sinkage: with so few, random cases changed by 8 %"),
            ),
            (format!("sinkage = '50 mm'\n{towed}"), None),
            (format!("{towed}\nheave = 'free'\nweight = '20 N'"), None),
            ("heave = { speed = '-0.02 m/s' }".to_owned(), None),
        ] {
            let notes = notes(&more);
            assert!(
                words.map_or(!notes.contains("over its sinkage"), |words| notes.contains(words)),
                "{more}: {notes}"
            );
        }
    }
}
