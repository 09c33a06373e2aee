//! Contact in one step: the contact law changes the velocities of nodes and bodies.

use super::scene::{ContactNode, Scene, velocity_at};
use super::workspace::ContactWorkspace;
use crate::bodies::BodyStep;
use crate::cpu::stopwatch::Stage;
use crate::cpu::workspace::SoilWorkspace;
use crate::halo::{self, Halo};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Nodes, Received, State};
use glam::DVec3;

/// What contact did in one step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ContactWork {
    /// Work done on the soil [J].
    pub(crate) on_soil: f64,
    /// Dissipation by friction [J].
    pub(crate) friction_work: f64,
}

/// Lets soil and bodies act on each other for one step. Returns the work that was done; what each body received is entered
/// into its step record.
pub(crate) fn solve<R: Scalar>(
    model: &Model,
    state: &mut State<R>,
    (soil, halo): (&mut SoilWorkspace<R>, &mut dyn Halo),
    workspace: &mut ContactWorkspace,
    steps: &mut [BodyStep],
) -> ContactWork {
    if state.bodies.is_empty() {
        return ContactWork::default();
    }
    for (step, body) in steps.iter_mut().zip(&state.bodies) {
        step.received = body.received;
    }
    let ContactWorkspace { law, nodes, corner_nodes, constraint, friction, .. } = workspace;
    gather(&state.nodes, &soil.velocity_before, nodes, halo);
    find_mobility(model, nodes);
    friction.clear();
    friction.resize(state.contacts.len(), DVec3::ZERO);
    law.act(&mut Scene {
        model,
        contacts: &mut state.contacts,
        bodies: &mut state.bodies,
        nodes,
        corner_nodes,
        constraint: &constraint.0,
        hourglass_correction: &constraint.1,
        friction,
        modelled: model.share(),
        dt: model.time_step(),
    });
    let on_soil = scatter(&mut state.nodes, nodes);
    let friction_work = friction_work(state, nodes, corner_nodes, friction, steps);
    let modelled = model.share();
    for (step, body) in steps.iter_mut().zip(&state.bodies) {
        let (now, then) = (body.received, step.received);
        step.received = Received {
            normal: (now.normal - then.normal) * modelled,
            friction: (now.friction - then.friction) * modelled,
            axle: (now.axle - then.axle) * modelled,
        };
    }
    soil.stopwatch().lap(Stage::Contact);
    ContactWork { on_soil, friction_work }
}

/// Takes velocities and masses of the contact nodes from the blocks that own them.
fn gather<R: Scalar>(grid: &Nodes<R>, before: &[Vec<R>; 3], nodes: &mut [ContactNode], halo: &mut dyn Halo) {
    for node in nodes.iter_mut() {
        if let Some(n) = node.node {
            node.mass = grid.mass[n].to_f64();
            (node.velocity, node.before) = (velocity_of(&grid.velocity, n), velocity_of(before, n));
        }
    }
    if !halo.is_alone() {
        let owned = nodes.iter().enumerate().filter(|(_, node)| node.is_owned);
        let values = owned.map(|(n, node)| {
            let ([vx, vy, vz], [bx, by, bz]) = (node.velocity.to_array(), node.before.to_array());
            (n, [node.mass, vx, vy, vz, bx, by, bz])
        });
        for (n, [mass, vx, vy, vz, bx, by, bz]) in halo::in_order(halo, values) {
            nodes[n].mass = mass;
            (nodes[n].velocity, nodes[n].before) = (DVec3::new(vx, vy, vz), DVec3::new(bx, by, bz));
        }
    }
}

/// How the nodes answer an impulse.
fn find_mobility(model: &Model, nodes: &mut [ContactNode]) {
    let mass_moved = model.mass_moved();
    for node in nodes {
        node.free = node.velocity;
        let free = DVec3::from_array(node.is_free.map(|is_free| if is_free { 1.0 } else { 0.0 }));
        node.inverse_mass = if node.mass > mass_moved { free / node.mass } else { DVec3::ZERO };
    }
}

fn velocity_of<R: Scalar>(velocity: &[Vec<R>; 3], node: usize) -> DVec3 {
    DVec3::from_array(velocity.each_ref().map(|component| component[node].to_f64()))
}

/// Returns the velocities to the grid, and the work on the soil: impulse on each node times the mean of its velocities
/// before and after the step [J].
fn scatter<R: Scalar>(grid: &mut Nodes<R>, nodes: &[ContactNode]) -> f64 {
    let mut work = 0.0;
    for node in nodes {
        if let Some(n) = node.node {
            for (v, new) in grid.velocity.iter_mut().zip(node.velocity.to_array()) {
                v[n] = R::cast(new);
            }
        }
        work += node.mass * (node.velocity - node.free).dot(0.5 * (node.velocity + node.before));
    }
    work
}

/// Dissipation by friction [J]: frictional impulses times the slip, which is taken as the mean of those before and after
/// the step, like every other work.
fn friction_work<R>(
    state: &State<R>,
    nodes: &[ContactNode],
    corner_nodes: &[[u32; 8]],
    friction: &[DVec3],
    steps: &[BodyStep],
) -> f64 {
    let mut sum = 0.0;
    for ((c, corners), impulse) in state.contacts.iter().zip(corner_nodes).zip(friction) {
        if *impulse != DVec3::ZERO {
            let body = &state.bodies[c.body as usize];
            let step = &steps[c.body as usize];
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
