//! The end of the Eulerian stage: from carried volumes back to volume fractions and admissible stresses.

use super::cells::{CellRow, MaterialConstants, RowConstants, cells_of, runs};
use super::constants;
use super::remap::{Debris, new_fractions};
use super::rows::post_remap::update_cells;
use super::{PortionScratch, Real, Soil, Workspace};
use crate::cpu::fields_on_device::DeviceRemap;
use crate::fields::{HISTORY_COUNT, main_material, mass_as_main};
use crate::grid::Grid;
use crate::model::{FRACTION_KEPT, Model};
use ::kernels::layout::Layout;
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
    layout: Layout<'a>,
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
    if let Some(device) = &mut workspace.device {
        return device.update_after_remap(model, &workspace.materials, &mut workspace.row_values);
    }
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
    let (grid, layout) = (&model.grid, model.grid.layout());
    let inputs = Inputs { grid, layout, constants, materials, composition, densities, volume, active };
    team.distribute(slices, |slice| update_slice(&inputs, slice));
}

fn update_slice(inputs: &Inputs, slice: &mut PortionSlice) {
    let grid = inputs.grid;
    let row = grid.stride[1];
    // What was carried last lies in the fractions' memory, ghosts and all.
    slice.fraction.fill(0.0);
    slice.debris.fill([0.0; 2]);
    for (n, r) in slice.rows.clone().enumerate() {
        let Some([j, k]) = inputs.layout.layers_of_row(r).filter(|_| inputs.active[r]) else { continue };
        let whole = n * row..(n + 1) * row;
        let counted = if grid.is_inside([j + 1, k + 1]) { grid.inside(0) } else { 0..0 };
        let fields = [&mut slice.fraction[whole.clone()], &mut slice.mass[whole]];
        let debris = Debris { below: FRACTION_KEPT, counted };
        slice.debris[n] = new_fractions(&inputs.layout, r, inputs.volume, fields, &debris);
        let own = n * row + 1..n * row + 1 + grid.padded_row();
        let (fraction, mass) = (&slice.fraction[own.clone()], &slice.mass[own.clone()]);
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
            width_y: grid.width(1, j) as Real,
            width_z: grid.width(2, k) as Real,
        };
        for (run, number) in runs(&material, 0..own.len()) {
            let constants = inputs.constants.of(&inputs.materials[number]);
            update_cells(&constants, &mut cells, run, &mut slice.scratch.block);
        }
    }
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
