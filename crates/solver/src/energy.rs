//! Sums over the whole grid, always in double precision: energies, mass and volume of the soil. Taken at
//! samples and before and after a remap, not every step.
//!
//! Each row is summed on its own, then the rows of all blocks exactly: neither threads nor blocks change a
//! bit.

use crate::cpu::fields_on_device::DeviceRemap;
use crate::cpu::workspace::SoilWorkspace;
use crate::exact_sum::{ExactSum, over_blocks};
use crate::fields::mass_as_main;
use crate::grid::Grid;
use crate::halo::Halo;
use crate::kernels::Kernels;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Soil, State};

/// Elastic energy of the soil [J].
pub(crate) fn elastic<R: Kernels>(model: &Model, soil: &Soil<R>, halo: &Halo) -> f64 {
    sum_rows(&model.grid, halo, |row| R::elastic_energy(model, soil, row))
}

/// Kinetic energy of the soil [J].
pub(crate) fn kinetic<R: Kernels>(model: &Model, state: &State<R>, halo: &Halo) -> f64 {
    sum_rows(&model.grid, halo, |row| R::kinetic_energy(&model.grid, &state.nodes, row))
}

/// Elastic and kinetic energy of the soil [J], computed in parallel.
pub(crate) fn total<R: Kernels>(
    model: &Model,
    state: &State<R>,
    workspace: &mut SoilWorkspace<R>,
    halo: &Halo,
) -> f64 {
    let SoilWorkspace { team, partition, row_values, device, .. } = workspace;
    if let Some(device) = device {
        device.energies(model, row_values);
    } else {
        team.distribute(partition.split_by(1, row_values).zip(partition.ranges()), |(values, rows)| {
            for (value, row) in values.iter_mut().zip(rows.clone()) {
                let row = model.grid.row_and_plane(row);
                *value = [
                    R::elastic_energy(model, &state.soil, row),
                    R::kinetic_energy(&model.grid, &state.nodes, row),
                ];
            }
        });
    }
    let [elastic, kinetic] = workspace.total_of_rows(&model.grid, halo);
    elastic + kinetic
}

/// Volume of the soil [m³].
pub fn soil_volume<R: Scalar>(grid: &Grid, soil: &Soil<R>, halo: &Halo) -> f64 {
    sum_cells(grid, halo, |c, volume| soil.fraction[c].to_f64() * volume)
}

/// Mass of the soil [kg].
pub fn soil_mass<R: Scalar>(grid: &Grid, soil: &Soil<R>, halo: &Halo) -> f64 {
    sum_cells(grid, halo, |c, _| soil.mass[c].to_f64())
}

/// Volume by which the pressure compresses the soil elastically [m³]; not of sand, whose volume follows its
/// own law.
pub fn compressed_volume<R: Scalar>(model: &Model, soil: &Soil<R>, halo: &Halo) -> f64 {
    sum_cells(&model.grid, halo, |c, volume| soil.fraction[c].to_f64() * volume * compression(model, soil, c))
}

/// Elastic volume strain of a cell, positive in compression; 0 of sand.
fn compression<R: Scalar>(model: &Model, soil: &Soil<R>, c: usize) -> f64 {
    let material = &model.materials[soil.main_material(c)];
    if material.stiffening().is_some() {
        return 0.0;
    }
    let pressure = -soil.stress[..3].iter().map(|stress| stress[c].to_f64()).sum::<f64>() / 3.0;
    pressure / material.elastic.bulk
}

/// Density over that of the densest state of the soil, compressed elastically, beyond which soil is denser
/// than it can be.
pub const OVERDENSE: f64 = 1.1;

/// Portion of the soil's mass that lies in cells denser than [`OVERDENSE`] times its densest state: an error
/// of the solver.
pub fn overdense_portion<R: Scalar>(model: &Model, soil: &Soil<R>, halo: &Halo) -> f64 {
    let grid = &model.grid;
    let densities = model.densities();
    let mass = soil_mass(grid, soil, halo);
    let overdense = sum_cells(grid, halo, |c, volume| {
        let densest = OVERDENSE * model.materials[soil.main_material(c)].densest();
        let densest = densest * (1.0 + compression(model, soil, c).max(0.0));
        let mass = mass_as_main(&soil.composition, &densities, soil.mass[c].to_f64(), c);
        if mass > densest * soil.fraction[c].to_f64() * volume { soil.mass[c].to_f64() } else { 0.0 }
    });
    if mass > 0.0 { overdense / mass } else { 0.0 }
}

/// Sum over the rows `[q, plane]` of cells and of nodes that the block owns, and over all blocks.
fn sum_rows(grid: &Grid, halo: &Halo, of_row: impl Fn([usize; 2]) -> f64) -> f64 {
    let [_, ny, nz] = grid.cells();
    let rows = (1..=nz + 1).flat_map(|plane| (1..=ny + 1).map(move |q| [q, plane]));
    let owned = rows.filter(|[q, plane]| grid.owned_row(plane * grid.rows() + q).is_some());
    let mut sum = ExactSum::default();
    owned.for_each(|row| sum.add(of_row(row)));
    let [sum] = over_blocks(halo, [sum]);
    sum
}

/// Sum over the cells of the domain, each given by its index and its volume [m³], row by row.
fn sum_cells(grid: &Grid, halo: &Halo, of_cell: impl Fn(usize, f64) -> f64) -> f64 {
    sum_rows(grid, halo, |[q, plane]| {
        if !grid.is_inside([q, plane]) {
            return 0.0;
        }
        let start = plane * grid.stride[2] + q * grid.stride[1] + 1;
        grid.inside(0).map(|i| of_cell(start + i, grid.volume(i, q - 1, plane - 1))).fold(0.0, |a, b| a + b)
    })
}
