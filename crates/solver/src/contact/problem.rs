//! The contact problem of one step: contact points, contact nodes, bodies, and the Jacobians that connect
//! them.

use super::constraint_points::ConstraintPoints;
use super::islands::Islands;
use crate::cpu::threads::Crew;
use crate::model::Model;
use crate::state::{Body, Contact};
use glam::DVec3;
use mechanics::Step;
use std::ops::Range;

/// The contact problem of one step. The contact law starts from velocities without contact and updates them;
/// those of the nodes are then written back to the grid.
pub(crate) struct ContactProblem<'a> {
    pub(crate) model: &'a Model,
    pub(crate) contacts: &'a mut [Contact],
    /// The bodies during the step.
    pub(crate) moving: &'a mut Step,
    /// The bodies, with the contact impulses on them so far.
    pub(crate) bodies: &'a mut [Body],
    /// Velocities of the contact nodes [m/s].
    pub(crate) velocity: &'a mut [DVec3],
    /// Inverse masses of the nodes along x, y, z [1/kg]; 0 where a node has no mass or a boundary holds it.
    pub(crate) inverse_mass: &'a [DVec3],
    /// For each contact point the indices of its cell's nodes among the contact nodes.
    pub(crate) corner_nodes: &'a [[u32; 8]],
    /// The contact points of each constraint.
    pub(crate) constraint_points: &'a ConstraintPoints,
    /// Bodies that share contact nodes.
    pub(crate) islands: &'a Islands,
    /// For each constraint the cut-cell hourglass correction: forces at its cell's nodes per unit normal
    /// force.
    pub(crate) hourglass_correction: &'a [[DVec3; 8]],
    /// Normal and frictional impulse on the soil at each contact point in this step [N s].
    pub(crate) impulses: &'a mut [[DVec3; 2]],
    /// Pore pressure at each contact point [Pa]; empty where none is computed.
    pub(crate) pore_pressures: &'a [f64],
    /// Fraction of each body that is modelled.
    pub(crate) modelled_fraction: f64,
    /// Time step [s].
    pub(crate) dt: f64,
    /// The threads at work.
    pub(crate) crew: Crew<'a>,
}

/// Contact points that a thread takes at least: fewer are not worth its waking.
pub(crate) const POINTS_AT_ONCE: usize = 128;

/// A contact node: a node of a cell that holds a contact point.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ContactNode {
    /// Index in memory, if it is in this block.
    pub(crate) node: Option<usize>,
    /// Whether this block owns the node.
    pub(crate) is_owned: bool,
    /// Velocity components that no boundary holds.
    pub(crate) is_free: [bool; 3],
    /// Mass [kg].
    pub(crate) mass: f64,
    /// Velocity without contact [m/s].
    pub(crate) velocity_free: DVec3,
    /// Velocity at the start of the step [m/s].
    pub(crate) velocity_before: DVec3,
}

/// Offsets of a cell's eight nodes, in the order of the weights.
pub(crate) fn corners([x, y, z]: [usize; 3]) -> [usize; 8] {
    [0, x, y, x + y, z, x + z, y + z, x + y + z]
}

/// Sum over a cell's corners, in an order for which mirroring in y changes no bit.
#[inline(always)]
pub(crate) fn over_corners<T: Copy + std::ops::Add<Output = T>>(v: [T; 8]) -> T {
    ((v[0] + v[2]) + (v[1] + v[3])) + ((v[4] + v[6]) + (v[5] + v[7]))
}

/// Side of the body's mid-plane y = 0 on which a point lies: 0 and 1, or 2 on the plane.
pub(crate) fn side(c: &Contact) -> usize {
    c.side.into()
}

/// Contact Jacobian: maps the velocities of a body and of a cell's nodes to their relative velocity at a
/// contact point or constraint; its transpose distributes an impulse.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ContactJacobian {
    /// Index of the body.
    pub(crate) body: usize,
    /// Lever arm from the body's reference point [m].
    pub(crate) arm: DVec3,
    /// Indices of the cell's nodes among the contact nodes.
    pub(crate) nodes: [u32; 8],
    /// Weights of the nodes.
    pub(crate) weight: [f64; 8],
    /// Outward unit normal of a constraint; zero for a point.
    pub(crate) normal: DVec3,
    /// Cut-cell hourglass correction at the nodes per unit normal force.
    pub(crate) hourglass_correction: [DVec3; 8],
}

