//! The books: where the energy went, and whether the state is still one to believe.

use super::State;
use super::contact::{ContactWork, Drive};
use super::energy;
use super::workspace::RowSums;
use crate::error::Breakdown;
use crate::model::Model;
use glam::DVec3;

/// Enters the step into the ledger.
pub(crate) fn account(
    model: &Model,
    state: &mut State,
    sums: &RowSums,
    drives: &[Drive],
    work: &ContactWork,
) {
    let ledger = &mut state.ledger;
    ledger.plastic += sums.plastic;
    ledger.viscous += sums.viscous;
    ledger.hourglass += sums.hourglass;
    ledger.external += sums.gravity;
    ledger.friction += work.rubbed;
    ledger.contact -= work.on_soil + work.rubbed;
    for ((fixed, body), drive) in model.bodies.iter().zip(&state.bodies).zip(drives) {
        let (share, received) = (model.share, &drive.received);
        let force = received.normal + received.friction;
        for axis in 0..3 {
            let (before, after) = (drive.velocity_before[axis], body.velocity[axis]);
            let middle = 0.5 * (before + after);
            // What the load gave is what is left of the change of momentum when contact is taken off.
            let load = if fixed.translation[axis].is_free() {
                fixed.mass * share * (drive.velocity_free[axis] - before)
            } else {
                -force[axis]
            };
            ledger.external += load * middle;
            ledger.contact -= force[axis] * middle;
        }
        let middle = 0.5 * (drive.spin_before + body.spin);
        let load = if fixed.spin.is_free() {
            fixed.axle_inertia * share * (drive.spin_free - drive.spin_before)
        } else {
            -received.axle
        };
        ledger.external += load * middle;
        ledger.contact -= received.axle * middle;
    }
}

/// Fields must be numbers, and nothing may cross most of a cell before it is remapped.
pub(crate) fn check(model: &Model, state: &State, sums: &RowSums, dt: f64) -> Result<(), Breakdown> {
    let (time, step) = (state.time, state.step);
    let sound = sums.kinetic.is_finite() && sums.plastic.is_finite();
    let bodies_sound =
        state.bodies.iter().all(|b| b.position.is_finite() && b.velocity.is_finite() && b.spin.is_finite());
    if !sound || !bodies_sound {
        let place = place_of(model, state, |v| !v.is_finite());
        return Err(Breakdown::NotANumber { field: "velocity", time, step, place });
    }
    let cells = sums.displacement.max(sums.displacement_light) / model.grid.finest();
    if cells > 0.9 {
        let place = place_of(model, state, |v| v.abs() * dt > 0.3 * model.grid.finest());
        return Err(Breakdown::Runaway { cells, time, step, place });
    }
    Ok(())
}

/// The first node whose velocity has a component like this.
fn place_of(model: &Model, state: &State, is_bad: impl Fn(f64) -> bool) -> DVec3 {
    let bad = |n: usize| state.nodes.velocity.iter().any(|v| is_bad(f64::from(v[n])));
    let [_, row, plane] = model.grid.stride;
    let found = (plane + row + 1..model.grid.entries).find(|n| bad(*n));
    let Some(n) = found else { return DVec3::NAN };
    let place = model.grid.place(n);
    DVec3::from_array(std::array::from_fn(|axis| {
        model.grid.faces[axis].get(place[axis]).copied().unwrap_or(f64::NAN)
    }))
}

/// Kinetic energy of soil and bodies now [J] (modelled share).
#[must_use]
pub fn kinetic_energy(model: &Model, state: &State) -> f64 {
    let bodies: f64 = model
        .bodies
        .iter()
        .zip(&state.bodies)
        .map(|(fixed, body)| {
            let free = |axis: usize| {
                if fixed.translation[axis].is_free() { body.velocity[axis].powi(2) } else { 0.0 }
            };
            let spin = if fixed.spin.is_free() { fixed.axle_inertia * body.spin.powi(2) } else { 0.0 };
            0.5 * model.share * (fixed.mass * (free(0) + free(1) + free(2)) + spin)
        })
        .sum();
    energy::kinetic(&model.grid, &state.nodes) + bodies
}

/// Elastic energy of the soil now [J].
#[must_use]
pub fn elastic_energy(model: &Model, state: &State) -> f64 {
    energy::elastic(model, &state.soil)
}
