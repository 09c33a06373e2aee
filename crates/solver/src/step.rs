//! The time step, on one page.

use crate::balance::account;
use crate::bodies;
use crate::check::check;
use crate::contact;
use crate::cpu::workspace::RowSums;
use crate::error::Breakdown;
use crate::halo::{self, At};
use crate::model::Model;
use crate::pore_pressure;
use crate::precision::Precision;
use crate::remap::remap;
use crate::state::State;
use crate::workspace::Workspace;

/// Takes one step.
///
/// # Errors
/// [`Breakdown`] when the state has become unphysical; the state is then the one after the failed step.
pub fn step<R: Precision>(
    model: &Model,
    state: &mut State<R>,
    workspace: &mut Workspace<R>,
) -> Result<(), Breakdown> {
    let dt = model.time_step();
    // Lagrangian stage: the soil deforms, the grid stays.
    R::lagrangian_stage(model, state, &mut workspace.soil, dt);
    let Workspace { soil, contact, seepage, mechanism, bodies: moving, halo } = workspace;
    let sums = soil.total_of_stage(halo);
    bodies::predict(model, mechanism, state, moving);
    let work = contact::solve(model, state, (soil, halo), contact, moving);
    bodies::advance(mechanism, state, moving);
    halo::fill_first(halo, &model.grid, At::Nodes, &mut state.nodes.velocity);
    pore_pressure::renew(model, state, soil, seepage, (contact, halo))?;
    account(model, state, &sums, moving, &work);
    state.time += dt;
    state.step += 1;
    // Eulerian stage, only when the soil has moved far enough to need it.
    if is_remap_due(model, state, &sums) {
        remap(model, state, workspace);
        let Workspace { soil, contact, seepage, halo, .. } = workspace;
        contact::search(model, state, soil, contact, halo);
        pore_pressure::find_paths(model, state, seepage, contact);
    }
    check(model, state, &sums, &workspace.halo)
}

/// Whether soil or a body has moved so far since the last remap that another is due.
fn is_remap_due<R: Precision>(model: &Model, state: &State<R>, sums: &RowSums) -> bool {
    let cell = model.grid.finest();
    sums.displacement > model.method.remap_displacement * cell
        || sums.displacement_light > 0.4 * cell
        || bodies::have_moved(model, state)
}
