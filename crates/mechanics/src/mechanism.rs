//! A mechanism: bodies and joints.

use crate::body::{Body, BodyState};
use crate::configuration::Configuration;
use crate::error::Invalid;
use crate::joint::Joint;
use crate::steering::Steering;
use crate::touch::Pair;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Bodies and joints: what is fixed during a run.
#[derive(Debug, Default)]
pub struct Mechanism {
    bodies: Vec<Body>,
    joints: Vec<Arc<dyn Joint>>,
    pairs: Vec<Arc<dyn Pair>>,
}

/// The state of a mechanism: what changes in a step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MechanismState {
    /// State of each body.
    pub bodies: Vec<BodyState>,
    /// What each joint has done, then each pair of bodies that may touch.
    pub joints: Vec<JointState>,
}

/// What a joint has done; for output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JointState {
    /// Impulses of the last step, by row [N s or N m s].
    pub impulses: [f64; 6],
    /// Sum of the impulses on its second body since the start, moments about that body's reference point; of
    /// a joint whose second side is the ground, on the ground, about the origin.
    pub on_second: Wrench,
}

impl Mechanism {
    /// A mechanism of bodies and joints.
    ///
    /// # Errors
    /// [`Invalid`] where a free body lacks mass properties, or a joint names a body that is not there.
    pub fn new(bodies: Vec<Body>, joints: Vec<Arc<dyn Joint>>) -> Result<Self, Invalid> {
        let mechanism = Self::unchecked(bodies, joints);
        mechanism.check().map(|()| mechanism)
    }

    /// A mechanism of these bodies and joints without [`Mechanism::check`].
    #[must_use]
    pub fn unchecked(bodies: Vec<Body>, joints: Vec<Arc<dyn Joint>>) -> Self {
        Self { bodies, joints, pairs: Vec::new() }
    }

    /// The mechanism with pairs of bodies that may touch.
    #[must_use]
    pub fn touching(self, pairs: Vec<Arc<dyn Pair>>) -> Self {
        Self { pairs, ..self }
    }

    /// The mechanism with bodies that another program steers, in their order.
    #[must_use]
    pub fn steered(self, steering: &[Option<Steering>]) -> Self {
        let Self { mut bodies, joints, pairs } = self;
        for (body, steering) in bodies.iter_mut().zip(steering) {
            if let Some(steering) = steering {
                *body = body.clone().steered(*steering);
            }
        }
        Self { bodies, joints, pairs }
    }

    /// Whether the mechanism can be computed.
    ///
    /// # Errors
    /// [`Invalid`] where a free body lacks mass properties, or a joint names a body that is not there.
    pub fn check(&self) -> Result<(), Invalid> {
        self.bodies.iter().try_for_each(Body::check)?;
        for joint in &self.joints {
            let named = joint.bodies();
            let exist = named.iter().flatten().all(|body| *body < self.bodies.len());
            if !exist || named[0] == named[1] {
                return Err(Invalid::Joint);
            }
        }
        let exist = |pair: &Arc<dyn Pair>| {
            let [first, second] = pair.bodies();
            first != second && first.max(second) < self.bodies.len()
        };
        if self.pairs.iter().all(exist) { Ok(()) } else { Err(Invalid::Joint) }
    }

    /// The bodies.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The joints.
    #[must_use]
    pub fn joints(&self) -> &[Arc<dyn Joint>] {
        &self.joints
    }

    /// The pairs of bodies that may touch.
    #[must_use]
    pub fn pairs(&self) -> &[Arc<dyn Pair>] {
        &self.pairs
    }

    /// Whether a state has as many bodies and joints as the mechanism.
    #[must_use]
    pub fn accepts(&self, state: &MechanismState) -> bool {
        state.bodies.len() == self.bodies.len() && state.joints.len() == self.joints.len() + self.pairs.len()
    }

    /// Kinetic energy [J] of the whole bodies, prescribed motions included.
    #[must_use]
    pub fn kinetic_energy(&self, state: &MechanismState) -> f64 {
        self.each(state).map(|(body, now)| body.kinetic_energy(now)).sum()
    }

    /// Potential energy [J] of the whole bodies in a gravity field [m/s²], less that of the fluid that they
    /// displace; 0 with every centre at the origin.
    #[must_use]
    pub fn potential_energy(&self, state: &MechanismState, gravity: DVec3) -> f64 {
        self.each(state).map(|(body, now)| body.potential_energy(now, gravity)).sum()
    }

    /// Energy stored in the joints [J].
    #[must_use]
    pub fn joint_energy(&self, state: &MechanismState) -> f64 {
        let attitude = |body: Option<usize>| {
            let at_rest = |n: usize| Configuration::new(&state.bodies[n].pose, &Twist::ZERO, 0.0);
            body.map_or(Configuration::GROUND, at_rest)
        };
        let energy = |joint: &dyn Joint| {
            let [first, second] = joint.bodies().map(attitude);
            joint.energy([&first, &second])
        };
        self.joints.iter().map(|joint| energy(joint.as_ref())).sum()
    }

    /// Linear momentum [N s] of the whole bodies.
    #[must_use]
    pub fn linear_momentum(&self, state: &MechanismState) -> DVec3 {
        self.each(state).map(|(_, now)| now.momentum.linear).sum()
    }

    /// Angular momentum [N m s] of the whole bodies about a point of space [m].
    #[must_use]
    pub fn angular_momentum(&self, state: &MechanismState, about: DVec3) -> DVec3 {
        let of = |(body, now): (&Body, &BodyState)| {
            now.momentum.angular + (body.centre(now) - about).cross(now.momentum.linear)
        };
        self.each(state).map(of).sum()
    }

    fn each<'a>(&'a self, state: &'a MechanismState) -> impl Iterator<Item = (&'a Body, &'a BodyState)> {
        self.bodies.iter().zip(&state.bodies)
    }
}
