//! One sweep of a remap: volume, mass, stress and history, and momentum are carried along one axis.
//!
//! The volume fraction is carried with a reconstructed interface, stress and history with the soil volume at
//! second order, momentum on the dual grid.

use super::flux::FluxInputs;
use super::transport::{Sweep, carry_mass, carry_momentum, dual_fluxes, dual_reaches};
use super::{Nodes, Real, Soil, State, Workspace};
use crate::fields::{Carrier, HISTORY, HistoryVariable};
use crate::grid::Grid;
use crate::model::Model;

/// The arrays of a remap. The old velocities are worth nothing between steps: their memory is used again.
struct Scratch<'a> {
    /// Soil volume of the cells on the displaced grid [m³].
    soil: &'a mut Vec<Real>,
    /// Volume of the displaced cells [m³].
    cell: &'a mut Vec<Real>,
    /// Soil volume that crosses the faces [m³], later the mass that crosses the dual faces [kg].
    flux: &'a mut Vec<Real>,
}

impl<'a> Scratch<'a> {
    fn of([soil, cell, flux]: &'a mut [Vec<Real>; 3]) -> Self {
        Self { soil, cell, flux }
    }
}

/// Volumes of soil and cells on the displaced grid.
pub(crate) fn displaced_volumes(model: &Model, state: &State, workspace: &mut Workspace) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    let Workspace { team, partition, velocity_before, .. } = workspace;
    let Scratch { soil, cell, .. } = Scratch::of(velocity_before);
    let displacement = &state.nodes.displacement;
    team.rows2(partition, soil, cell, |row, soil, cell| {
        soil.fill(0.0);
        cell.fill(0.0);
        let [q, plane] = grid.row_and_plane(row);
        if (1..=ny).contains(&q) && plane <= nz {
            for i in 0..nx {
                let volume =
                    grid.volume(i, q - 1, plane - 1) + swollen(grid, displacement, [i, q - 1, plane - 1]);
                cell[i + 1] = volume as Real;
                let c = row * grid.stride[1] + i + 1;
                let apart = grid.volume(i, q - 1, plane - 1) as Real * state.soil.apart[c];
                soil[i + 1] = state.soil.fraction[c] * (cell[i + 1] + apart);
            }
        }
    });
}

/// Volume that a cell has gained by the displacement of its corners [m³], linear in it like the strain.
fn swollen(grid: &Grid, displacement: &[Vec<Real>; 3], [i, j, k]: [usize; 3]) -> f64 {
    let c = grid.index(i, j, k);
    let widths = [grid.width(0, i), grid.width(1, j), grid.width(2, k)];
    let mut gain = 0.0;
    for axis in 0..3 {
        let (a, b) = (grid.stride[(axis + 1) % 3], grid.stride[(axis + 2) % 3]);
        let u = |c: usize| f64::from(displacement[axis][c]);
        let face = |c: usize| (u(c) + u(c + a)) + (u(c + b) + u(c + a + b));
        let area = widths[(axis + 1) % 3] * widths[(axis + 2) % 3];
        gain += 0.25 * area * (face(c + grid.stride[axis]) - face(c));
    }
    gain
}

/// One sweep: volume, mass, stress and history, momentum. Arrays that have served their purpose make room for
/// others: the displacement along the axis for the reaches, the volume fractions for what is being carried.
pub(crate) fn sweep(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    axis: usize,
    active: &[bool],
    filled: &[usize],
) {
    let grid = &model.grid;
    let Workspace { team, partition, velocity_before, .. } = workspace;
    let Scratch { soil, cell, flux } = Scratch::of(velocity_before);
    team.rows(partition, &mut state.soil.fraction, |row, out| {
        let own = row * out.len()..(row + 1) * out.len();
        for ((f, soil), cell) in out.iter_mut().zip(&soil[own.clone()]).zip(&cell[own]) {
            *f = if *cell > 0.0 { soil / cell } else { 0.0 };
        }
    });
    let Soil { fraction, mass, stress, history, composition, .. } = &mut state.soil;
    let Nodes { velocity, displacement, mass: node_mass } = &mut state.nodes;
    let displacement = &mut displacement[axis];
    let sweep = Sweep { grid, axis, row_active: active };
    let inputs = FluxInputs { sweep, displacement, fraction, soil, cell };
    team.rows(partition, flux, |row, out| inputs.volume_fluxes(row, out));
    close(filled, grid.stride[axis], flux);
    team.rows(partition, cell, |row, out| sweep.undo_displacement(row, displacement, out));
    let reach = displacement;
    team.rows(partition, reach, |row, out| sweep.reaches(row, [flux, fraction, soil], out));
    let spare = fraction;
    let faces: [&[Real]; 2] = [flux, reach];
    let needed = history.iter_mut().zip(HISTORY).filter(|(field, _)| !field.is_empty());
    let (by_volume, by_mass): (Vec<_>, Vec<_>) =
        needed.partition(|(_, variable)| variable.carrier == Carrier::Volume);
    let fields = |list: Vec<(_, HistoryVariable)>| list.into_iter().map(|(field, _)| field);
    for field in stress.iter_mut().chain(fields(by_volume)).chain(composition) {
        team.rows(partition, spare, |row, out| sweep.carry(row, [soil, field], faces, out));
        std::mem::swap(field, spare);
    }
    team.rows(partition, spare, |row, out| sweep.mass_fluxes(row, [soil, mass], faces, out));
    team.rows(partition, soil, |row, out| sweep.difference(row, flux, out));
    // The volume flux is done with: room for what the mass carries, then for the dual flux.
    for field in fields(by_mass) {
        let faces: [&[Real]; 2] = [spare, reach];
        team.rows(partition, flux, |row, out| sweep.carry(row, [mass, field], faces, out));
        std::mem::swap(field, flux);
    }
    team.rows(partition, mass, |row, out| sweep.difference(row, spare, out));
    // The mass flux is in `spare`.
    team.rows(partition, flux, |row, out| dual_fluxes(grid, axis, row, spare, out));
    let mass_moved = model.mass_moved() as Real;
    team.rows(partition, reach, |row, out| dual_reaches(grid, axis, row, [node_mass, flux], mass_moved, out));
    for velocity in velocity {
        let inputs: [&[Real]; 4] = [velocity, node_mass, flux, reach];
        team.rows(partition, spare, |row, out| carry_momentum(grid, axis, row, inputs, out));
        std::mem::swap(velocity, spare);
    }
    team.rows(partition, node_mass, |row, out| carry_mass(grid, axis, row, flux, out));
}

