//! Sums over the whole grid, always in double precision: energies, mass and volume of the soil. Taken at
//! samples and before and after a remap, not every step.
//!
//! Each row is summed on its own, then the rows in memory order, so the result does not depend on the number
//! of threads.

use crate::cpu::workspace::SoilWorkspace;
use crate::fields::mass_as_main;
use crate::grid::Grid;
use crate::halo::Halo;
use crate::model::Model;
use crate::precision::Precision;
use crate::scalar::Scalar;
use crate::state::{Soil, State};

/// Elastic energy of the soil [J].
pub(crate) fn elastic<R: Precision>(model: &Model, soil: &Soil<R>) -> f64 {
    sum_rows(&model.grid, |row| R::elastic_energy(model, soil, row))
}

/// Kinetic energy of the soil [J].
pub(crate) fn kinetic<R: Precision>(model: &Model, state: &State<R>) -> f64 {
    sum_rows(&model.grid, |row| R::kinetic_energy(&model.grid, &state.nodes, row))
}

/// Elastic and kinetic energy of the soil [J], computed in parallel.
pub(crate) fn total<R: Precision>(
    model: &Model,
    state: &State<R>,
    workspace: &mut SoilWorkspace<R>,
    halo: &mut dyn Halo,
) -> f64 {
    let SoilWorkspace { team, partition, row_values, .. } = workspace;
    team.distribute(partition.split_by(1, row_values).zip(partition.ranges()), |(values, rows)| {
        for (value, row) in values.iter_mut().zip(rows.clone()) {
            let row = model.grid.row_and_plane(row);
            *value = [
                R::elastic_energy(model, &state.soil, row),
                R::kinetic_energy(&model.grid, &state.nodes, row),
            ];
        }
    });
    let [elastic, kinetic] = workspace.total_of_rows(&model.grid, halo);
    elastic + kinetic
}

/// Volume of the soil [m³].
#[must_use]
pub fn soil_volume<R: Scalar>(grid: &Grid, soil: &Soil<R>) -> f64 {
    sum_rows(grid, |row| volume_of_row(grid, &soil.fraction, row))
}

/// Mass of the soil [kg].
#[must_use]
pub fn soil_mass<R: Scalar>(grid: &Grid, soil: &Soil<R>) -> f64 {
    let rows = grid.inside(2).flat_map(|k| grid.inside(1).map(move |j| (j, k)));
    let cells = rows.flat_map(|(j, k)| grid.inside(0).map(move |i| [i, j, k]));
    let own = cells.filter(|cell| grid.owns(grid.in_whole(*cell)));
    own.map(|[i, j, k]| soil.mass[grid.index(i, j, k)].to_f64()).sum()
}

/// Density over that of the densest state of the soil without pressure beyond which soil is denser than it can be: pressures do not
/// compress it elastically by a tenth.
pub const OVERDENSE: f64 = 1.1;

/// Portion of the soil's mass that lies in cells denser than [`OVERDENSE`] times its densest state: an error of the solver.
#[must_use]
pub fn overdense_portion<R: Scalar>(model: &Model, soil: &Soil<R>) -> f64 {
    let grid = &model.grid;
    let densities = model.densities();
    let overdense = |[q, plane]: [usize; 2]| {
        if !grid.is_inside([q, plane]) {
            return 0.0;
        }
        let start = plane * grid.stride[2] + q * grid.stride[1] + 1;
        let cells = grid.inside(0).map(|i| (start + i, grid.volume(i, q - 1, plane - 1)));
        let too_dense = cells.filter(|(c, volume)| {
            let densest = OVERDENSE * model.materials[soil.main_material(*c)].densest();
            let mass = mass_as_main(&soil.composition, &densities, soil.mass[*c].to_f64(), *c);
            mass > densest * soil.fraction[*c].to_f64() * volume
        });
        too_dense.map(|(c, _)| soil.mass[c].to_f64()).fold(0.0, |a, b| a + b)
    };
    let mass = soil_mass(grid, soil);
    if mass > 0.0 { sum_rows(grid, overdense) / mass } else { 0.0 }
}

/// Sum over the rows `[q, plane]` of cells and of nodes that the block owns, in memory order.
fn sum_rows(grid: &Grid, of_row: impl Fn([usize; 2]) -> f64) -> f64 {
    let [_, ny, nz] = grid.cells();
    let rows = (1..=nz + 1).flat_map(|plane| (1..=ny + 1).map(move |q| [q, plane]));
    let owned = rows.filter(|[q, plane]| grid.owned_row(plane * grid.rows() + q).is_some());
    owned.map(of_row).fold(0.0, |a, b| a + b)
}

/// Volume of the soil in row `q` of a memory plane of cells [m³].
fn volume_of_row<R: Scalar>(grid: &Grid, fraction: &[R], [q, plane]: [usize; 2]) -> f64 {
    if !grid.is_inside([q, plane]) {
        return 0.0;
    }
    let start = plane * grid.stride[2] + q * grid.stride[1] + 1;
    grid.inside(0)
        .map(|i| fraction[start + i].to_f64() * grid.volume(i, q - 1, plane - 1))
        .fold(0.0, |a, b| a + b)
}
