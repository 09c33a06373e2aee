//! What a remap needs besides the transport: volumes before it, and volume fractions and nodal masses after.

use super::Real;
use crate::layout::{Layout, Part};
use ::physics::double::select::min;
use std::ops::Range;

/// Volumes of the displaced cells in a part of a row, and of the soil in them [m³]; 0 for ghosts. `apart` is
/// the volume strain of the soil apart from that of its cell.
#[inline(always)]
pub fn displaced_volumes(
    layout: &Layout,
    part: Part,
    displacement: [&[Real]; 3],
    [fraction, apart]: [&[Real]; 2],
    [soil, cell]: [&mut [Real]; 2],
) {
    soil.fill(0.0);
    cell.fill(0.0);
    layout.each_cell(part, |c, [i, j, k]| {
        let own = c - part.start;
        let whole = layout.volume(i, j, k);
        cell[own] = (whole + swollen(layout, displacement, c, [i, j, k])) as Real;
        soil[own] = fraction[c] * (cell[own] + whole as Real * apart[c]);
    });
}

/// Volume that a cell has gained by the displacement of its corners [m³], linear in it like the strain.
#[inline(always)]
pub fn swollen(layout: &Layout, displacement: [&[Real]; 3], c: usize, [i, j, k]: [usize; 3]) -> f64 {
    let widths = [layout.width(0, i), layout.width(1, j), layout.width(2, k)];
    let mut gain = 0.0;
    for axis in 0..3 {
        let (a, b) = (layout.stride[(axis + 1) % 3], layout.stride[(axis + 2) % 3]);
        let u = |c: usize| f64::from(displacement[axis][c]);
        let face = |c: usize| (u(c) + u(c + a)) + (u(c + b) + u(c + a + b));
        let area = widths[(axis + 1) % 3] * widths[(axis + 2) % 3];
        gain += 0.25 * area * (face(c + layout.stride[axis]) - face(c));
    }
    gain
}

/// Volume fractions from the volumes of soil and cells [m³].
#[inline(always)]
pub fn volume_fractions(soil: &[Real], cell: &[Real], fraction: &mut [Real]) {
    for ((f, soil), cell) in fraction.iter_mut().zip(soil).zip(cell) {
        *f = if *cell > 0.0 { soil / cell } else { 0.0 };
    }
}

/// Masses of a part of a row of nodes from those of the cells [kg].
#[inline(always)]
pub fn nodal_masses(layout: &Layout, part: Part, cell_mass: &[Real], node_mass: &mut [Real]) {
    let [x, y, z] = layout.stride;
    let row = part.start - part.start % y;
    if (1..=layout.cells[1] + 1).contains(&layout.row_and_plane(row / y)[0]) {
        let first = part.start - row;
        for column in first.max(1)..(first + part.length).min(layout.cells[0] + 2) {
            let at = |offset: usize| {
                let c = row + column - offset;
                cell_mass[c] + cell_mass[c - x]
            };
            node_mass[column - first] = 0.125 * ((at(0) + at(y)) + (at(z) + at(y + z)));
        }
    }
}

/// What is removed after a remap.
#[derive(Clone, Debug)]
pub struct Debris {
    /// Fraction of a cell of which less is removed.
    pub below: f64,
    /// 0-based columns in which it is counted.
    pub counted: Range<usize>,
}

/// Volume fractions of a row of cells from their volumes of soil [m³], without debris; returns volume [m³]
/// and mass [kg] of that.
#[inline(always)]
pub fn new_fractions(
    layout: &Layout,
    row: usize,
    volume: &[Real],
    [fraction, mass]: [&mut [Real]; 2],
    debris: &Debris,
) -> [f64; 2] {
    let mut removed = [0.0; 2];
    let part = Part { start: row * layout.stride[1], length: layout.stride[1] };
    layout.each_cell(part, |c, [i, j, k]| {
        let own = c - part.start;
        fraction[own] = (f64::from(volume[c]) / layout.volume(i, j, k)) as Real;
        if f64::from(fraction[own]) < debris.below {
            if debris.counted.contains(&i) {
                removed[0] += f64::from(volume[c]);
                removed[1] += f64::from(mass[own]);
            }
            (fraction[own], mass[own]) = (0.0, 0.0);
        }
    });
    removed
}

/// Takes back what is left of the voids that were lent to the soil of some cells as gap strain: `void` is
/// then what has closed. The soil's own gap closes first.
#[inline(always)]
pub fn take_back(gap: &mut [Real], void: &mut [Real]) {
    for (gap, void) in gap.iter_mut().zip(void).filter(|(_, void)| **void > 0.0) {
        let [own, lent] = [*gap, *void].map(f64::from);
        let left = min(own, lent);
        (*gap, *void) = ((own - left) as Real, (lent - left) as Real);
    }
}

/// Makes displacements relative to a grid that has moved by `shift` [m].
#[inline(always)]
pub fn shift(displacement: &mut [Real], shift: f64) {
    for u in displacement {
        *u = (f64::from(*u) - shift) as Real;
    }
}

/// Stops nodes that have lost their soil: those of masses up to `mass_moved` [kg].
#[inline(always)]
pub fn stop_massless(mass: &[Real], mass_moved: Real, velocity: &mut [Real]) {
    for (v, m) in velocity.iter_mut().zip(mass) {
        if *m <= mass_moved {
            *v = 0.0;
        }
    }
}
