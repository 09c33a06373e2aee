//! What a contact law works on during a step: nodes, bodies, and the points where an impulse acts on both.

use crate::model::{BodyModel, Model};
use crate::state::{Body, Contact};
use glam::DVec3;

/// What a contact law works on during a step. The velocities of the nodes are those before contact; what the law makes
/// of them is written back afterwards.
pub(crate) struct Scene<'a> {
    pub(crate) model: &'a Model,
    pub(crate) contacts: &'a mut [Contact],
    pub(crate) bodies: &'a mut [Body],
    /// The nodes that contact acts on.
    pub(crate) nodes: &'a mut [TouchedNode],
    /// For each contact the places of its cell's nodes among them.
    pub(crate) corner_nodes: &'a [[u32; 8]],
    /// For each contact the number of its patch.
    pub(crate) patch: &'a [usize],
    /// For each patch the forces that are missing at its cell's nodes, over the force on it.
    pub(crate) missing: &'a [[DVec3; 8]],
    /// Frictional impulse on the soil at each contact in this step [N s].
    pub(crate) friction: &'a mut [DVec3],
    /// Time step [s].
    pub(crate) dt: f64,
}

/// A node that contact acts on.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TouchedNode {
    /// Place in memory, if it is in this block.
    pub(crate) node: Option<usize>,
    /// Whether this block owns it.
    pub(crate) is_owned: bool,
    /// Velocity [m/s].
    pub(crate) velocity: DVec3,
    /// One over the mass along x, y, z [1/kg]; 0 where the node does not move, for want of mass or because of a wall.
    pub(crate) inverse_mass: DVec3,
    /// Which velocity components no boundary holds.
    pub(crate) is_free: [bool; 3],
    /// Mass [kg].
    pub(crate) mass: f64,
    /// Velocity before contact [m/s].
    pub(crate) free: DVec3,
    /// Velocity at the end of the last step [m/s].
    pub(crate) before: DVec3,
}

/// Offsets of a cell's eight nodes, in the order of the weights.
pub(crate) fn corners([x, y, z]: [usize; 3]) -> [usize; 8] {
    [0, x, y, x + y, z, x + z, y + z, x + y + z]
}

/// Sum over a cell's corners, in an order that a mirror in y changes no bit of.
pub(crate) fn over_corners<T: Copy + std::ops::Add<Output = T>>(v: [T; 8]) -> T {
    ((v[0] + v[2]) + (v[1] + v[3])) + ((v[4] + v[6]) + (v[5] + v[7]))
}

/// Side of the body's middle that a point lies on: 0 and 1, or 2 in the middle.
pub(crate) fn side(c: &Contact) -> usize {
    if c.arm.y == 0.0 { 2 } else { usize::from(c.arm.y < 0.0) }
}

/// Where an impulse acts: on a body at a point, and on the nodes of a cell.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Grip {
    /// Which body.
    pub(crate) body: usize,
    /// From the body's reference point [m].
    pub(crate) arm: DVec3,
    /// Places of the nodes among the touched ones.
    pub(crate) nodes: [u32; 8],
    /// Their weights.
    pub(crate) weight: [f64; 8],
    /// Unit normal of a patch out of the body; 0 for a point.
    pub(crate) normal: DVec3,
    /// Forces that are missing at the nodes, over the force along the normal.
    pub(crate) missing: [DVec3; 8],
}

impl Grip {
    /// What a node takes of an impulse [N s].
    pub(crate) fn on_node(&self, n: usize, impulse: DVec3) -> DVec3 {
        self.weight[n] * impulse + impulse.dot(self.normal) * self.missing[n]
    }
}

