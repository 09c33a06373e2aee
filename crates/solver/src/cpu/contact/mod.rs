//! Contact between soil and bodies at points of the bodies' surfaces.
//!
//! A point acts on the eight nodes of the cell that it lies in. Where it lies, and with which weights, is found at
//! every remap and kept till the next. How soil and body act on each other there is a [`ContactLaw`]'s business; two
//! were built: penalty with a history, and velocity impulses.

mod geometry;
mod impulse;
mod penalty;

pub(crate) use geometry::{carve as carve_soil, locate, touched_nodes};

use crate::cpu::workspace::Workspace;
use crate::model::{BodyModel, ContactMethod, Model};
use crate::state::{Body, Contact, State};
use glam::DVec3;
use physics::shape::SurfacePoint;

/// How soil and body act on each other at the contact points.
pub(crate) trait ContactLaw {
    /// Called for each point when it has been located anew; `gap` is the void between body and soil [m], negative when
    /// they overlap.
    fn relocate(&self, contact: &mut Contact, gap: f64, travel: f64, was_in_soil: bool);
    /// Changes the velocities of nodes and bodies for one step.
    fn act(&self, scene: &mut Scene);
}

/// What a contact law works on during a step.
pub(crate) struct Scene<'a> {
    pub(crate) model: &'a Model,
    pub(crate) contacts: &'a mut [Contact],
    pub(crate) bodies: &'a mut [Body],
    pub(crate) velocity: &'a mut [Vec<f64>; 3],
    pub(crate) mass: &'a [f64],
    /// Time step [s].
    pub(crate) dt: f64,
}

/// Offsets of a cell's eight nodes, in the order of the weights.
fn corners([x, y, z]: [usize; 3]) -> [usize; 8] {
    [0, x, y, x + y, z, x + z, y + z, x + y + z]
}

impl Scene<'_> {
    /// Velocity of the soil at a point [m/s].
    fn soil_velocity(&self, contact: &Contact) -> DVec3 {
        let offsets = corners(self.model.grid.stride);
        let mut v = DVec3::ZERO;
        for (offset, w) in offsets.iter().zip(contact.weight) {
            let n = contact.base + offset;
            v += w * DVec3::new(self.velocity[0][n], self.velocity[1][n], self.velocity[2][n]);
        }
        v
    }

    /// Velocity of the body minus that of the soil at a point [m/s].
    fn slip_velocity(&self, contact: &Contact) -> DVec3 {
        velocity_at(&self.bodies[contact.body], contact.arm) - self.soil_velocity(contact)
    }

    /// Gives an impulse [N s] to the soil and takes it from the body, as far as the body is free; notes what the body
    /// received from its normal and its frictional part.
    fn exchange(&mut self, contact: &Contact, normal: DVec3, friction: DVec3) {
        let impulse = normal + friction;
        let offsets = corners(self.model.grid.stride);
        for (offset, w) in offsets.iter().zip(contact.weight) {
            let n = contact.base + offset;
            if w > 0.0 {
                for (v, p) in self.velocity.iter_mut().zip(impulse.to_array()) {
                    v[n] += w * p / self.mass[n];
                }
            }
        }
        let fixed = &self.model.bodies[contact.body];
        let body = &mut self.bodies[contact.body];
        body.received.normal -= normal / self.model.share;
        body.received.friction -= friction / self.model.share;
        body.received.axle -= contact.arm.cross(impulse).y / self.model.share;
        push(fixed, body, self.model.share, contact.arm, -impulse);
    }
}

/// Velocity of a body at `arm` from its reference point [m/s].
pub(crate) fn velocity_at(body: &Body, arm: DVec3) -> DVec3 {
    body.velocity + (DVec3::Y * body.spin).cross(arm)
}

/// Gives an impulse [N s] to the modelled share of a body at `arm`; only free motions answer.
fn push(fixed: &BodyModel, body: &mut Body, share: f64, arm: DVec3, impulse: DVec3) {
    for axis in 0..3 {
        if fixed.translation[axis].is_free() {
            body.velocity[axis] += impulse[axis] / (fixed.mass * share);
        }
    }
    if fixed.spin.is_free() {
        body.spin += arm.cross(impulse).y / (fixed.axle_inertia * share);
    }
}

/// The contact law of a model.
pub(crate) fn law(model: &Model) -> Box<dyn ContactLaw> {
    match model.method.contact {
        ContactMethod::Penalty => Box::new(penalty::Penalty::new(model)),
        ContactMethod::Impulse => Box::new(impulse::Impulses),
    }
}

/// Surface points of a body for a grid whose cells near it have the width `cell` [m].
pub(crate) fn surface_points(model: &Model, body: &BodyModel) -> Vec<SurfacePoint> {
    let cell = model.grid.finest();
    body.shape.surface_points(model.method.point_spacing * cell, DVec3::splat(model.method.edge_inset * cell))
}

/// Lets soil and bodies act on each other for one step. Returns the energy that this took out of them [J].
pub(crate) fn contact(model: &Model, state: &mut State, workspace: &mut Workspace, dt: f64) -> ContactWork {
    if state.contacts.is_empty() {
        return ContactWork::default();
    }
    let Workspace { touched, velocity_before, .. } = workspace;
    let before: Vec<(DVec3, f64)> = state.bodies.iter().map(|b| (b.velocity, b.spin)).collect();
    let received: Vec<_> = state.bodies.iter().map(|b| b.received).collect();
    let velocity = &mut state.nodes.velocity;
    for (n, v) in touched.iter_mut() {
        *v = DVec3::new(velocity[0][*n], velocity[1][*n], velocity[2][*n]);
    }
    let mass = &state.nodes.mass;
    let scene =
        &mut Scene { model, contacts: &mut state.contacts, bodies: &mut state.bodies, velocity, mass, dt };
    workspace.contact_law.act(scene);
    // Work on the soil: impulse on each node times the mean of its velocities before and after the step.
    let mut on_soil = 0.0;
    for (n, free) in touched.iter() {
        let now = DVec3::new(velocity[0][*n], velocity[1][*n], velocity[2][*n]);
        let then = DVec3::new(velocity_before[0][*n], velocity_before[1][*n], velocity_before[2][*n]);
        on_soil += mass[*n] * (now - *free).dot(0.5 * (now + then));
    }
    let mut on_bodies = Vec::with_capacity(state.bodies.len());
    for (n, body) in state.bodies.iter().enumerate() {
        let force =
            (body.received.normal - received[n].normal) + (body.received.friction - received[n].friction);
        let axle = body.received.axle - received[n].axle;
        on_bodies.push(BodyImpulse {
            force: force * model.share,
            axle: axle * model.share,
            velocity_free: before[n].0,
            spin_free: before[n].1,
        });
    }
    ContactWork { on_soil, on_bodies }
}

/// What contact did in one step.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContactWork {
    /// Work done on the soil [J].
    pub(crate) on_soil: f64,
    /// What each body received.
    pub(crate) on_bodies: Vec<BodyImpulse>,
}

/// What a body received in one step (modelled share).
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyImpulse {
    /// Impulse [N s].
    pub(crate) force: DVec3,
    /// Impulse about the axle [N m s].
    pub(crate) axle: f64,
    /// Velocity before contact [m/s].
    pub(crate) velocity_free: DVec3,
    /// Spin before contact [rad/s].
    pub(crate) spin_free: f64,
}
