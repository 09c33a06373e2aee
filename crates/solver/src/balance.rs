//! The energy balance: where the work went.

use crate::bodies::BodyStep;
use crate::contact::ContactWork;
use crate::cpu::workspace::RowSums;
use crate::energy;
use crate::model::Model;
use crate::precision::Precision;
use crate::state::State;

/// Enters the step into the ledger.
pub(crate) fn account<R: Precision>(
    model: &Model,
    state: &mut State<R>,
    sums: &RowSums,
    steps: &[BodyStep],
    work: &ContactWork,
) {
    let ledger = &mut state.ledger;
    ledger.plastic += sums.plastic;
    ledger.viscous += sums.viscous;
    ledger.hourglass += sums.hourglass;
    ledger.external += sums.gravity;
    ledger.friction += work.friction_work;
    ledger.contact -= work.on_soil + work.friction_work;
    for ((fixed, body), step) in model.bodies.iter().zip(&state.bodies).zip(steps) {
        let (share, received) = (model.share(), &step.received);
        let force = received.normal + received.friction;
        for axis in 0..3 {
            let (before, after) = (step.velocity_before[axis], body.velocity[axis]);
            let middle = 0.5 * (before + after);
            // What the load gave is what is left of the change of momentum when contact is taken off.
            let load = if fixed.translation[axis].is_free() {
                fixed.mass * share * (step.velocity_free[axis] - before)
            } else {
                -force[axis]
            };
            ledger.external += load * middle;
            ledger.contact -= force[axis] * middle;
        }
        let middle = 0.5 * (step.spin_before + body.spin);
        let load = if fixed.spin.is_free() {
            fixed.axle_inertia * share * (step.spin_free - step.spin_before)
        } else {
            -received.axle
        };
        ledger.external += load * middle;
        ledger.contact -= received.axle * middle;
    }
}

/// Kinetic energy of soil and bodies now [J] (modelled share).
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
            0.5 * model.share() * (fixed.mass * (free(0) + free(1) + free(2)) + spin)
        })
        .sum();
    energy::kinetic(model, state) + bodies
}

/// Elastic energy of the soil now [J].
#[must_use]
pub fn elastic_energy<R: Precision>(model: &Model, state: &State<R>) -> f64 {
    energy::elastic(model, &state.soil)
}
