//! The Eulerian stage: what the soil has become on the displaced grid is carried back to the grid.
//!
//! The grid moves after the body that it follows, if any. One conservative sweep along each axis, the order
//! changing from remap to remap; then volume fractions, admissible stresses and nodal masses are updated, and
//! the soil that overlaps a body is moved out of it.

use crate::contact;
use crate::cpu::fields_on_device::DeviceRemap;
use crate::cpu::stopwatch::Stage;
use crate::cpu::workspace::SoilWorkspace;
use crate::enclosed;
use crate::energy;
use crate::ghosts::{self, Beyond, Ghosts};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::halo::filling::{At, fill};
use crate::kernels::Kernels;
use crate::model::Model;
use crate::state::{Nodes, State};
use crate::workspace::Workspace;

/// The six orders of the axes; each begins where the last ended, so that no axis is favoured. 0 is the
/// horizontal axis along which the soil is driven ([`Model::is_driven_along_y`]), 1 the other one.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [2, 0, 1], [1, 2, 0], [2, 1, 0], [0, 2, 1], [1, 0, 2]];

/// Carries everything back to the grid. Afterwards the displacement is zero, the nodal masses are those of
/// the cells, and every stress is admissible. What is lost is entered into the energy balance.
pub fn remap<R: Kernels>(model: &Model, state: &mut State<R>, workspace: &mut Workspace<R>) {
    let Workspace { soil, contact, halo, beyond, .. } = workspace;
    let (grid, halo) = (&model.grid, halo);
    let before = energy::total(model, state, soil, halo) - state.energy_balance.inflow_elastic;
    let active = rows_near_soil(grid, &soil.row_has_soil);
    // Since the last remap only the first of the ghost layers has been strained and moved.
    fill(halo, grid, At::Cells, state.soil.arrays_mut());
    let Nodes { displacement, velocity, .. } = &mut state.nodes;
    fill(halo, grid, At::Nodes, displacement.iter_mut().chain(velocity));
    let shift = ghosts::follow(model, state);
    R::begin_remap(model, state, soil, &active, shift);
    R::displaced_volumes(model, state, soil);
    take_ghosts(model, state, soil);
    let mut ghosts = Ghosts::new(model, state, &soil.velocity_before[0], &contact.body_cells, halo);
    let axes = if model.is_driven_along_y() { [1, 0, 2] } else { [0, 1, 2] };
    let order = ORDERS[(state.remaps % 6) as usize].map(|n| axes[n]);
    let filled = contact::filled(&contact.body_cells);
    for axis in order.into_iter().filter(|axis| grid.whole_cells()[*axis] > 1) {
        R::sweep(model, state, soil, axis, &active, &filled);
        fill_swept(model, state, soil, ghosts.as_mut(), halo);
    }
    R::update_after_remap(model, &mut state.soil, soil, &active);
    if let Some(ghosts) = ghosts {
        take_ghosts(model, state, soil);
        ghosts.finish(model, &mut state.soil);
        give_ghosts(model, state, soil);
    }
    // Whether a row next to the outermost ghost layer holds soil, only its owner knows: debris would stay in
    // that layer.
    fill(halo, grid, At::Cells, state.soil.arrays_mut());
    let [volume, mass] = soil.total_of_rows(grid, halo);
    R::reset_nodes(model, state, soil);
    fill(halo, grid, At::Nodes, [&mut state.nodes.mass]);
    contact::remove_overlap(model, state, soil, contact, halo);
    contact::carry(model, state, &contact.body_cells);
    if let Some(device) = &mut soil.device {
        device.give_region(model, state);
    }
    R::stop_massless(model, state, soil);
    soil.find_soil(grid, &state.soil);
    enclosed::lend(model, state, soil);
    contact.confined = contact::find_confined(grid, &state.soil, &contact.body_cells);
    if model.follow.is_some() {
        *beyond = Beyond::new(model, state);
    }
    R::average_density(model, &mut state.soil, soil, halo);
    soil.clear = 2;
    state.remaps += 1;
    let after = energy::total(model, state, soil, halo) - state.energy_balance.inflow_elastic;
    state.energy_balance.remap += before - after;
    state.energy_balance.debris_volume += volume;
    state.energy_balance.debris_mass += mass;
    soil.stopwatch().lap(Stage::Remap);
}

/// Fills the ghost layers after a sweep: with what lies beyond open faces, and with what other blocks have
/// carried.
fn fill_swept<R: Kernels>(
    model: &Model,
    state: &mut State<R>,
    workspace: &mut SoilWorkspace<R>,
    ghosts: Option<&mut Ghosts<'_, R>>,
    halo: &Halo,
) {
    let grid = &model.grid;
    if let Some(ghosts) = ghosts {
        take_ghosts(model, state, workspace);
        let [soil, cell, _] = &mut workspace.velocity_before;
        ghosts.renew(model, state, [soil, cell], halo);
        give_ghosts(model, state, workspace);
    }
    let [soil, cell, _] = &mut workspace.velocity_before;
    let State { soil: fields, nodes, .. } = state;
    let cells = fields.arrays_mut().chain([soil, cell]);
    fill(halo, grid, At::Cells, cells);
    fill(halo, grid, At::Nodes, nodes.velocity.iter_mut().chain([&mut nodes.mass]));
}

/// Takes what lies in the ghost layers and beside them from a device.
fn take_ghosts<R: Kernels>(model: &Model, state: &mut State<R>, workspace: &mut SoilWorkspace<R>) {
    let SoilWorkspace { device, velocity_before, .. } = workspace;
    if let Some(device) = device {
        device.take_ghosts(model, state, velocity_before);
    }
}

/// Gives it back.
fn give_ghosts<R: Kernels>(model: &Model, state: &mut State<R>, workspace: &mut SoilWorkspace<R>) {
    let SoilWorkspace { device, velocity_before, .. } = workspace;
    if let Some(device) = device {
        device.give_ghosts(model, state, velocity_before);
    }
}

/// Rows that hold soil or lie beside one that does.
fn rows_near_soil(grid: &Grid, row_has_soil: &[bool]) -> Vec<bool> {
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
