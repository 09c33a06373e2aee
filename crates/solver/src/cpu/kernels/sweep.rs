//! One sweep of a remap: volume, mass, stress and history, and momentum are carried along one axis.
//!
//! The volume fraction is carried with a reconstructed interface, stress and history with the soil volume at
//! second order, momentum on the dual grid.

use super::flux::{FluxInputs, close_face};
use super::remap;
use super::transport::Sweep;
use super::{Nodes, Real, Soil, State, Workspace};
use crate::cpu::fields_on_device::DeviceRemap;
use crate::fields::{Carrier, GAP_STRAIN, HISTORY, HistoryVariable};
use crate::grid::Grid;
use crate::model::Model;
use ::kernels::layout::{Layout, Part};
use glam::DVec3;

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

/// Begins a remap of the `active` rows: takes back the voids that were lent to the soil, and makes the
/// displacements relative to the grid, which has moved by `shift` [m].
pub(crate) fn begin_remap(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    active: &[bool],
    shift: DVec3,
) {
    if let Some(device) = &mut workspace.device {
        return device.begin_remap(model, active, shift);
    }
    let Workspace { team, partition, .. } = workspace;
    let (gap, void) = (&mut state.soil.history[GAP_STRAIN], &mut state.soil.apart);
    team.rows2(partition, gap, void, |_, gap, void| remap::take_back(gap, void));
    for (displacement, shift) in state.nodes.displacement.iter_mut().zip(shift.to_array()) {
        if shift != 0.0 {
            team.rows(partition, displacement, |_, out| remap::shift(out, shift));
        }
    }
}

/// Volumes of soil and cells on the displaced grid.
pub(crate) fn displaced_volumes(model: &Model, state: &State, workspace: &mut Workspace) {
    if let Some(device) = &mut workspace.device {
        return device.displaced_volumes(model);
    }
    let layout = model.grid.layout();
    let Workspace { team, partition, velocity_before, .. } = workspace;
    let Scratch { soil, cell, .. } = Scratch::of(velocity_before);
    let displacement = state.nodes.displacement.each_ref().map(Vec::as_slice);
    let fields = [state.soil.fraction.as_slice(), &state.soil.apart];
    team.rows2(partition, soil, cell, |row, soil, cell| {
        remap::displaced_volumes(&layout, part(&layout, row), displacement, fields, [soil, cell]);
    });
}

/// A row of the memory.
pub(super) fn part(layout: &Layout, row: usize) -> Part {
    Part { start: row * layout.stride[1], length: layout.stride[1] }
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
    if let Some(device) = &mut workspace.device {
        return device.sweep(model, axis, filled);
    }
    let grid = &model.grid;
    let layout = grid.layout();
    let Workspace { team, partition, velocity_before, .. } = workspace;
    let rows = |out: &mut [Real], job: &(dyn Fn(Part, &mut [Real]) + Sync)| {
        team.rows(partition, out, |row, out| job(part(&layout, row), out));
    };
    let Scratch { soil, cell, flux } = Scratch::of(velocity_before);
    rows(&mut state.soil.fraction, &|Part { start, length }, out| {
        remap::volume_fractions(&soil[start..start + length], &cell[start..start + length], out);
    });
    let Soil { fraction, mass, stress, history, composition, .. } = &mut state.soil;
    let Nodes { velocity, displacement, mass: node_mass } = &mut state.nodes;
    let displacement = &mut displacement[axis];
    let sweep = Sweep { layout, axis, row_active: active };
    let inputs = FluxInputs { sweep, displacement, fraction, soil, cell };
    rows(flux, &|part, out| inputs.volume_fluxes(part, out));
    for (face, side) in closed_faces(filled, grid.stride[axis]) {
        close_face(&mut flux[face], side);
    }
    rows(cell, &|part, out| sweep.undo_displacement(part, displacement, out));
    let reach = displacement;
    rows(reach, &|part, out| sweep.reaches(part, [flux, fraction, soil], out));
    let spare = fraction;
    let faces: [&[Real]; 2] = [flux, reach];
    let needed = history.iter_mut().zip(HISTORY).filter(|(field, _)| !field.is_empty());
    let (by_volume, by_mass): (Vec<_>, Vec<_>) =
        needed.partition(|(_, variable)| variable.carrier == Carrier::Volume);
    let fields = |list: Vec<(_, HistoryVariable)>| list.into_iter().map(|(field, _)| field);
    for field in stress.iter_mut().chain(fields(by_volume)).chain(composition) {
        rows(spare, &|part, out| sweep.carry(part, [soil, field], faces, out));
        std::mem::swap(field, spare);
    }
    rows(spare, &|part, out| sweep.mass_fluxes(part, [soil, mass], faces, out));
    rows(soil, &|part, out| sweep.difference(part, flux, out));
    // The volume flux is done with: room for what the mass carries, then for the dual flux.
    for field in fields(by_mass) {
        let faces: [&[Real]; 2] = [spare, reach];
        rows(flux, &|part, out| sweep.carry(part, [mass, field], faces, out));
        std::mem::swap(field, flux);
    }
    rows(mass, &|part, out| sweep.difference(part, spare, out));
    let scratch = [flux, reach, spare];
    carry_momentum(&rows, &sweep, velocity, node_mass, scratch, model.mass_moved() as Real);
}

