//! The mechanism during one step: what contact sees of its bodies and joints.
//!
//! `predict` fills it with velocities without contact; contact applies impulses and relaxes joints in its
//! sweeps; `advance` takes the step with these impulses.

use crate::impulses::{Impulses, Work};
use crate::mobility::Mobility;
use crate::moving::{MovingBody, MovingJoint};
use crate::system::System;
use crate::touching::MovingTouch;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::{DMat3, DVec3};

/// The circumstances of one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Conditions {
    /// Time at the start of the step [s].
    pub time: f64,
    /// Duration of the step [s].
    pub dt: f64,
    /// Acceleration of gravity [m/s²].
    pub gravity: DVec3,
}

/// A mechanism during one step.
#[derive(Clone, Debug, Default)]
pub struct Step {
    pub(crate) conditions: Conditions,
    pub(crate) bodies: Vec<MovingBody>,
    pub(crate) joints: Vec<MovingJoint>,
    pub(crate) touches: Vec<MovingTouch>,
    pub(crate) system: System,
}

/// Properties of a body that contact needs in its sweeps, kept apart from all others: how it moves and
/// responds.
#[derive(Clone, Copy, Debug, Default)]
pub struct StruckBody {
    /// Twist of the body.
    pub twist: Twist,
    mobility: Mobility,
    /// The whole body over its modelled portion.
    whole: f64,
    /// Impulses of contact so far, on the whole body.
    contact: Wrench,
}

impl StruckBody {
    /// Applies an impulse about the reference point to the modelled portion of the body.
    #[inline]
    pub fn apply(&mut self, impulse: &Wrench) {
        let on_whole = self.whole * *impulse;
        self.contact += on_whole;
        self.twist += self.mobility.response(&on_whole);
    }
}

impl Step {
    /// A body as contact sees it; what happens to it counts once it is [put back](Self::put_back).
    #[must_use]
    pub fn struck(&self, body: usize) -> StruckBody {
        let body = &self.bodies[body];
        StruckBody {
            twist: body.twist,
            mobility: body.mobility,
            whole: 1.0 / body.modelled_fraction,
            contact: body.impulses.contact,
        }
    }

    /// Takes over the twist of a body and the impulses on it.
    pub fn put_back(&mut self, body: usize, struck: &StruckBody) {
        let body = &mut self.bodies[body];
        (body.twist, body.impulses.contact) = (struck.twist, struck.contact);
    }

    /// Duration [s].
    #[must_use]
    pub fn dt(&self) -> f64 {
        self.conditions.dt
    }

    /// Twist of a body as it now is.
    #[must_use]
    pub fn twist(&self, body: usize) -> Twist {
        self.bodies[body].twist
    }

    /// Twist of a body in the step before.
    #[must_use]
    pub fn twist_before(&self, body: usize) -> Twist {
        self.bodies[body].before
    }

    /// Twist of a body without contact.
    #[must_use]
    pub fn twist_free(&self, body: usize) -> Twist {
        self.bodies[body].predicted
    }

    /// Velocity of a body's point at `arm` from the reference point [m/s].
    #[must_use]
    #[inline]
    pub fn velocity_at(&self, body: usize, arm: DVec3) -> DVec3 {
        self.bodies[body].twist.at(arm)
    }

    /// Applies an impulse [N s] at `arm` from the reference point [m] to the modelled portion of a body.
    #[inline]
    pub fn apply(&mut self, body: usize, arm: DVec3, impulse: DVec3) {
        self.apply_wrench(body, &Wrench::at(arm, impulse));
    }

    /// Applies an impulse about the reference point to the modelled portion of a body.
    #[inline]
    pub fn apply_wrench(&mut self, body: usize, impulse: &Wrench) {
        let body = &mut self.bodies[body];
        let on_whole = (1.0 / body.modelled_fraction) * *impulse;
        body.impulses.contact += on_whole;
        body.twist += body.mobility.response(&on_whole);
    }

    /// Velocity of a body's point at `arm` per impulse there, on the modelled portion [1/kg]: its block of
    /// the Delassus operator.
    #[must_use]
    pub fn inverse_mass(&self, body: usize, arm: DVec3) -> DMat3 {
        let body = &self.bodies[body];
        body.mobility.at(arm) * (1.0 / body.modelled_fraction)
    }

    /// Diagonal of the inverse mass at a point of a body: along x, y and z [1/kg].
    #[must_use]
    pub fn inverse_mass_diagonal(&self, body: usize, arm: DVec3) -> DVec3 {
        let block = self.inverse_mass(body, arm);
        DVec3::new(block.x_axis.x, block.y_axis.y, block.z_axis.z)
    }

    /// The block along a unit vector [1/kg]; its inverse is the effective mass.
    #[must_use]
    pub fn inverse_mass_along(&self, body: usize, arm: DVec3, direction: DVec3) -> f64 {
        let body = &self.bodies[body];
        body.mobility.along(arm, direction) / body.modelled_fraction
    }

    /// The impulses on a body; those of contact and of reactions to it are known after `advance`.
    #[must_use]
    pub fn impulses(&self, body: usize) -> Impulses {
        self.bodies[body].impulses
    }

    /// Work done on a body; complete after `advance`.
    #[must_use]
    pub fn work(&self, body: usize) -> Work {
        let body = &self.bodies[body];
        body.impulses.work(&body.met, &body.twist)
    }

    /// Whether bodies act on each other, by joints or where they touch.
    #[must_use]
    pub fn are_bodies_connected(&self) -> bool {
        !self.joints.is_empty() || !self.touches.is_empty()
    }

    /// Number of places where bodies touch or may touch in the step.
    #[must_use]
    pub fn touches(&self) -> usize {
        self.touches.len()
    }

    /// Number of joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joints.len()
    }

    /// Relaxes one joint: changes the twists of its bodies by the impulses that restore it. One block of a
    /// Gauss–Seidel sweep.
    pub fn relax(&mut self, joint: usize) {
        let impulses = self.joints[joint].restoring(&self.bodies);
        self.joints[joint].apply(&impulses, &mut self.bodies);
    }

    /// Relaxes every joint, in order.
    pub fn relax_joints(&mut self) {
        for joint in 0..self.joints.len() {
            self.relax(joint);
        }
    }
}
