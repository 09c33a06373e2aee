//! The time step, on one page.

use crate::balance::account;
use crate::bodies;
use crate::check::check;
use crate::contact;
use crate::cpu::fields_on_device::DeviceStage;
use crate::cpu::stage_sums::RowSums;
use crate::cpu::workspace::SoilWorkspace;
use crate::device::Touched;
use crate::error::Breakdown;
use crate::halo::filling::{At, Layers, begin_filling, end_filling};
use crate::kernels::Kernels;
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
    R::step(model, state, workspace)
}

/// [`step`], to be compiled for one precision.
pub(crate) fn stages<R: Kernels>(
    model: &Model,
    state: &mut State<R>,
    workspace: &mut Workspace<R>,
) -> Result<(), Breakdown> {
    let dt = model.time_step();
    // Lagrangian stage: the soil deforms, the grid stays. Messages between blocks are under way while there
    // is something to compute: contact nodes during the rest of the stage, the nodes beside cuts and the sums
    // during contact.
    let Workspace { soil, contact, seepage, mechanism, bodies: moving, beyond, halo } = &mut *workspace;
    beyond.rest(&mut state.soil);
    let pressed = contact::press(model, state, &contact.confined);
    let mut known = |nodes: &_, before: &_| contact.begin_gather(nodes, before, halo);
    let touched = || {
        let (nodes, confined) = contact.entries();
        Touched::of(nodes, confined.chain(beyond.cells()))
    };
    R::lagrangian_stage(model, state, soil, dt, &mut known, &touched);
    let beside_cuts = Layers { at: At::Nodes, depth: 1 };
    begin_filling(halo, &model.grid, beside_cuts, state.nodes.velocity.iter());
    let add_up = |state: &mut State<R>, soil: &mut SoilWorkspace<R>| {
        let mut sums = soil.end_stage(model, state);
        sums.add_pressing(contact::pressing_work(model, &state.soil, &pressed));
        sums.add_beyond(beyond.taken_up(model, &state.soil));
        sums.begin_total(halo);
        sums
    };
    let sums = soil.device.is_none().then(|| add_up(state, soil));
    bodies::predict(model, mechanism, state, moving);
    contact::solve(model, state, soil, halo, contact, moving);
    // First: contact nodes in ghost layers then get their velocities after contact, which are known here,
    // too.
    end_filling(halo, &model.grid, beside_cuts, state.nodes.velocity.iter_mut());
    let work = contact::apply(model, state, soil, contact, moving);
    if let Some(device) = &mut soil.device {
        device.give_velocities(model, state);
    }
    bodies::advance(mechanism, state, moving);
    // A device has been at work on rows far from the bodies meanwhile.
    let sums = sums.unwrap_or_else(|| add_up(state, soil)).total(halo);
    pore_pressure::renew(model, state, soil, seepage, (contact, &pressed), halo)?;
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
    workspace.device_works(state)?;
    check(model, state, &sums, &workspace.halo).or_else(|_| {
        // The place of the fault is found in the fields.
        workspace.bring_home(state, false);
        check(model, state, &sums, &workspace.halo)
    })
}

/// Whether soil or a body has moved so far since the last remap that another is due.
fn is_remap_due<R: Kernels>(model: &Model, state: &State<R>, sums: &RowSums) -> bool {
    let cell = model.grid.finest();
    sums.displacement > model.method.remap_displacement * cell
        || sums.displacement_light > 0.4 * cell
        || bodies::have_moved(model, state)
}
