//! The Eulerian stage: what the soil has become on the displaced grid is carried back to the grid that stands.
//!
//! One conservative sweep along each axis, the order changing from remap to remap. The volume fraction is carried with
//! a reconstructed interface, stress and history with the soil volume at second order, momentum on the dual grid.

use super::flux::Filling;
use super::settle::settle;
use super::transport::{Sweep, carry_mass, carry_momentum, dual_fluxes, dual_reaches};
use super::workspace::Workspace;
use super::{Nodes, Real, Soil, State, contact, energy};
use crate::grid::Grid;
use crate::model::Model;

/// What a remap has taken away.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RemapLoss {
    /// Kinetic and elastic energy [J].
    pub energy: f64,
    /// Volume of the crumbs that were taken out [m³].
    pub volume: f64,
    /// Their mass [kg].
    pub mass: f64,
}

/// The six orders of the axes; each begins where the last ended, so that no axis is favoured.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [2, 0, 1], [1, 2, 0], [2, 1, 0], [0, 2, 1], [1, 0, 2]];

/// Carries everything back to the grid. Afterwards the displacement is zero, the nodal masses are those of the cells,
/// and every stress is admissible.
pub fn remap(model: &Model, state: &mut State, workspace: &mut Workspace) -> RemapLoss {
    let before = energy::total(model, state, workspace);
    let active = spread(&model.grid, &workspace.row_has_soil);
    displaced_volumes(model, state, workspace);
    let order = ORDERS[(state.remaps % 6) as usize];
    for axis in order {
        if model.grid.cells()[axis] > 1 {
            sweep(model, state, workspace, axis, &active);
        }
    }
    let [volume, mass] = settle(model, &mut state.soil, workspace, &active);
    begin_anew(&model.grid, state, workspace);
    contact::expel(model, state, workspace);
    stop_massless(model, state, workspace);
    workspace.find_soil(&model.grid, &state.soil.fraction);
    workspace.clear = 2;
    state.remaps += 1;
    RemapLoss { energy: before - energy::total(model, state, workspace), volume, mass }
}

/// Rows that hold soil or lie beside one that does.
fn spread(grid: &Grid, row_has_soil: &[bool]) -> Vec<bool> {
    let rows = grid.rows();
    let planes = row_has_soil.len() / rows;
    let mut active = vec![false; row_has_soil.len()];
    for plane in 0..planes {
        for row in 0..rows {
            let near = |p: usize, r: usize| row_has_soil.get(p * rows + r).copied().unwrap_or(false);
            active[plane * rows + row] = (plane.saturating_sub(1)..=plane + 1)
                .any(|p| (row.saturating_sub(1)..=(row + 1).min(rows - 1)).any(|r| near(p, r)));
        }
    }
    active
}

/// The arrays of a remap. The old velocities are worth nothing between steps: their memory is used again.
struct Room<'a> {
    /// Soil volume of the cells on the displaced grid [m³].
    soil: &'a mut Vec<Real>,
    /// Volume of the displaced cells [m³].
    cell: &'a mut Vec<Real>,
    /// Soil volume that crosses the faces [m³], later the mass that crosses the dual faces [kg].
    flux: &'a mut Vec<Real>,
}

impl<'a> Room<'a> {
    fn of([soil, cell, flux]: &'a mut [Vec<Real>; 3]) -> Self {
        Self { soil, cell, flux }
    }
}