impl Scene<'_> {
    /// Where a contact acts.
    pub(crate) fn grip(&self, contact: usize) -> Grip {
        let Contact { body, arm, weight, .. } = self.contacts[contact];
        Grip { body, arm, nodes: self.corner_nodes[contact], weight, ..Grip::default() }
    }

    /// Velocity of a body at `arm` minus that of the soil in a cell, from the cell's nodes and their weights [m/s].
    pub(crate) fn slip_velocity(
        &self,
        (body, arm): (usize, DVec3),
        nodes: &[u32; 8],
        weight: &[f64; 8],
    ) -> DVec3 {
        let soil = |n: usize| weight[n] * self.nodes[nodes[n] as usize].velocity;
        velocity_at(&self.bodies[body], arm) - over_corners(std::array::from_fn(soil))
    }

    /// That at a contact.
    pub(crate) fn slip_velocity_of(&self, contact: usize) -> DVec3 {
        let Contact { body, arm, weight, .. } = &self.contacts[contact];
        self.slip_velocity((*body, *arm), &self.corner_nodes[contact], weight)
    }

    /// That at a patch, as what is missing at its nodes sees it: an impulse along the normal changes it by its work.
    pub(crate) fn slip_velocity_of_patch(&self, grip: &Grip) -> DVec3 {
        let stirred = |n: usize| grip.missing[n].dot(self.nodes[grip.nodes[n] as usize].velocity);
        self.slip_velocity((grip.body, grip.arm), &grip.nodes, &grip.weight)
            - over_corners(std::array::from_fn(stirred)) * grip.normal
    }

    /// Gives an impulse [N s] to the soil and takes it from the body, as far as the body is free.
    pub(crate) fn exchange(&mut self, grip: &Grip, impulse: DVec3) {
        for (n, place) in grip.nodes.iter().enumerate() {
            let node = &mut self.nodes[*place as usize];
            node.velocity += node.inverse_mass * grip.on_node(n, impulse);
        }
        push(
            &self.model.bodies[grip.body],
            &mut self.bodies[grip.body],
            self.model.share(),
            [(grip.arm, -impulse)],
        );
    }

    /// Does so at two places of one body at once; which of them is named first makes no difference to the bit.
    pub(crate) fn exchange_both(&mut self, first: (&Grip, DVec3), second: (&Grip, DVec3)) {
        let gain = |nodes: &[TouchedNode], (grip, impulse): (&Grip, DVec3), n: usize| {
            nodes[grip.nodes[n] as usize].inverse_mass * grip.on_node(n, impulse)
        };
        for (n, node) in first.0.nodes.iter().enumerate() {
            let own = gain(self.nodes, first, n);
            let shared = second.0.nodes.iter().position(|other| other == node);
            let both = shared.map_or(own, |m| own + gain(self.nodes, second, m));
            self.nodes[*node as usize].velocity += both;
        }
        for (n, node) in second.0.nodes.iter().enumerate().filter(|(_, node)| !first.0.nodes.contains(node)) {
            let own = gain(self.nodes, second, n);
            self.nodes[*node as usize].velocity += own;
        }
        let body = first.0.body;
        let impulses = [(first.0.arm, -first.1), (second.0.arm, -second.1)];
        push(&self.model.bodies[body], &mut self.bodies[body], self.model.share(), impulses);
    }

    /// Notes what the soil gave to a body at a point in this step: the reaction to these impulses on the soil [N s].
    pub(crate) fn note(&mut self, contact: usize, normal: DVec3, friction: DVec3) {
        let c = &self.contacts[contact];
        let received = &mut self.bodies[c.body].received;
        received.normal -= normal / self.model.share();
        received.friction -= friction / self.model.share();
        received.axle -= c.arm.cross(normal + friction).y / self.model.share();
        self.friction[contact] += friction;
    }
}

/// Velocity of a body at `arm` from its reference point [m/s].
pub(crate) fn velocity_at(body: &Body, arm: DVec3) -> DVec3 {
    body.velocity + (DVec3::Y * body.spin).cross(arm)
}

/// Gives impulses [N s], each with its arm, to the modelled share of a body; only free motions answer.
fn push<const N: usize>(fixed: &BodyModel, body: &mut Body, share: f64, impulses: [(DVec3, DVec3); N]) {
    let sum = |value: fn(&(DVec3, DVec3)) -> f64| impulses.iter().map(value).sum::<f64>();
    for (axis, impulse) in [sum(|i| i.1.x), sum(|i| i.1.y), sum(|i| i.1.z)].into_iter().enumerate() {
        if fixed.translation[axis].is_free() {
            body.velocity[axis] += impulse / (fixed.mass * share);
        }
    }
    if fixed.spin.is_free() {
        body.spin += sum(|(arm, impulse)| arm.cross(*impulse).y) / (fixed.axle_inertia * share);
    }
}

/// Axis of the largest component.
pub(crate) fn largest_axis(v: DVec3) -> usize {
    let size = v.abs();
    if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    }
}
