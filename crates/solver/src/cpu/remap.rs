//! The Eulerian stage: what the soil has become on the displaced grid is carried back to the grid that stands.
//!
//! One conservative sweep along each axis, the order changing from remap to remap. The volume fraction is carried with
//! a reconstructed interface, stress and history with the soil volume at second order, momentum on the dual grid.

use super::flux::Filling;
use super::transport::{Sweep, carry_mass, carry_momentum, difference, dual_fluxes, dual_reaches};
use super::workspace::Workspace;
use super::{Nodes, Real, Soil, State, contact, energy};
use crate::grid::Grid;
use crate::model::{FRACTION_KEPT, FRACTION_STRESSED, Model};
use physics::strength::Strength;
use physics::tensor::{Symmetric, mean};
use std::ops::Range;

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
    let mut loss = settle(model, &mut state.soil, workspace);
    begin_anew(&model.grid, state, workspace);
    contact::expel(model, state, workspace);
    stop_massless(model, state, workspace);
    workspace.find_soil(&model.grid, &state.soil.fraction);
    workspace.clear = 2;
    state.remaps += 1;
    loss.energy = before - energy::total(model, state, workspace);
    loss
}

/// Rows that hold soil or lie beside one that does.
fn spread(grid: &Grid, row_has_soil: &[bool]) -> Vec<bool> {
    let rows = Workspace::rows(grid);
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
    team.planes2(cut, soil, cell, |plane, soil, cell| {
        soil.fill(0.0);
        cell.fill(0.0);
        let k = plane - 1;
        for j in (0..ny).filter(|_| k < nz) {
            for i in 0..nx {
                let c = grid.index(i, j, k);
                let own = c - plane * grid.stride[2];
                let volume = grid.volume(i, j, k) + swollen(grid, state, [i, j, k]);
                cell[own] = volume as Real;
                soil[own] = state.soil.fraction[c] * cell[own];
            }
        }
    });
}

