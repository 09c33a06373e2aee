//! The time step, on one page.

use crate::cpu::contact::{self, ContactWork};
use crate::cpu::lagrange::lagrange;
use crate::cpu::remap::remap;
use crate::cpu::workspace::{RowSums, Workspace};
use crate::error::Breakdown;
use crate::model::Model;
use crate::state::State;
use glam::DVec3;

/// Takes one step.
///
/// # Errors
/// [`Breakdown`] when the state has become unphysical; the state is then the one after the failed step.
pub fn step(model: &Model, state: &mut State, workspace: &mut Workspace) -> Result<(), Breakdown> {
    let dt = model.time_step();
    if state.step == 0 {
        contact::locate(model, state, workspace);
    }
    // Lagrangian stage: the soil moves, the grid waits.
    let sums = lagrange(model, state, workspace, dt);
    let drive = drive_bodies(model, state, dt);
    let work = contact::contact(model, state, workspace, &drive, dt);
    move_bodies(state, dt);
    account(model, state, &sums, &drive, &work);
    state.time += dt;
    state.step += 1;
    // Eulerian stage, only when the soil has moved far enough to need it.
    if displaced_too_far(model, &sums) || bodies_moved(model, state) {
        let loss = remap(model, state, workspace);
        state.ledger.remap += loss.energy;
        state.ledger.crumbs_volume += loss.volume;
        state.ledger.crumbs_mass += loss.mass;
        contact::locate(model, state, workspace);
    }
    check(model, state, &sums, dt)
}

/// Velocities of the bodies without contact: as prescribed, or as the loads make them. Returns velocity and spin before.
fn drive_bodies(model: &Model, state: &mut State, dt: f64) -> Vec<(DVec3, f64)> {
    let middle = state.time + 0.5 * dt;
    let each = model.bodies.iter().zip(&mut state.bodies).map(|(fixed, body)| {
        let before = (body.velocity, body.spin);
        for axis in 0..3 {
            let freedom = fixed.translation[axis];
            body.velocity[axis] = if freedom.is_free() {
                body.velocity[axis] + freedom.load(middle) * dt / fixed.mass
            } else {
                freedom.speed(middle)
            };
        }
        let turn = fixed.spin;
        body.spin = if turn.is_free() {
            body.spin + turn.load(middle) * dt / fixed.axle_inertia
        } else {
            turn.speed(middle)
        };
        before
    });
    each.collect()
}

/// Moves the bodies with their new velocities.
fn move_bodies(state: &mut State, dt: f64) {
    for body in &mut state.bodies {
        body.position += body.velocity * dt;
        body.angle += body.spin * dt;
    }
}

/// Whether soil has moved so far on the frozen grid that it must be remapped.
fn displaced_too_far(model: &Model, sums: &RowSums) -> bool {
    let cell = model.grid.finest();
    sums.displacement > model.method.remap_displacement * cell || sums.displacement_light > 0.4 * cell
}

/// Whether a body has moved so far since its contact points were located that they must be found anew.
fn bodies_moved(model: &Model, state: &State) -> bool {
    let limit = model.method.remap_displacement * model.grid.finest();
    model.bodies.iter().zip(&state.bodies).any(|(fixed, body)| {
        let (position, angle) = body.located;
        // How far the farthest point of the surface has turned, unless turning makes no difference.
        let reach = if fixed.shape.is_revolved() { 0.0 } else { fixed.shape.bounds().1.length() };
        (body.position - position).abs().max_element() > limit || (body.angle - angle).abs() * reach > limit
    })
}

/// Enters the step into the ledger.
fn account(model: &Model, state: &mut State, sums: &RowSums, drive: &[(DVec3, f64)], work: &ContactWork) {
    let ledger = &mut state.ledger;
    ledger.plastic += sums.plastic;
    ledger.viscous += sums.viscous;
    ledger.hourglass += sums.hourglass;
    ledger.external += sums.gravity;
    ledger.friction += work.rubbed;
    ledger.contact -= work.on_soil + work.rubbed;
    for (((fixed, body), drive), received) in
        model.bodies.iter().zip(&state.bodies).zip(drive).zip(&work.on_bodies)
    {
        let share = model.share;
        for axis in 0..3 {
            let (before, after) = (drive.0[axis], body.velocity[axis]);
            let middle = 0.5 * (before + after);
            // What the load gave is what is left of the change of momentum when contact is taken off.
            let load = if fixed.translation[axis].is_free() {
                fixed.mass * share * (received.velocity_free[axis] - before)
            } else {
                -received.force[axis]
            };
            ledger.external += load * middle;
            ledger.contact -= received.force[axis] * middle;
        }
        let middle = 0.5 * (drive.1 + body.spin);
        let load = if fixed.spin.is_free() {
            fixed.axle_inertia * share * (received.spin_free - drive.1)
        } else {
            -received.axle
        };
        ledger.external += load * middle;
        ledger.contact -= received.axle * middle;
    }
}

/// Fields must be numbers, and nothing may cross most of a cell before it is remapped.
fn check(model: &Model, state: &State, sums: &RowSums, dt: f64) -> Result<(), Breakdown> {
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
    let bad = |n: usize| state.nodes.velocity.iter().any(|v| is_bad(v[n]));
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
    crate::cpu::energy::kinetic(&state.nodes) + bodies
}

/// Elastic energy of the soil now [J].
#[must_use]
pub fn elastic_energy(model: &Model, state: &State) -> f64 {
    crate::cpu::energy::elastic(model, &state.soil)
}