/// Lets nothing into the `filled` cells, in the order of the memory, but from one into another: to the nodes
/// a surface within a cell is none, and what they drive into the body stays before it.
fn close(filled: &[usize], stride: usize, flux: &mut [Real]) {
    let is_filled = |cell: usize| filled.binary_search(&cell).is_ok();
    for &low in filled {
        let high = low + stride;
        if !is_filled(low - stride) {
            flux[low] = flux[low].min(0.0);
        }
        if !is_filled(high) {
            flux[high] = flux[high].max(0.0);
        }
    }
}

/// Masses of a row of nodes from those of the cells [kg].
pub(crate) fn nodal_masses(grid: &Grid, row: usize, cell_mass: &[Real], node_mass: &mut [Real]) {
    let [nx, ny, _] = grid.cells();
    let [x, y, z] = grid.stride;
    if (1..=ny + 1).contains(&grid.row_and_plane(row)[0]) {
        for i in 0..=nx {
            let at = |offset: usize| {
                let c = row * y + i + 1 - offset;
                cell_mass[c] + cell_mass[c - x]
            };
            node_mass[i + 1] = 0.125 * ((at(0) + at(y)) + (at(z) + at(y + z)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sweeps_together_undo_the_displacement() {
        let faces = |n: usize| (0..=n).map(|i| i as f64 + 0.03 * (i * i) as f64).collect::<Vec<_>>();
        let grid = Grid::new([5, 4, 3].map(faces));
        let mut displacement: [Vec<Real>; 3] = std::array::from_fn(|_| vec![0.0; grid.entries]);
        let mut seed = 1_u32;
        for (axis, u) in displacement.iter_mut().enumerate() {
            for n in 0..6 * 5 * 4 {
                let layers = [n % 6, n / 6 % 5, n / 30];
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                // No wall moves.
                if (1..grid.cells()[axis]).contains(&layers[axis]) {
                    u[grid.index(layers[0], layers[1], layers[2])] =
                        0.1 * (f64::from(seed >> 8) / 2.0_f64.powi(24)) as Real;
                }
            }
        }
        let row_active = vec![true; grid.entries / grid.stride[1]];
        let mut swelled = 0;
        for layers in (0..5 * 4 * 3).map(|n| [n % 5, n / 5 % 4, n / 20]) {
            let [i, j, k] = layers;
            let row = (k + 1) * grid.rows() + j + 1;
            let volume = grid.volume(i, j, k);
            let mut cells = vec![0.0; grid.stride[1]];
            cells[i + 1] = (volume + swollen(&grid, &displacement, layers)) as Real;
            swelled += usize::from((f64::from(cells[i + 1]) / volume - 1.0).abs() > 1e-3);
            for (axis, u) in displacement.iter().enumerate() {
                let sweep = Sweep { grid: &grid, axis, row_active: &row_active };
                sweep.undo_displacement(row, u, &mut cells);
            }
            let error = f64::from(cells[i + 1]) / volume - 1.0;
            assert!(error.abs() < 8.0 * f64::from(Real::EPSILON), "cell {layers:?}: {error}");
        }
        assert!(swelled > 50, "only {swelled} cells changed their volume");
    }
}
