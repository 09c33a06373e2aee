//! The Eulerian stage: what the soil has become on the displaced grid is carried back to the grid that stands.
//!
//! One conservative sweep along each axis, the order changing from remap to remap. The volume fraction is carried with
//! a reconstructed interface, stress and history with the soil volume at second order, momentum on the dual grid.

use super::transport::{Sweep, carry_mass, carry_momentum, difference, dual_fluxes, dual_reaches};
use super::workspace::Workspace;
use super::{Nodes, Real, Soil, State, contact, energy};
use crate::grid::Grid;
use crate::model::{FRACTION_KEPT, FRACTION_STRESSED, Model};
use physics::strength::Strength;
use physics::tensor::mean;

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
    let before = energy::elastic(model, &state.soil) + energy::kinetic(&state.nodes);
    let active = spread(&model.grid, &workspace.row_has_soil);
    displaced_volumes(model, state, workspace);
    let order = ORDERS[(state.remaps % 6) as usize];
    for axis in order {
        if model.grid.cells()[axis] > 1 {
            sweep(model, state, workspace, axis, &active);
        }
    }
    let mut loss = settle(model, &mut state.soil, &workspace.scratch[0]);
    for u in &mut state.nodes.displacement {
        u.fill(0.0);
    }
    lagrange_mass(&model.grid, &state.soil.mass, &mut state.nodes.mass);
    contact::expel(model, state, workspace);
    stop_massless(model, state);
    workspace.find_soil(&model.grid, &state.soil.fraction);
    state.remaps += 1;
    loss.energy = before - energy::elastic(model, &state.soil) - energy::kinetic(&state.nodes);
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
    /// Volume that the faces sweep [m³].
    swept: &'a mut Vec<Real>,
    /// How far along a slope the value lies that a flux carries [cells].
    reach: &'a mut Vec<Real>,
    spare: &'a mut Vec<Real>,
}

impl<'a> Room<'a> {
    fn of(scratch: &'a mut [Vec<Real>; 3], velocity_before: &'a mut [Vec<Real>; 3]) -> Self {
        let [soil, flux, spare] = scratch;
        let [cell, swept, reach] = velocity_before;
        Self { soil, cell, flux, swept, reach, spare }
    }
}

/// Volumes of soil and cells on the displaced grid.
fn displaced_volumes(model: &Model, state: &State, workspace: &mut Workspace) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    let Workspace { team, cut, scratch, velocity_before, .. } = workspace;
    let Room { soil, cell, .. } = Room::of(scratch, velocity_before);
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

/// One sweep: volume, mass, stress and history, momentum.
fn sweep(model: &Model, state: &mut State, workspace: &mut Workspace, axis: usize, active: &[bool]) {
    let grid = &model.grid;
    let Workspace { team, cut, scratch, velocity_before, .. } = workspace;
    let Room { soil, cell, flux, swept, reach, spare } = Room::of(scratch, velocity_before);
    team.planes(cut, &mut state.soil.fraction, |plane, out| {
        let base = plane * grid.stride[2];
        for (n, f) in out.iter_mut().enumerate() {
            let c = base + n;
            *f = if cell[c] > 0.0 { soil[c] / cell[c] } else { 0.0 };
        }
    });
    let Soil { fraction, mass, stress, plastic_strain, gap_strain } = &mut state.soil;
    let sweep = Sweep {
        grid,
        axis,
        displacement: &state.nodes.displacement[axis],
        fraction,
        soil,
        cell,
        row_active: active,
    };
    team.planes2(cut, flux, swept, |plane, flux, swept| sweep.volume_fluxes(plane, flux, swept));
    team.planes(cut, reach, |plane, out| sweep.reaches(plane, flux, out));
    let faces: [&[Real]; 2] = [flux, reach];
    for field in stress.iter_mut().chain([plastic_strain, gap_strain]) {
        team.planes(cut, spare, |plane, out| sweep.carry(plane, field, faces, out));
        std::mem::swap(field, spare);
    }
    team.planes(cut, spare, |plane, out| {
        out.fill(0.0);
        sweep.mass_fluxes(plane, mass, faces, out);
    });
    team.planes(cut, mass, |plane, out| difference(grid, axis, plane, spare, out));
    team.planes(cut, soil, |plane, out| difference(grid, axis, plane, flux, out));
    team.planes(cut, cell, |plane, out| difference(grid, axis, plane, swept, out));
    // The mass flux is in `spare`; the volume flux is done with and makes room for the dual flux.
    team.planes(cut, flux, |plane, out| dual_fluxes(grid, axis, plane, spare, out));
    let Nodes { velocity, mass, .. } = &mut state.nodes;
    let mass_moved = model.mass_moved() as Real;
    team.planes(cut, reach, |plane, out| dual_reaches(grid, axis, plane, [mass, flux], mass_moved, out));
    for velocity in velocity {
        let inputs: [&[Real]; 4] = [velocity, mass, flux, reach];
        team.planes(cut, spare, |plane, out| carry_momentum(grid, axis, plane, inputs, out));
        std::mem::swap(velocity, spare);
    }
    team.planes(cut, mass, |plane, out| carry_mass(grid, axis, plane, flux, out));
    spare.fill(0.0);
}

