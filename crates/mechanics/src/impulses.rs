//! The impulses on a body in one step, and their work.

use crate::twist::Twist;
use crate::wrench::Wrench;

/// The impulses on a body in one step, about its reference point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Impulses {
    /// Of the loads.
    pub load: Wrench,
    /// Of gravity.
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
    /// Of the loads.
    pub load: f64,
    /// Of gravity: what the body loses in potential energy.
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
    /// Their work. What acts within the step meets the twist of the step; what acts between two steps meets the mean of the
    /// twists before and after.
    #[must_use]
    pub fn work(&self, before: &Twist, now: &Twist) -> Work {
        let mean = 0.5 * (*before + *now);
        Work {
            load: self.load.dot(&mean),
            gravity: self.gravity.dot(now),
            contact: self.contact.dot(&mean),
            joint: self.joint_reaction.dot(&mean) + self.joint.dot(now),
            drive: self.drive_reaction.dot(&mean) + self.drive.dot(now),
        }
    }
}
