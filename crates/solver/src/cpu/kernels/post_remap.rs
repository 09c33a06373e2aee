//! The end of the Eulerian stage: from carried volumes back to volume fractions and admissible stresses.

use super::cells::{BLOCK, Block, CellRow, MaterialConstants, RowConstants, cells_of, runs};
use super::constants;
use super::physics::tensor::mean;
use super::return_mapping::apply;
use super::{PortionScratch, Real, Soil, Workspace};
use crate::fields::{GAP_STRAIN, HISTORY_COUNT, main_material, mass_as_main};
use crate::grid::Grid;
use crate::model::{FRACTION_KEPT, Model};
use multiversion::multiversion;
use std::ops::Range;

/// A portion's rows of what the cells hold.
struct PortionSlice<'a> {
    rows: Range<usize>,
    fraction: &'a mut [Real],
    mass: &'a mut [Real],
    stress: [&'a mut [Real]; 6],
    history: [&'a mut [Real]; HISTORY_COUNT],
    /// Volume and mass of the debris by row.
    debris: &'a mut [[f64; 2]],
    scratch: &'a mut PortionScratch,
}

/// Everything that the update only reads.
struct Inputs<'a> {
    grid: &'a Grid,
    constants: RowConstants<'a>,
    materials: &'a [MaterialConstants],
    /// Portions of the second material, the third, … in each cell.
    composition: &'a [Vec<Real>],
    /// Densities of the undeformed materials [kg/m³].
    densities: &'a [f64],
    /// Volume of the soil in each cell [m³].
    volume: &'a [Real],
    /// Rows that may hold soil.
    active: &'a [bool],
}

impl Inputs<'_> {
    /// Masses of a row of cells as if all their soil were of the main material (see [`mass_as_main`]).
    fn masses_as_main(&self, mass: &[Real], cells: Range<usize>) -> Vec<Real> {
        let one = |(mass, c): (&Real, usize)| {
            mass_as_main(self.composition, self.densities, f64::from(*mass), c) as Real
        };
        mass.iter().zip(cells).map(one).collect()
    }
}

/// Removes debris, closes gaps that stand under pressure, returns stresses to the yield surface; in the
/// `active` rows, the only ones with soil. Volume [m³] and mass [kg] of the debris are in the rows' values.
pub(crate) fn update_after_remap(model: &Model, soil: &mut Soil, workspace: &mut Workspace, active: &[bool]) {
    let Workspace {
        team,
        partition,
        velocity_before: [volume, ..],
        row_values,
        portions,
        width_x,
        densities,
        materials,
        ..
    } = workspace;
    let Soil { fraction, mass, stress, history, composition, .. } = soil;
    let mut stress = stress.each_mut().map(|s| partition.split(s));
    let mut history = history.each_mut().map(|h| partition.split(h));
    let fields = partition.split(fraction).zip(partition.split(mass));
    let own = partition.split_by(1, row_values).zip(portions);
    let slices =
        partition.ranges().zip(fields).zip(own).map(move |((rows, (fraction, mass)), (debris, scratch))| {
            let stress = stress.each_mut().map(|s| s.next().unwrap_or_default());
            let history = history.each_mut().map(|h| h.next().unwrap_or_default());
            PortionSlice { rows, fraction, mass, stress, history, debris, scratch }
        });
    let constants = constants::of_rows(model, materials, width_x, 0.0);
    let inputs = Inputs { grid: &model.grid, constants, materials, composition, densities, volume, active };
    team.distribute(slices, |slice| update_slice(&inputs, slice));
}

fn update_slice(inputs: &Inputs, slice: &mut PortionSlice) {
    let grid = inputs.grid;
    let [_, ny, nz] = grid.cells();
    let row = grid.stride[1];
    // What was carried last lies in the fractions' memory, ghosts and all.
    slice.fraction.fill(0.0);
    slice.debris.fill([0.0; 2]);
    for (n, r) in slice.rows.clone().enumerate() {
        let [q, plane] = grid.row_and_plane(r);
        if !inputs.active[r] || !(1..=ny).contains(&q) || plane > nz {
            continue;
        }
        let own = n * row + 1..n * row + 1 + grid.padded_row();
        let (fraction, mass) = (&mut slice.fraction[own.clone()], &mut slice.mass[own.clone()]);
        slice.debris[n] = new_fractions(inputs, [r, q, plane], fraction, mass);
        let start = r * row + 1;
        let of_row = start..start + own.len();
        let (material, as_main): (Vec<u8>, Vec<Real>) = if inputs.composition.is_empty() {
            Default::default()
        } else {
            let main = |c: usize| main_material(inputs.composition, c) as u8;
            (of_row.clone().map(main).collect(), inputs.masses_as_main(mass, of_row))
        };
        let mut cells = CellRow {
            fraction,
            mass: if as_main.is_empty() { mass } else { &as_main },
            stress: slice.stress.each_mut().map(|s| &mut s[own.clone()]),
            history: slice.history.each_mut().map(|h| cells_of(h, &own)),
            width_y: grid.width(1, q - 1) as Real,
            width_z: grid.width(2, plane - 1) as Real,
        };
        for (run, number) in runs(&material, 0..own.len()) {
            let constants = inputs.constants.of(&inputs.materials[number]);
            update_cells(&constants, &mut cells, run, &mut slice.scratch.block);
        }
    }
}