/// Volume that a cell has gained by the displacement of its corners [m³], linear in it like the strain.
fn swollen(grid: &Grid, state: &State, [i, j, k]: [usize; 3]) -> f64 {
    let c = grid.index(i, j, k);
    let widths = [grid.width(0, i), grid.width(1, j), grid.width(2, k)];
    let mut gain = 0.0;
    for axis in 0..3 {
        let (a, b) = (grid.stride[(axis + 1) % 3], grid.stride[(axis + 2) % 3]);
        let u = &state.nodes.displacement[axis];
        let u = |c: usize| f64::from(u[c]);
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
    team.planes(cut, &mut state.soil.fraction, |plane, out| {
        let base = plane * grid.stride[2];
        for (n, f) in out.iter_mut().enumerate() {
            let c = base + n;
            *f = if cell[c] > 0.0 { soil[c] / cell[c] } else { 0.0 };
        }
    });
    let Soil { fraction, mass, stress, plastic_strain, gap_strain } = &mut state.soil;
    let Nodes { velocity, displacement, mass: node_mass } = &mut state.nodes;
    let displacement = &mut displacement[axis];
    let sweep = Sweep { grid, axis, row_active: active };
    let filling = Filling { sweep, displacement, fraction, soil, cell };
    team.planes(cut, flux, |plane, out| filling.volume_fluxes(plane, out));
    team.planes(cut, cell, |plane, out| sweep.undo_displacement(plane, displacement, out));
    let reach = displacement;
    team.planes(cut, reach, |plane, out| sweep.reaches(plane, [flux, fraction, soil], out));
    let spare = fraction;
    let faces: [&[Real]; 2] = [flux, reach];
    for field in stress.iter_mut().chain([plastic_strain, gap_strain]) {
        team.planes(cut, spare, |plane, out| sweep.carry(plane, [soil, field], faces, out));
        std::mem::swap(field, spare);
    }
    team.planes(cut, spare, |plane, out| {
        out.fill(0.0);
        sweep.mass_fluxes(plane, [soil, mass], faces, out);
    });
    team.planes(cut, mass, |plane, out| difference(grid, axis, plane, spare, out));
    team.planes(cut, soil, |plane, out| difference(grid, axis, plane, flux, out));
    // The mass flux is in `spare`; the volume flux is done with and makes room for the dual flux.
    team.planes(cut, flux, |plane, out| dual_fluxes(grid, axis, plane, spare, out));
    let mass_moved = model.mass_moved() as Real;
    team.planes(cut, reach, |plane, out| dual_reaches(grid, axis, plane, [node_mass, flux], mass_moved, out));
    for velocity in velocity {
        let inputs: [&[Real]; 4] = [velocity, node_mass, flux, reach];
        team.planes(cut, spare, |plane, out| carry_momentum(grid, axis, plane, inputs, out));
        std::mem::swap(velocity, spare);
    }
    team.planes(cut, node_mass, |plane, out| carry_mass(grid, axis, plane, flux, out));
}

/// A worker's planes of what the cells hold.
struct Part<'a> {
    planes: Range<usize>,
    fraction: &'a mut [Real],
    mass: &'a mut [Real],
    stress: [&'a mut [Real]; 6],
    plastic_strain: &'a mut [Real],
    gap_strain: &'a mut [Real],
    /// Volume and mass of the crumbs by row.
    crumbs: &'a mut [[f64; 2]],
}

/// Back to volume fractions: takes crumbs out, closes gaps that stand under pressure, returns stresses to the yield
/// surface.
fn settle(model: &Model, soil: &mut Soil, workspace: &mut Workspace) -> RemapLoss {
    let rows = Workspace::rows(&model.grid);
    let Workspace { team, cut, velocity_before, row_values, .. } = workspace;
    let volume = &*Room::of(velocity_before).soil;
    let Soil { fraction, mass, stress, plastic_strain, gap_strain } = soil;
    let mut stress = stress.each_mut().map(|s| cut.split(s));
    let fields =
        cut.split(fraction).zip(cut.split(mass)).zip(cut.split(plastic_strain)).zip(cut.split(gap_strain));
    let crumbs = cut.split_by(rows, row_values);
    let parts = cut.ranges().zip(fields).zip(crumbs).map(
        move |((planes, (((fraction, mass), plastic_strain), gap_strain)), crumbs)| {
            let stress = stress.each_mut().map(|s| s.next().unwrap_or_default());
            Part { planes, fraction, mass, stress, plastic_strain, gap_strain, crumbs }
        },
    );
    team.deal(parts, |part| settle_part(model, volume, part));
    let [volume, mass] = workspace.total_of_rows();
    RemapLoss { energy: 0.0, volume, mass }
}

fn settle_part(model: &Model, volume: &[Real], part: &mut Part) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    let [_, row, stride] = grid.stride;
    // What was carried last lies in the fractions' memory, ghosts and all.
    part.fraction.fill(0.0);
    part.crumbs.fill([0.0; 2]);
    for plane in part.planes.clone().filter(|plane| *plane <= nz) {
        let local = (plane - part.planes.start) * stride;
        for j in 0..ny {
            let crumbs = &mut part.crumbs[(plane - part.planes.start) * (stride / row) + j + 1];
            for i in 0..nx {
                let n = (j + 1) * row + i + 1;
                let (c, own) = (plane * stride + n, local + n);
                let whole = grid.volume(i, j, plane - 1);
                let mut cell = Cell {
                    fraction: f64::from(volume[c]) / whole,
                    mass: part.mass[own].into(),
                    stress: part.stress.each_ref().map(|s| s[own].into()),
                    plastic_strain: part.plastic_strain[own].into(),
                    gap_strain: part.gap_strain[own].into(),
                };
                if cell.fraction < FRACTION_KEPT {
                    crumbs[0] += f64::from(volume[c]);
                    crumbs[1] += cell.mass;
                    (cell.fraction, cell.mass) = (0.0, 0.0);
                }
                let cell = cell.settled(model, whole);
                part.fraction[own] = cell.fraction as Real;
                part.mass[own] = cell.mass as Real;
                part.plastic_strain[own] = cell.plastic_strain as Real;
                part.gap_strain[own] = cell.gap_strain as Real;
                for (field, value) in part.stress.iter_mut().zip(cell.stress) {
                    field[own] = value as Real;
                }
            }
        }
    }
}