/// Back to volume fractions: takes crumbs out, closes gaps that stand under pressure, returns stresses to the yield
/// surface.
fn settle(model: &Model, soil: &mut Soil, volume: &[Real]) -> RemapLoss {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    let mut loss = RemapLoss::default();
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let c = grid.index(i, j, k);
                let fraction = f64::from(volume[c]) / grid.volume(i, j, k);
                soil.fraction[c] = fraction as Real;
                if fraction < FRACTION_KEPT {
                    loss.volume += f64::from(volume[c]);
                    loss.mass += f64::from(soil.mass[c]);
                    (soil.fraction[c], soil.mass[c]) = (0.0, 0.0);
                }
                settle_cell(model, soil, c, grid.volume(i, j, k));
            }
        }
    }
    loss
}

pub(crate) fn settle_cell(model: &Model, soil: &mut Soil, c: usize, volume: f64) {
    let fraction = f64::from(soil.fraction[c]);
    if fraction <= FRACTION_STRESSED {
        for s in &mut soil.stress {
            s[c] = 0.0;
        }
        soil.gap_strain[c] = 0.0;
        soil.plastic_strain[c] = if fraction > 0.0 { soil.plastic_strain[c] } else { 0.0 };
        return;
    }
    let mut stress = soil.stress.each_ref().map(|s| f64::from(s[c]));
    let mut gap = f64::from(soil.gap_strain[c]).max(0.0);
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
    let plastic_strain = f64::from(soil.plastic_strain[c]);
    if let Some(strength) = &model.strength
        && strength.may_yield(stress, plastic_strain)
    {
        let critical = model.critical_density.unwrap_or(0.0) * fraction * volume;
        let back = strength.return_map(stress, plastic_strain, f64::from(soil.mass[c]) >= critical);
        stress = back.stress;
        gap += back.gap_strain;
    }
    for (field, value) in soil.stress.iter_mut().zip(stress) {
        field[c] = value as Real;
    }
    soil.gap_strain[c] = gap as Real;
}

/// Nodes that have lost their soil stop; only now, not between sweeps.
fn stop_massless(model: &Model, state: &mut State) {
    let mass_moved = model.mass_moved() as Real;
    for v in &mut state.nodes.velocity {
        for (v, m) in v.iter_mut().zip(&state.nodes.mass) {
            if *m <= mass_moved {
                *v = 0.0;
            }
        }
    }
}

/// Nodal masses from the masses of the cells [kg].
pub(crate) fn lagrange_mass(grid: &Grid, cell_mass: &[Real], node_mass: &mut [Real]) {
    let [nx, ny, nz] = grid.cells();
    let [x, y, z] = grid.stride;
    for k in 0..=nz {
        for j in 0..=ny {
            for i in 0..=nx {
                let n = grid.index(i, j, k);
                let at = |offset: usize| cell_mass[n - offset] + cell_mass[n - offset - x];
                node_mass[n] = 0.125 * ((at(0) + at(y)) + (at(z) + at(y + z)));
            }
        }
    }
}
