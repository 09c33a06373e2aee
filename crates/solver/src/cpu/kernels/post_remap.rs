//! The end of the Eulerian stage: from carried volumes back to volume fractions and admissible stresses.

use super::physics::tensor::mean;
use super::return_mapping::apply;
use super::stress::{BLOCK, Block, CellRow, RowConstants};
use super::{Real, Soil, WorkerScratch, Workspace};
use crate::model::{FRACTION_KEPT, FRACTION_STRESSED, Model};
use multiversion::multiversion;
use std::ops::Range;

/// A worker's rows of what the cells hold.
struct Part<'a> {
    rows: Range<usize>,
    fraction: &'a mut [Real],
    mass: &'a mut [Real],
    stress: [&'a mut [Real]; 6],
    plastic_strain: &'a mut [Real],
    gap_strain: &'a mut [Real],
    /// Volume and mass of the crumbs by row.
    crumbs: &'a mut [[f64; 2]],
    scratch: &'a mut WorkerScratch,
}

/// Takes crumbs out, closes gaps that stand under pressure, returns stresses to the yield surface; in the `active` rows, the
/// only ones with soil. Returns volume [m³] and mass [kg] of the crumbs.
pub(crate) fn update_after_remap(
    model: &Model,
    soil: &mut Soil,
    workspace: &mut Workspace,
    active: &[bool],
) -> [f64; 2] {
    let Workspace { team, cut, velocity_before: [volume, ..], row_values, workers, width_x, .. } = workspace;
    let Soil { fraction, mass, stress, plastic_strain, gap_strain } = soil;
    let mut stress = stress.each_mut().map(|s| cut.split(s));
    let fields =
        cut.split(fraction).zip(cut.split(mass)).zip(cut.split(plastic_strain)).zip(cut.split(gap_strain));
    let own = cut.split_by(1, row_values).zip(workers);
    let parts = cut.ranges().zip(fields).zip(own).map(
        move |((rows, (((fraction, mass), plastic_strain), gap_strain)), (crumbs, scratch))| {
            let stress = stress.each_mut().map(|s| s.next().unwrap_or_default());
            Part { rows, fraction, mass, stress, plastic_strain, gap_strain, crumbs, scratch }
        },
    );
    let constants = RowConstants::new(model, width_x.each_ref().map(|w| &w[1..]), 0.0);
    team.deal(parts, |part| update_part(model, &constants, (volume, active), part));
    workspace.total_of_rows()
}

fn update_part(
    model: &Model,
    constants: &RowConstants,
    (volume, active): (&[Real], &[bool]),
    part: &mut Part,
) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    let row = grid.stride[1];
    // What was carried last lies in the fractions' memory, ghosts and all.
    part.fraction.fill(0.0);
    part.crumbs.fill([0.0; 2]);
    for (n, r) in part.rows.clone().enumerate() {
        let [q, plane] = grid.row_place(r);
        if !active[r] || !(1..=ny).contains(&q) || plane > nz {
            continue;
        }
        let (own, crumbs) = (n * row + 1..n * row + 1 + grid.padded_row(), &mut part.crumbs[n]);
        let (fraction, mass) = (&mut part.fraction[own.clone()], &mut part.mass[own.clone()]);
        let volume = &volume[r * row + 1..][..nx];
        for (i, (volume, fraction)) in volume.iter().zip(&mut *fraction).enumerate() {
            *fraction = (f64::from(*volume) / grid.volume(i, q - 1, plane - 1)) as Real;
            if f64::from(*fraction) < FRACTION_KEPT {
                crumbs[0] += f64::from(*volume);
                crumbs[1] += f64::from(mass[i]);
                (*fraction, mass[i]) = (0.0, 0.0);
            }
        }
        let mut cells = CellRow {
            fraction,
            mass,
            stress: part.stress.each_mut().map(|s| &mut s[own.clone()]),
            plastic_strain: &mut part.plastic_strain[own.clone()],
            gap_strain: &mut part.gap_strain[own],
            width_y: grid.width(1, q - 1) as Real,
            width_z: grid.width(2, plane - 1) as Real,
        };
        let columns = 0..cells.fraction.len();
        update_cells(constants, &mut cells, columns, part.scratch);
    }
}

