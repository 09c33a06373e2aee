//! The pore pressure at the contact points. Contact impulses are those of soil and water together; friction
//! and the limit of separation are those of the grains, to which the pressure of the water adds nothing.

use super::workspace::ContactWorkspace;
use crate::cpu::seepage::SeepageWorkspace;
use crate::fields::PORE_PRESSURE_AHEAD;
use crate::halo::{self, Halo};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Contact, State};

/// Finds the cell whose pore pressure acts at each contact point: its own, or the next one along the normal
/// where its own has none. Where a cut lies between the two, both blocks must know.
pub(crate) fn find_pressure_cells<R: Scalar>(
    model: &Model,
    state: &State<R>,
    seepage: &SeepageWorkspace,
    workspace: &mut ContactWorkspace,
) {
    let cell_of = |c: &Contact| cell_of(model, seepage, c);
    workspace.pressure_cells.clear();
    workspace.pressure_cells.extend(state.contacts.iter().map(cell_of));
}

fn cell_of(model: &Model, seepage: &SeepageWorkspace, c: &Contact) -> Option<usize> {
    let grid = &model.grid;
    let whole = c.cell.map(|layer| layer as usize);
    let [i, j, k] = grid.in_block(whole).filter(|[_, j, k]| grid.is_beside_own([j + 1, k + 1]))?;
    let own = grid.index(i, j, k);
    let axis = grid.main_axis(c.normal);
    let next = if c.normal[axis] > 0.0 { own + grid.stride[axis] } else { own - grid.stride[axis] };
    [own, next].into_iter().find(|cell| seepage.is_saturated(*cell))
}

/// Reads the pore pressures that act at the contact points in this step [Pa]; none where no pore pressure is
/// computed.
pub(super) fn read_pressures<R: Scalar>(
    model: &Model,
    state: &State<R>,
    workspace: &mut ContactWorkspace,
    halo: &Halo,
) {
    let ContactWorkspace { pressure_cells, pore_pressures, .. } = workspace;
    pore_pressures.clear();
    if model.pore_water.is_none() {
        return;
    }
    let field = &state.soil.history[PORE_PRESSURE_AHEAD];
    let own = pressure_cells.iter().map(|cell| cell.map_or(0.0, |cell| field[cell].to_f64()));
    if halo.is_alone() {
        pore_pressures.extend(own);
        return;
    }
    pore_pressures.resize(state.contacts.len(), 0.0);
    let is_owned = |n: usize| model.grid.owns(state.contacts[n].cell.map(|layer| layer as usize));
    let known = pressure_cells.iter().zip(own).enumerate();
    let known =
        known.filter_map(|(n, (cell, pressure))| cell.filter(|_| is_owned(n)).map(|_| (n, [pressure])));
    for (n, [pressure]) in halo::in_order(halo, known) {
        pore_pressures[n] = pressure;
    }
}
