//! The impulses on a body in one step, and their work.

use crate::twist::Twist;
use crate::wrench::Wrench;

/// The impulses on a body in one step, about its reference point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Impulses {
    /// Of the loads, and of the drag of a fluid.
    pub load: Wrench,
    /// Of gravity, and of buoyancy.
    pub gravity: Wrench,
    /// Of contact, on the whole body.
    pub contact: Wrench,
    /// Of the joints, as a reaction to loads, contact and changes of prescribed speeds.
    pub joint_reaction: Wrench,
    /// Of the joints, within the step: as a reaction to gravity and inertia, and of springs.
    pub joint: Wrench,
    /// Of drives and supports, as a reaction to loads and contact, and to change prescribed speeds.
    pub drive_reaction: Wrench,
    /// Of drives and supports, within the step.
    pub drive: Wrench,
}

/// Work done on a whole body in one step [J], by what does it. The sum is the change of its kinetic energy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Of the loads, and of the drag of a fluid.
    pub load: f64,
    /// Of gravity and buoyancy: what the body loses in potential energy.
    pub gravity: f64,
    /// Of contact.
    pub contact: f64,
    /// Of the joints; they pass it on from body to body.
    pub joint: f64,
    /// Of drives and supports.
    pub drive: f64,
}

impl Work {
    /// All of it [J].
    #[must_use]
    pub fn total(&self) -> f64 {
        self.load + self.gravity + self.contact + self.joint + self.drive
    }
}

impl Impulses {
    /// Work of the impulses [J]: of those at the start of the step at the twist that they meet, of those
    /// within it at the twist of the step.
    #[must_use]
    pub fn work(&self, met: &Twist, within: &Twist) -> Work {
        Work {
            load: self.load.dot(met),
            gravity: self.gravity.dot(within),
            contact: self.contact.dot(met),
            joint: self.joint_reaction.dot(met) + self.joint.dot(within),
            drive: self.drive_reaction.dot(met) + self.drive.dot(within),
        }
    }
}