/// Volumes of soil and cells on the displaced grid.
fn displaced_volumes(model: &Model, state: &State, workspace: &mut Workspace) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    let Workspace { team, cut, velocity_before, .. } = workspace;
    let Room { soil, cell, .. } = Room::of(velocity_before);
    let displacement = &state.nodes.displacement;
    team.rows2(cut, soil, cell, |row, soil, cell| {
        soil.fill(0.0);
        cell.fill(0.0);
        let [q, plane] = grid.row_place(row);
        if (1..=ny).contains(&q) && plane <= nz {
            for i in 0..nx {
                let volume =
                    grid.volume(i, q - 1, plane - 1) + swollen(grid, displacement, [i, q - 1, plane - 1]);
                cell[i + 1] = volume as Real;
                soil[i + 1] = state.soil.fraction[row * grid.stride[1] + i + 1] * cell[i + 1];
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

/// One sweep: volume, mass, stress and history, momentum. Arrays that have served their purpose make room for others: the
/// displacement along the axis for the reaches, the volume fractions for what is being carried.
fn sweep(model: &Model, state: &mut State, workspace: &mut Workspace, axis: usize, active: &[bool]) {
    let grid = &model.grid;
    let Workspace { team, cut, velocity_before, .. } = workspace;
    let Room { soil, cell, flux } = Room::of(velocity_before);
    team.rows(cut, &mut state.soil.fraction, |row, out| {
        let own = row * out.len()..(row + 1) * out.len();
        for ((f, soil), cell) in out.iter_mut().zip(&soil[own.clone()]).zip(&cell[own]) {
            *f = if *cell > 0.0 { soil / cell } else { 0.0 };
        }
    });
    let Soil { fraction, mass, stress, plastic_strain, gap_strain } = &mut state.soil;
    let Nodes { velocity, displacement, mass: node_mass } = &mut state.nodes;
    let displacement = &mut displacement[axis];
    let sweep = Sweep { grid, axis, row_active: active };
    let filling = Filling { sweep, displacement, fraction, soil, cell };
    team.rows(cut, flux, |row, out| filling.volume_fluxes(row, out));
    team.rows(cut, cell, |row, out| sweep.undo_displacement(row, displacement, out));
    let reach = displacement;
    team.rows(cut, reach, |row, out| sweep.reaches(row, [flux, fraction, soil], out));
    let spare = fraction;
    let faces: [&[Real]; 2] = [flux, reach];
    for field in stress.iter_mut().chain([plastic_strain, gap_strain]) {
        team.rows(cut, spare, |row, out| sweep.carry(row, [soil, field], faces, out));
        std::mem::swap(field, spare);
    }
    team.rows(cut, spare, |row, out| sweep.mass_fluxes(row, [soil, mass], faces, out));
    team.rows(cut, mass, |row, out| sweep.difference(row, spare, out));
    team.rows(cut, soil, |row, out| sweep.difference(row, flux, out));
    // The mass flux is in `spare`; the volume flux is done with and makes room for the dual flux.
    team.rows(cut, flux, |row, out| dual_fluxes(grid, axis, row, spare, out));
    let mass_moved = model.mass_moved() as Real;
    team.rows(cut, reach, |row, out| dual_reaches(grid, axis, row, [node_mass, flux], mass_moved, out));
    for velocity in velocity {
        let inputs: [&[Real]; 4] = [velocity, node_mass, flux, reach];
        team.rows(cut, spare, |row, out| carry_momentum(grid, axis, row, inputs, out));
        std::mem::swap(velocity, spare);
    }
    team.rows(cut, node_mass, |row, out| carry_mass(grid, axis, row, flux, out));
}

/// The displacement begins anew, the nodes get the masses of the cells round them, and the room is left as it was found:
/// zero where no soil is.
fn begin_anew(grid: &Grid, state: &mut State, workspace: &mut Workspace) {
    let Workspace { team, cut, velocity_before, .. } = workspace;
    for array in state.nodes.displacement.iter_mut().chain(velocity_before) {
        team.rows(cut, array, |_, out| out.fill(0.0));
    }
    let cells = &state.soil.mass;
    team.rows(cut, &mut state.nodes.mass, |row, out| lagrange_mass(grid, row, cells, out));
}

/// Masses of a row of nodes from those of the cells [kg].
pub(crate) fn lagrange_mass(grid: &Grid, row: usize, cell_mass: &[Real], node_mass: &mut [Real]) {
    let [nx, ny, _] = grid.cells();
    let [x, y, z] = grid.stride;
    if (1..=ny + 1).contains(&grid.row_place(row)[0]) {
        for i in 0..=nx {
            let at = |offset: usize| {
                let c = row * y + i + 1 - offset;
                cell_mass[c] + cell_mass[c - x]
            };
            node_mass[i + 1] = 0.125 * ((at(0) + at(y)) + (at(z) + at(y + z)));
        }
    }
}

/// Nodes that have lost their soil stop; only now, not between sweeps.
fn stop_massless(model: &Model, state: &mut State, workspace: &Workspace) {
    let Workspace { team, cut, .. } = workspace;
    let (mass_moved, mass) = (model.mass_moved() as Real, &state.nodes.mass);
    for v in &mut state.nodes.velocity {
        team.rows(cut, v, |row, out| {
            for (v, m) in out.iter_mut().zip(&mass[row * cut.stride..]) {
                if *m <= mass_moved {
                    *v = 0.0;
                }
            }
        });
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
                let place = [n % 6, n / 6 % 5, n / 30];
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                // No wall moves.
                if (1..grid.cells()[axis]).contains(&place[axis]) {
                    u[grid.index(place[0], place[1], place[2])] =
                        0.1 * (f64::from(seed >> 8) / 2.0_f64.powi(24)) as Real;
                }
            }
        }
        let row_active = vec![true; grid.entries / grid.stride[1]];
        let mut swelled = 0;
        for place in (0..5 * 4 * 3).map(|n| [n % 5, n / 5 % 4, n / 20]) {
            let [i, j, k] = place;
            let row = (k + 1) * grid.rows() + j + 1;
            let volume = grid.volume(i, j, k);
            let mut cells = vec![0.0; grid.stride[1]];
            cells[i + 1] = (volume + swollen(&grid, &displacement, place)) as Real;
            swelled += usize::from((f64::from(cells[i + 1]) / volume - 1.0).abs() > 1e-3);
            for (axis, u) in displacement.iter().enumerate() {
                let sweep = Sweep { grid: &grid, axis, row_active: &row_active };
                sweep.undo_displacement(row, u, &mut cells);
            }
            let error = f64::from(cells[i + 1]) / volume - 1.0;
            assert!(error.abs() < 8.0 * f64::from(Real::EPSILON), "cell {place:?}: {error}");
        }
        assert!(swelled > 50, "only {swelled} cells changed their volume");
    }
}