/// Volume fractions of a row of cells from their volumes of soil; returns volume and mass of the debris,
/// which is removed.
fn new_fractions(
    inputs: &Inputs,
    [r, q, plane]: [usize; 3],
    fraction: &mut [Real],
    mass: &mut [Real],
) -> [f64; 2] {
    let grid = inputs.grid;
    let volume = &inputs.volume[r * grid.stride[1] + 1..][..grid.cells()[0]];
    let (mut debris, is_inside) = ([0.0; 2], grid.is_inside([q, plane]));
    for (i, (volume, fraction)) in volume.iter().zip(fraction).enumerate() {
        *fraction = (f64::from(*volume) / grid.volume(i, q - 1, plane - 1)) as Real;
        if f64::from(*fraction) < FRACTION_KEPT {
            if is_inside && grid.inside(0).contains(&i) {
                debris[0] += f64::from(*volume);
                debris[1] += f64::from(mass[i]);
            }
            (*fraction, mass[i]) = (0.0, 0.0);
        }
    }
    debris
}

/// Updates a cell that soil was moved into.
pub(crate) fn update_cell(model: &Model, soil: &mut Soil, workspace: &mut Workspace, c: usize) {
    let grid = &model.grid;
    let Workspace { width_x, portions, densities, materials, .. } = workspace;
    let material = &materials[soil.main_material(c)];
    let constants = constants::of_rows(model, materials, width_x, 0.0).of(material);
    let [i, j, k] = grid.layers_of(c);
    let own = c - i..c - i + grid.padded_row();
    let mass = &soil.mass[own.clone()];
    let mut as_main = if soil.composition.is_empty() { Vec::new() } else { mass.to_vec() };
    if let Some(own) = as_main.get_mut(i) {
        *own = mass_as_main(&soil.composition, densities, f64::from(*own), c) as Real;
    }
    let mut cells = CellRow {
        fraction: &soil.fraction[own.clone()],
        mass: if as_main.is_empty() { mass } else { &as_main },
        stress: soil.stress.each_mut().map(|s| &mut s[own.clone()]),
        history: soil.history.each_mut().map(|h| cells_of(h, &own)),
        width_y: grid.width(1, j) as Real,
        width_z: grid.width(2, k) as Real,
    };
    update_cells(&constants, &mut cells, i..i + 1, &mut portions[0].block);
}

/// Updates some cells of a row, of one material.
fn update_cells(constants: &RowConstants, cells: &mut CellRow, columns: Range<usize>, block: &mut Block) {
    for start in columns.clone().step_by(BLOCK) {
        (block.start, block.n) = (start, BLOCK.min(columns.end - start));
        close_gaps(constants, cells, block);
        if let Some(yield_law) = &constants.material.yield_law {
            apply(constants, yield_law, cells, block);
        }
        put_back(cells, block);
    }
}

/// Soil with a gap was mixed with soil under pressure: lets the pressure close the gap, or its volume is
/// lost. Soil looser than it can be has a gap.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn close_gaps(constants: &RowConstants, cells: &CellRow, b: &mut Block) {
    let (start, n) = b.span();
    let own = start..start + n;
    let (fraction, gap_strain) = (&cells.fraction[own.clone()], &cells.history[GAP_STRAIN][own.clone()]);
    let (mass, width) = (&cells.mass[own.clone()], &constants.width_x[own.clone()]);
    let area = cells.width_y * cells.width_z;
    let [densest, loosest] = [constants.material.densest, constants.material.loosest].map(|d| d * area);
    let stress = cells.stress.each_ref().map(|s| &s[own.clone()]);
    let (bulk, stiffening) = (constants.material.elastic.bulk, constants.material.stiffening);
    for i in 0..n {
        let [xx, yy, zz, xy, yz, xz] = [0, 1, 2, 3, 4, 5].map(|c| stress[c][i]);
        let pressure = -mean([xx, yy, zz, xy, yz, xz]);
        let bulk = stiffening.map_or(bulk, |stiffening| bulk * stiffening.factor(pressure));
        let most = pressure / bulk;
        // The mean of two gaps is more than mixed soil can close by, since a gap is a logarithmic strain.
        // Soil that is too loose for its gap to tell all has at least one up to where it bears pressure.
        let loose = loosest * width[i] * fraction[i] / mass[i] - 1.0;
        let gap = if gap_strain[i] > loose { gap_strain[i] } else { loose };
        let room = densest * width[i] * fraction[i] / mass[i] - 1.0 + most;
        let gap = if gap < room { gap } else { room };
        let gap = if gap > 0.0 { gap } else { 0.0 };
        let closes = (gap > 0.0) & (pressure > 0.0);
        let closed = if gap < most { gap } else { most };
        let relief = bulk * closed;
        b.gap_strain[i] = if closes { gap - closed } else { gap };
        b.trial[0][i] = if closes { xx + relief } else { xx };
        b.trial[1][i] = if closes { yy + relief } else { yy };
        b.trial[2][i] = if closes { zz + relief } else { zz };
        (b.trial[3][i], b.trial[4][i], b.trial[5][i]) = (xy, yz, xz);
        b.bears_stress[i] = if fraction[i] > 0.0 { 1.0 } else { 0.0 };
    }
}

/// Stores stress and gap; where no soil is left nothing is remembered.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn put_back(cells: &mut CellRow, b: &Block) {
    let (start, n) = b.span();
    let own = start..start + n;
    for (stress, trial) in cells.stress.iter_mut().zip(&b.trial) {
        let stress = &mut stress[own.clone()];
        for i in 0..n {
            stress[i] = if b.bears_stress[i] > 0.0 { trial[i] } else { 0.0 };
        }
    }
    cells.history[GAP_STRAIN][own.clone()].copy_from_slice(&b.gap_strain[..n]);
    for history in cells.history.iter_mut().filter(|history| !history.is_empty()) {
        let history = &mut history[own.clone()];
        for i in 0..n {
            history[i] = if b.bears_stress[i] > 0.0 { history[i] } else { 0.0 };
        }
    }
}
