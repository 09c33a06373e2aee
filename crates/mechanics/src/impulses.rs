//! The impulses on a body in one step, and their work.

use crate::twist::Twist;
use crate::wrench::Wrench;

/// The impulses on a body in one step, about its reference point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Impulses {
    /// Impulse of the loads, and of the drag of a fluid.
    pub load: Wrench,
    /// Impulse of gravity, and of buoyancy.
    pub gravity: Wrench,
    /// Impulse of contact, on the whole body.
    pub contact: Wrench,
    /// Impulse of other bodies that touch it.
    pub touch: Wrench,
    /// Impulse of the joints, as a reaction to loads, contact and changes of prescribed speeds.
    pub joint_reaction: Wrench,
    /// Impulse of the joints, within the step: as a reaction to gravity and inertia, and of springs.
    pub joint: Wrench,
    /// Impulse of drives and supports, as a reaction to loads and contact, and to change prescribed speeds.
    pub drive_reaction: Wrench,
    /// Impulse of drives and supports, within the step.
    pub drive: Wrench,
}

/// Work done on a whole body in one step [J], by what does it. The sum is the change of its kinetic energy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Work of the loads, and of the drag of a fluid [J].
    pub load: f64,
    /// Work of gravity and buoyancy: what the body loses in potential energy [J].
    pub gravity: f64,
    /// Work of contact [J].
    pub contact: f64,
    /// Work of other bodies that touch it [J]; together with theirs what friction and impacts take.
    pub touch: f64,
    /// Work of the joints [J]; they pass it on from body to body.
    pub joint: f64,
    /// Work of drives and supports [J].
    pub drive: f64,
}

impl Work {
    /// Total work [J].
    #[must_use]
    pub fn total(&self) -> f64 {
        self.load + self.gravity + self.contact + self.touch + self.joint + self.drive
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
            touch: self.touch.dot(met),
            joint: self.joint_reaction.dot(met) + self.joint.dot(within),
            drive: self.drive_reaction.dot(met) + self.drive.dot(within),
        }
    }
}
