//! The energy balance of soil and bodies.

use crate::bodies::BodyStep;
use crate::contact::ContactWork;
use crate::cpu::workspace::RowSums;
use crate::energy;
use crate::model::Model;
use crate::precision::Precision;
use crate::state::State;

/// Adds a step to the energy balance.
pub(crate) fn account<R: Precision>(
    model: &Model,
    state: &mut State<R>,
    sums: &RowSums,
    steps: &[BodyStep],
    work: &ContactWork,
) {
    let modelled = model.modelled_fraction();
    let balance = &mut state.energy_balance;
    balance.plastic += sums.plastic;
    balance.viscous += sums.viscous;
    balance.hourglass += sums.hourglass;
    balance.external += sums.gravity;
    balance.friction += work.friction_work;
    balance.contact -= work.on_soil + work.friction_work;
    for ((fixed, body), step) in model.bodies.iter().zip(&state.bodies).zip(steps) {
        let impulse = step.contact_impulse.normal + step.contact_impulse.friction;
        for axis in 0..3 {
            let (before, after) = (step.velocity_before[axis], body.velocity[axis]);
            let mean = 0.5 * (before + after);
            // Impulse of the load: the change of momentum without contact; of a drive, the reaction to the
            // contact impulse.
            let load = if fixed.translation[axis].is_free() {
                fixed.mass * modelled * (step.velocity_free[axis] - before)
            } else {
                -impulse[axis]
            };
            balance.external += load * mean;
            balance.contact -= impulse[axis] * mean;
        }
        let mean = 0.5 * (step.spin_before + body.spin);
        let load = if fixed.spin.is_free() {
            fixed.axle_inertia * modelled * (step.spin_free - step.spin_before)
        } else {
            -step.contact_impulse.axle
        };
        balance.external += load * mean;
        balance.contact -= step.contact_impulse.axle * mean;
    }
}

/// Kinetic energy of soil and bodies [J], of the modelled portion.
#[must_use]
pub fn kinetic_energy<R: Precision>(model: &Model, state: &State<R>) -> f64 {
    let bodies: f64 = model
        .bodies
        .iter()
        .zip(&state.bodies)
        .map(|(fixed, body)| {
            let free = |axis: usize| {
                if fixed.translation[axis].is_free() { body.velocity[axis].powi(2) } else { 0.0 }
            };
            let spin = if fixed.spin.is_free() { fixed.axle_inertia * body.spin.powi(2) } else { 0.0 };
            0.5 * model.modelled_fraction() * (fixed.mass * (free(0) + free(1) + free(2)) + spin)
        })
        .sum();
    energy::kinetic(model, state) + bodies
}

/// Elastic energy of the soil [J], of the modelled portion.
#[must_use]
pub fn elastic_energy<R: Precision>(model: &Model, state: &State<R>) -> f64 {
    energy::elastic(model, &state.soil)
}