/// What one cell holds.
struct Cell {
    fraction: f64,
    mass: f64,
    stress: Symmetric,
    plastic_strain: f64,
    gap_strain: f64,
}

impl Cell {
    /// With gaps closed that stand under pressure and the stress returned to the yield surface; `volume` is the cell's [m³].
    fn settled(self, model: &Model, volume: f64) -> Self {
        if self.fraction <= FRACTION_STRESSED {
            let plastic_strain = if self.fraction > 0.0 { self.plastic_strain } else { 0.0 };
            return Self { stress: [0.0; 6], gap_strain: 0.0, plastic_strain, ..self };
        }
        let mut stress = self.stress;
        let mut gap = self.gap_strain.max(0.0);
        // Soil with a gap was mixed with soil under pressure: let the pressure close the gap, or its volume is lost.
        let bulk = model.elastic.bulk;
        let pressure = -mean(stress);
        if gap > 0.0 && pressure > 0.0 {
            let closed = gap.min(pressure / bulk);
            gap -= closed;
            for s in &mut stress[..3] {
                *s += bulk * closed;
            }
        }
        if let Some(strength) = &model.strength
            && strength.may_yield(stress, self.plastic_strain)
        {
            let critical = model.critical_density.unwrap_or(0.0) * self.fraction * volume;
            let back = strength.return_map(stress, self.plastic_strain, self.mass >= critical);
            stress = back.stress;
            gap += back.gap_strain;
        }
        Self { stress, gap_strain: gap, ..self }
    }
}

/// Settles a cell that soil has come into.
pub(crate) fn settle_cell(model: &Model, soil: &mut Soil, c: usize, volume: f64) {
    let cell = Cell {
        fraction: soil.fraction[c].into(),
        mass: soil.mass[c].into(),
        stress: soil.stress.each_ref().map(|s| s[c].into()),
        plastic_strain: soil.plastic_strain[c].into(),
        gap_strain: soil.gap_strain[c].into(),
    };
    let cell = cell.settled(model, volume);
    soil.plastic_strain[c] = cell.plastic_strain as Real;
    soil.gap_strain[c] = cell.gap_strain as Real;
    for (field, value) in soil.stress.iter_mut().zip(cell.stress) {
        field[c] = value as Real;
    }
}

/// The displacement begins anew, the nodes get the masses of the cells round them, and the room is left as it was found:
/// zero where no soil is.
fn begin_anew(grid: &Grid, state: &mut State, workspace: &mut Workspace) {
    let Workspace { team, cut, velocity_before, .. } = workspace;
    for array in state.nodes.displacement.iter_mut().chain(velocity_before) {
        team.planes(cut, array, |_, out| out.fill(0.0));
    }
    let cells = &state.soil.mass;
    team.planes(cut, &mut state.nodes.mass, |plane, out| lagrange_mass(grid, plane, cells, out));
}

/// Masses of a storage plane of nodes from those of the cells [kg].
pub(crate) fn lagrange_mass(grid: &Grid, plane: usize, cell_mass: &[Real], node_mass: &mut [Real]) {
    let [nx, ny, _] = grid.cells();
    let [x, y, z] = grid.stride;
    for j in 0..=ny {
        for i in 0..=nx {
            let n = (j + 1) * y + i + 1;
            let at = |offset: usize| {
                let c = plane * z + n - offset;
                cell_mass[c] + cell_mass[c - x]
            };
            node_mass[n] = 0.125 * ((at(0) + at(y)) + (at(z) + at(y + z)));
        }
    }
}

/// Nodes that have lost their soil stop; only now, not between sweeps.
fn stop_massless(model: &Model, state: &mut State, workspace: &Workspace) {
    let Workspace { team, cut, .. } = workspace;
    let (mass_moved, mass) = (model.mass_moved() as Real, &state.nodes.mass);
    for v in &mut state.nodes.velocity {
        team.planes(cut, v, |plane, out| {
            for (v, m) in out.iter_mut().zip(&mass[plane * cut.stride..]) {
                if *m <= mass_moved {
                    *v = 0.0;
                }
            }
        });
    }
}
