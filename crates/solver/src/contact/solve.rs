//! Contact in one step: the contact law changes the velocities of nodes and bodies.

use super::pore_pressure::read_pressures;
use super::problem::{ContactNode, ContactProblem};
use super::slip::account_slip;
use super::workspace::ContactWorkspace;
use crate::cpu::stopwatch::Stage;
use crate::cpu::workspace::SoilWorkspace;
use crate::halo::Halo;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Nodes, State};
use glam::DVec3;
use mechanics::Step;

/// Work of contact in one step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ContactWork {
    /// Work done on the soil [J].
    pub(crate) on_soil: f64,
    /// Frictional dissipation [J].
    pub(crate) friction_work: f64,
    /// Work done on the water that fills gaps between soil and bodies [J].
    pub(crate) water_work: f64,
}

/// Solves contact between soil and bodies for one step. The contact impulse on each body is added to its
/// total; the grid still has the velocities without contact.
pub(crate) fn solve<R: Scalar>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    halo: &Halo,
    workspace: &mut ContactWorkspace,
    moving: &mut Step,
) {
    if state.bodies.is_empty() {
        return;
    }
    read_pressures(model, state, workspace, halo);
    let ContactWorkspace {
        law,
        nodes,
        owners,
        velocity,
        inverse_mass,
        corner_nodes,
        constraint_points,
        islands,
        hourglass_correction,
        impulses,
        pore_pressures,
        openings,
        ..
    } = workspace;
    owners.end(nodes, (&state.nodes, &soil.velocity_before), halo);
    velocity.clear();
    velocity.extend(nodes.iter().map(|node| node.velocity_free));
    find_inverse_masses(model, nodes, inverse_mass);
    impulses.clear();
    impulses.resize(state.contacts.len(), [DVec3::ZERO; 2]);
    let mut problem = ContactProblem {
        model,
        contacts: &mut state.contacts,
        moving,
        bodies: &mut state.bodies,
        velocity,
        inverse_mass,
        corner_nodes,
        constraint_points,
        islands,
        hourglass_correction,
        impulses,
        pore_pressures,
        modelled_fraction: model.modelled_fraction(),
        dt: model.time_step(),
        crew: soil.crew(),
    };
    problem.press_water();
    law.act(&mut problem);
    problem.add_reactions();
    problem.record_water();
    openings.clear();
    openings.extend((0..pore_pressures.len()).map(|n| problem.opening(n)));
}

/// Gives the grid the velocities that contact has found, and adds up the work of the step.
pub(crate) fn apply<R: Scalar>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    workspace: &mut ContactWorkspace,
    moving: &Step,
) -> ContactWork {
    if state.bodies.is_empty() {
        return ContactWork::default();
    }
    let ContactWorkspace { nodes, velocity, pore_pressures, openings, .. } = &*workspace;
    let lost = pore_pressures.iter().zip(openings).map(|(pressure, opening)| pressure * opening);
    let water_work = -lost.sum::<f64>() * model.time_step();
    let on_soil = scatter(&mut state.nodes, nodes, velocity);
    let friction_work = account_slip(model, state, workspace, moving, soil.crew());
    soil.stopwatch().lap(Stage::Contact);
    ContactWork { on_soil, friction_work, water_work }
}

/// Inverse masses of the contact nodes.
fn find_inverse_masses(model: &Model, nodes: &[ContactNode], inverse_mass: &mut Vec<DVec3>) {
    let mass_moved = model.mass_moved();
    inverse_mass.clear();
    inverse_mass.extend(nodes.iter().map(|node| {
        let free = DVec3::from_array(node.is_free.map(|is_free| if is_free { 1.0 } else { 0.0 }));
        if node.mass > mass_moved { free / node.mass } else { DVec3::ZERO }
    }));
}

/// Writes the velocities back to the grid. Returns the work on the soil [J]: impulse on each node times the
/// mean of its velocities before and after the step.
fn scatter<R: Scalar>(grid: &mut Nodes<R>, nodes: &[ContactNode], velocity: &[DVec3]) -> f64 {
    let mut work = 0.0;
    for (node, velocity) in nodes.iter().zip(velocity) {
        if let Some(n) = node.node {
            for (v, new) in grid.velocity.iter_mut().zip(velocity.to_array()) {
                v[n] = R::cast(new);
            }
        }
        work += node.mass * (velocity - node.velocity_free).dot(0.5 * (velocity + node.velocity_before));
    }
    work
}
