//! The energy balance of soil and bodies.

use crate::contact::ContactWork;
use crate::cpu::stage_sums::RowSums;
use crate::energy;
use crate::halo::Halo;
use crate::kernels::Kernels;
use crate::model::Model;
use crate::state::State;
use mechanics::Step;

/// What the energy balance of a block starts from: volume and elastic energy of the soil in all blocks.
pub(crate) fn begin_in_blocks<R: Kernels>(model: &Model, state: &mut State<R>, halo: &Halo) {
    state.energy_balance.elastic_start = energy::elastic(model, &state.soil, halo);
    state.energy_balance.volume_start = energy::soil_volume(&model.grid, &state.soil, halo);
}

/// Adds a step to the energy balance.
pub(crate) fn account<R: Kernels>(
    model: &Model,
    state: &mut State<R>,
    sums: &RowSums,
    bodies: &Step,
    work: &ContactWork,
) {
    let modelled = model.modelled_fraction();
    let balance = &mut state.energy_balance;
    balance.plastic += sums.plastic;
    balance.viscous += sums.viscous;
    balance.hourglass += sums.hourglass;
    balance.seepage += sums.seepage;
    balance.external += sums.gravity - sums.beyond;
    balance.friction += work.friction_work;
    balance.seepage += work.water_work;
    balance.contact -= work.on_soil + work.friction_work + work.water_work + sums.pressing;
    for n in 0..state.bodies.len() {
        let done = bodies.work(n);
        balance.external += modelled * (done.load + done.gravity + done.touch + done.joint + done.drive);
        balance.contact -= modelled * done.contact;
    }
}

/// Kinetic energy of soil and bodies [J], of the modelled portion.
pub fn kinetic_energy<R: Kernels>(model: &Model, state: &State<R>, halo: &Halo) -> f64 {
    let bodies = model.modelled_fraction() * model.mechanism().kinetic_energy(&state.mechanism);
    energy::kinetic(model, state, halo) + bodies
}

/// Elastic energy of the soil [J], of the modelled portion.
pub fn elastic_energy<R: Kernels>(model: &Model, state: &State<R>, halo: &Halo) -> f64 {
    energy::elastic(model, &state.soil, halo)
}
