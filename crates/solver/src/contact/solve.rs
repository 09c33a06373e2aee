//! Contact in one step: the contact law changes the velocities of nodes and bodies.

use super::scene::{Scene, TouchedNode, velocity_at};
use super::workspace::ContactWorkspace;
use crate::bodies::BodyStep;
use crate::cpu::stopwatch::Stage;
use crate::cpu::workspace::SoilWorkspace;
use crate::model::Model;
use crate::real::Real;
use crate::state::{Nodes, Received, State};
use glam::DVec3;

/// What contact did in one step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ContactWork {
    /// Work done on the soil [J].
    pub(crate) on_soil: f64,
    /// Dissipation by friction [J].
    pub(crate) rubbed: f64,
}

/// Lets soil and bodies act on each other for one step. Returns the work that was done; what each body received is entered
/// into its step record.
pub(crate) fn solve<R: Real>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    workspace: &mut ContactWorkspace,
    steps: &mut [BodyStep],
    dt: f64,
) -> ContactWork {
    if state.bodies.is_empty() {
        return ContactWork::default();
    }
    for (step, body) in steps.iter_mut().zip(&state.bodies) {
        step.received = body.received;
    }
    let ContactWorkspace { law, nodes, corner_nodes, patch, friction, .. } = workspace;
    gather(model, &state.nodes, &soil.velocity_before, nodes);
    friction.clear();
    friction.resize(state.contacts.len(), DVec3::ZERO);
    law.act(&mut Scene {
        model,
        contacts: &mut state.contacts,
        bodies: &mut state.bodies,
        nodes,
        corner_nodes,
        patch: &patch.0,
        missing: &patch.1,
        friction,
        dt,
    });
    let on_soil = scatter(&mut state.nodes, nodes);
    let rubbed = rubbed(state, nodes, corner_nodes, friction, steps);
    for (step, body) in steps.iter_mut().zip(&state.bodies) {
        let (now, then) = (body.received, step.received);
        step.received = Received {
            normal: (now.normal - then.normal) * model.share(),
            friction: (now.friction - then.friction) * model.share(),
            axle: (now.axle - then.axle) * model.share(),
        };
    }
    soil.stopwatch().lap(Stage::Contact);
    ContactWork { on_soil, rubbed }
}

/// Takes velocities and masses of the contact nodes from the grid.
fn gather<R: Real>(model: &Model, grid: &Nodes<R>, before: &[Vec<R>; 3], nodes: &mut [TouchedNode]) {
    let mass_moved = model.mass_moved();
    for node in nodes {
        node.mass = grid.mass[node.node].to_f64();
        node.velocity = velocity_of(&grid.velocity, node.node);
        node.free = node.velocity;
        node.before = velocity_of(before, node.node);
        node.inverse_mass = if node.mass > mass_moved { node.free_of_walls / node.mass } else { DVec3::ZERO };
    }
}

fn velocity_of<R: Real>(velocity: &[Vec<R>; 3], node: usize) -> DVec3 {
    DVec3::from_array(velocity.each_ref().map(|component| component[node].to_f64()))
}

/// Returns the velocities to the grid, and the work on the soil: impulse on each node times the mean of its velocities
/// before and after the step [J].
fn scatter<R: Real>(grid: &mut Nodes<R>, nodes: &[TouchedNode]) -> f64 {
    let mut work = 0.0;
    for node in nodes {
        for (v, new) in grid.velocity.iter_mut().zip(node.velocity.to_array()) {
            v[node.node] = R::cast(new);
        }
        work += node.mass * (node.velocity - node.free).dot(0.5 * (node.velocity + node.before));
    }
    work
}

/// Dissipation by friction [J]: frictional impulses times the slip, which is taken as the mean of those before and after
/// the step, like every other work.
fn rubbed<R>(
    state: &State<R>,
    nodes: &[TouchedNode],
    corner_nodes: &[[u32; 8]],
    friction: &[DVec3],
    steps: &[BodyStep],
) -> f64 {
    let mut sum = 0.0;
    for ((c, corners), impulse) in state.contacts.iter().zip(corner_nodes).zip(friction) {
        if *impulse != DVec3::ZERO {
            let body = &state.bodies[c.body];
            let step = &steps[c.body];
            let before = step.velocity_before + (DVec3::Y * step.spin_before).cross(c.arm);
            let of_body = 0.5 * (velocity_at(body, c.arm) + before);
            let each = corners.iter().zip(c.weight);
            let of_soil = each.fold(DVec3::ZERO, |v, (n, w)| {
                let node = &nodes[*n as usize];
                v + 0.5 * w * (node.velocity + node.before)
            });
            sum += impulse.dot(of_body - of_soil);
        }
    }
    sum
}