impl ContactJacobian {
    /// The portion of an impulse that acts on a node [N s].
    pub(crate) fn on_node(&self, n: usize, impulse: DVec3) -> DVec3 {
        self.weight[n] * impulse + impulse.dot(self.normal) * self.hourglass_correction[n]
    }
}

impl ContactProblem<'_> {
    /// Jacobian of a contact point.
    pub(crate) fn jacobian(&self, contact: usize) -> ContactJacobian {
        let Contact { body, arm, weight, .. } = self.contacts[contact];
        ContactJacobian {
            body: body as usize,
            arm,
            nodes: self.corner_nodes[contact],
            weight,
            ..ContactJacobian::default()
        }
    }

    /// Relative velocity at a contact point [m/s].
    pub(crate) fn slip_velocity_of(&self, contact: usize) -> DVec3 {
        slip_velocity(&self.contacts[contact], self.velocity, &self.corner_nodes[contact], self.moving)
    }

    /// Applies an impulse [N s] to the soil and its reaction to the free motions of the body.
    pub(crate) fn exchange(&mut self, jacobian: &ContactJacobian, impulse: DVec3) {
        for (n, index) in jacobian.nodes.iter().enumerate() {
            let node = *index as usize;
            self.velocity[node] += self.inverse_mass[node] * jacobian.on_node(n, impulse);
        }
        self.moving.apply(jacobian.body, jacobian.arm, -impulse);
    }

    /// Exerts the pore pressures on soil and bodies at the contact points. What the contact law adds is
    /// between the grains and the body.
    pub(crate) fn press_water(&mut self) {
        for n in 0..self.pore_pressures.len() {
            let impulse = self.water_impulse(n);
            if impulse != DVec3::ZERO {
                self.exchange(&self.jacobian(n), impulse);
            }
        }
    }

    /// Records what the pore pressures have exerted, as part of the normal impulses.
    pub(crate) fn record_water(&mut self) {
        for n in 0..self.pore_pressures.len() {
            let water = self.water_impulse(n);
            if water != DVec3::ZERO {
                let c = &self.contacts[n];
                let total = &mut self.bodies[c.body as usize].contact_impulse;
                total.add(&[water, DVec3::ZERO], water, c.arm, self.modelled_fraction);
                self.impulses[n][0] += water;
            }
        }
    }

    /// Impulse of the pore water on the soil at a contact point in this step [N s].
    fn water_impulse(&self, contact: usize) -> DVec3 {
        let c = &self.contacts[contact];
        self.pore_pressures[contact] * c.area * self.dt * c.normal
    }

    /// Rate at which a gap between soil and body grows at a contact point, times its area [m³/s]: water must
    /// fill it. What removes an overlap opens no gap.
    pub(crate) fn opening(&self, contact: usize) -> f64 {
        let c = &self.contacts[contact];
        if c.penetration < 0.0 { -self.slip_velocity_of(contact).dot(c.normal) * c.area } else { 0.0 }
    }

    /// Adds the reactions to the impulses on the soil at the contact points to the contact impulses of the
    /// bodies.
    pub(crate) fn add_reactions(&mut self) {
        let Self { contacts, impulses, bodies, modelled_fraction, crew, .. } = self;
        let (contacts, impulses, modelled_fraction) = (&**contacts, &**impulses, *modelled_fraction);
        crew.portions(bodies, 1, |first, bodies| {
            for (n, body) in bodies.iter_mut().enumerate() {
                let own = of_body(contacts, first + n);
                let each = contacts[own.clone()].iter().zip(&impulses[own]);
                for (c, impulses) in each.filter(|(_, impulses)| **impulses != [DVec3::ZERO; 2]) {
                    body.contact_impulse.add(impulses, DVec3::ZERO, c.arm, modelled_fraction);
                }
            }
        });
    }
}

/// Velocity of a body at a contact point minus that of the soil there, from the nodes of its cell [m/s].
pub(crate) fn slip_velocity(c: &Contact, velocity: &[DVec3], corners: &[u32; 8], moving: &Step) -> DVec3 {
    let soil = |n: usize| c.weight[n] * velocity[corners[n] as usize];
    moving.velocity_at(c.body as usize, c.arm) - over_corners(std::array::from_fn(soil))
}

/// The contact points of a body.
pub(crate) fn of_body(contacts: &[Contact], body: usize) -> Range<usize> {
    let first = |body: usize| contacts.partition_point(|c| (c.body as usize) < body);
    first(body)..first(body + 1)
}