/// Updates a cell that soil was moved into.
pub(crate) fn update_cell(model: &Model, soil: &mut Soil, workspace: &mut Workspace, c: usize) {
    let grid = &model.grid;
    let Workspace { width_x, workers, .. } = workspace;
    let constants = RowConstants::new(model, width_x.each_ref().map(|w| &w[1..]), 0.0);
    let [i, j, k] = grid.place(c);
    let own = c - i..c - i + grid.padded_row();
    let mut cells = CellRow {
        fraction: &soil.fraction[own.clone()],
        mass: &soil.mass[own.clone()],
        stress: soil.stress.each_mut().map(|s| &mut s[own.clone()]),
        plastic_strain: &mut soil.plastic_strain[own.clone()],
        gap_strain: &mut soil.gap_strain[own],
        width_y: grid.width(1, j) as Real,
        width_z: grid.width(2, k) as Real,
    };
    update_cells(&constants, &mut cells, i..i + 1, &mut workers[0]);
}

/// Updates some cells of a row.
fn update_cells(
    constants: &RowConstants,
    cells: &mut CellRow,
    columns: Range<usize>,
    scratch: &mut WorkerScratch,
) {
    let WorkerScratch { block, row, .. } = scratch;
    for start in columns.clone().step_by(BLOCK) {
        (block.start, block.n) = (start, BLOCK.min(columns.end - start));
        close_gaps(constants, cells, block);
        if let Some(strength) = &constants.strength {
            // What mixing has put outside the strength is no strain of the soil.
            let before = &mut row[..cells.plastic_strain.len()];
            before.copy_from_slice(cells.plastic_strain);
            apply(constants, strength, cells, block);
            cells.plastic_strain.copy_from_slice(before);
        }
        put_back(cells, block);
    }
}

/// Soil with a gap was mixed with soil under pressure: lets the pressure close the gap, or its volume is lost.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn close_gaps(constants: &RowConstants, cells: &CellRow, b: &mut Block) {
    let (start, n) = (b.start, b.n.min(BLOCK));
    let own = start..start + n;
    let (fraction, gap_strain) = (&cells.fraction[own.clone()], &cells.gap_strain[own.clone()]);
    let stress = cells.stress.each_ref().map(|s| &s[own.clone()]);
    let bulk = constants.elastic.bulk;
    for i in 0..n {
        let [xx, yy, zz, xy, yz, xz] = [0, 1, 2, 3, 4, 5].map(|c| stress[c][i]);
        let gap = if gap_strain[i] > 0.0 { gap_strain[i] } else { 0.0 };
        let pressure = -mean([xx, yy, zz, xy, yz, xz]);
        let closes = (gap > 0.0) & (pressure > 0.0);
        let most = pressure / bulk;
        let closed = if gap < most { gap } else { most };
        let relief = bulk * closed;
        b.gap_strain[i] = if closes { gap - closed } else { gap };
        b.trial[0][i] = if closes { xx + relief } else { xx };
        b.trial[1][i] = if closes { yy + relief } else { yy };
        b.trial[2][i] = if closes { zz + relief } else { zz };
        (b.trial[3][i], b.trial[4][i], b.trial[5][i]) = (xy, yz, xz);
        b.alive[i] = if fraction[i] > FRACTION_STRESSED as Real { 1.0 } else { 0.0 };
    }
}

/// Loose soil bears no stress and keeps no gap; where no soil is left nothing is remembered.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn put_back(cells: &mut CellRow, b: &Block) {
    let (start, n) = (b.start, b.n.min(BLOCK));
    let own = start..start + n;
    for (stress, trial) in cells.stress.iter_mut().zip(&b.trial) {
        let stress = &mut stress[own.clone()];
        for i in 0..n {
            stress[i] = if b.alive[i] > 0.0 { trial[i] } else { 0.0 };
        }
    }
    let (fraction, gap) = (&cells.fraction[own.clone()], &mut cells.gap_strain[own.clone()]);
    let plastic_strain = &mut cells.plastic_strain[own];
    for i in 0..n {
        gap[i] = if b.alive[i] > 0.0 { b.gap_strain[i] } else { 0.0 };
        plastic_strain[i] = if fraction[i] > 0.0 { plastic_strain[i] } else { 0.0 };
    }
}