/// Calls a job for every row of an array, in parallel.
type Rows<'a> = dyn Fn(&mut [Real], &(dyn Fn(Part, &mut [Real]) + Sync)) + 'a;

/// The end of a sweep: momentum is carried with the mass whose flux is in the last of the scratch arrays.
fn carry_momentum(
    rows: &Rows,
    sweep: &Sweep,
    velocity: &mut [Vec<Real>; 3],
    node_mass: &mut [Real],
    [flux, reach, spare]: [&mut Vec<Real>; 3],
    mass_moved: Real,
) {
    rows(flux, &|part, out| sweep.dual_fluxes(part, spare, out));
    rows(reach, &|part, out| sweep.dual_reaches(part, [node_mass, flux], mass_moved, out));
    for velocity in velocity {
        let inputs: [&[Real]; 4] = [velocity, node_mass, flux, reach];
        rows(spare, &|part, out| sweep.carry_momentum(part, inputs, out));
        std::mem::swap(velocity, spare);
    }
    rows(node_mass, &|part, out| sweep.carry_mass(part, flux, out));
}

/// The faces through which nothing may flow into one of the `filled` cells, in the order of the memory, but
/// from another one; and whether the cell lies above the face (1) or below it (−1). To the nodes a surface
/// within a cell is none, and what they drive into the body stays before it.
pub(super) fn closed_faces(filled: &[usize], stride: usize) -> impl Iterator<Item = (usize, Real)> + '_ {
    let is_filled = |cell: usize| filled.binary_search(&cell).is_ok();
    let of_cell = move |low: usize| {
        let high = low + stride;
        [(low, low - stride, 1.0), (high, high, -1.0)]
            .into_iter()
            .filter(move |(_, beyond, _)| !is_filled(*beyond))
            .map(|(face, _, side)| (face, side))
    };
    filled.iter().flat_map(move |cell| of_cell(*cell))
}

/// Masses of a row of nodes from those of the cells [kg].
pub(crate) fn nodal_masses(grid: &Grid, row: usize, cell_mass: &[Real], node_mass: &mut [Real]) {
    let layout = grid.layout();
    remap::nodal_masses(&layout, part(&layout, row), cell_mass, node_mass);
}

/// Sets the displacement to zero, gives the nodes the masses of the cells round them, and leaves the scratch
/// arrays zero where there is no soil, as the Lagrangian stage expects them.
pub(crate) fn reset_nodes(model: &Model, state: &mut State, workspace: &mut Workspace) {
    let Workspace { team, partition, velocity_before, device, .. } = workspace;
    if let Some(device) = device {
        return device.reset_nodes(model, state, velocity_before);
    }
    for array in state.nodes.displacement.iter_mut().chain(velocity_before) {
        team.rows(partition, array, |_, out| out.fill(0.0));
    }
    let cells = &state.soil.mass;
    team.rows(partition, &mut state.nodes.mass, |row, out| nodal_masses(&model.grid, row, cells, out));
}

/// Stops nodes that have lost their soil; only after a remap, not between sweeps.
pub(crate) fn stop_massless(model: &Model, state: &mut State, workspace: &mut Workspace) {
    if let Some(device) = &mut workspace.device {
        return device.stop_massless(model);
    }
    let Workspace { team, partition, .. } = workspace;
    let (mass_moved, mass) = (model.mass_moved() as Real, &state.nodes.mass);
    for v in &mut state.nodes.velocity {
        team.rows(partition, v, |row, out| {
            remap::stop_massless(&mass[row * partition.stride..], mass_moved, out);
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
            let u = displacement.each_ref().map(Vec::as_slice);
            let gain = remap::swollen(&grid.layout(), u, grid.index(i, j, k), layers);
            cells[i + 1] = (volume + gain) as Real;
            swelled += usize::from((f64::from(cells[i + 1]) / volume - 1.0).abs() > 1e-3);
            for (axis, u) in displacement.iter().enumerate() {
                let sweep = Sweep { layout: grid.layout(), axis, row_active: &row_active };
                sweep.undo_displacement(part(&grid.layout(), row), u, &mut cells);
            }
            let error = f64::from(cells[i + 1]) / volume - 1.0;
            assert!(error.abs() < 8.0 * f64::from(Real::EPSILON), "cell {layers:?}: {error}");
        }
        assert!(swelled > 50, "only {swelled} cells changed their volume");
    }
}
