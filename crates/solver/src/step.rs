//! The time step, on one page.

use super::State;
use super::audit::{account, check};
use super::contact;
use super::lagrange::lagrange;
use super::remap::remap;
use super::workspace::{RowSums, Workspace};
use crate::cpu::stopwatch::Stage;
use crate::error::Breakdown;
use crate::model::Model;

/// Takes one step.
///
/// # Errors
/// [`Breakdown`] when the state has become unphysical; the state is then the one after the failed step.
pub fn step(model: &Model, state: &mut State, workspace: &mut Workspace) -> Result<(), Breakdown> {
    let dt = model.time_step();
    if state.step == 0 {
        contact::occupy_all(model, state, workspace);
        contact::locate(model, state, workspace);
    }
    // Lagrangian stage: the soil moves, the grid waits.
    let sums = lagrange(model, state, workspace, dt);
    drive_bodies(model, state, workspace, dt);
    let work = contact::contact(model, state, workspace, dt);
    workspace.stopwatch().lap(Stage::Contact);
    move_bodies(state, dt);
    account(model, state, &sums, &workspace.drives, &work);
    state.time += dt;
    state.step += 1;
    // Eulerian stage, only when the soil has moved far enough to need it.
    if displaced_too_far(model, &sums) || bodies_moved(model, state) {
        let loss = remap(model, state, workspace);
        workspace.stopwatch().lap(Stage::Remap);
        state.ledger.remap += loss.energy;
        state.ledger.crumbs_volume += loss.volume;
        state.ledger.crumbs_mass += loss.mass;
        contact::locate(model, state, workspace);
        workspace.stopwatch().lap(Stage::Contact);
    }
    workspace.stopwatch().lap(Stage::Other);
    check(model, state, &sums, dt)
}

/// Velocities of the bodies without contact: as prescribed, or as the loads make them.
fn drive_bodies(model: &Model, state: &mut State, workspace: &mut Workspace, dt: f64) {
    let middle = state.time + 0.5 * dt;
    for ((fixed, body), drive) in model.bodies.iter().zip(&mut state.bodies).zip(&mut workspace.drives) {
        (drive.velocity_before, drive.spin_before) = (body.velocity, body.spin);
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
    }
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
