//! The velocities of a step without contact.

use crate::mechanism::{Mechanism, MechanismState};
use crate::step::{Conditions, Step};

impl Mechanism {
    /// Finds the velocities of a step without contact, for contact to begin with.
    pub fn predict(&self, state: &MechanismState, conditions: &Conditions, step: &mut Step) {
        self.begin(state, conditions, step);
        self.integrate(state, step);
        for body in &mut step.bodies {
            body.predicted = body.twist;
        }
        let Step { bodies, joints, .. } = step;
        for joint in joints {
            joint.prepare(bodies);
        }
        step.find_touches(self, state);
        if !step.touches.is_empty() {
            step.collide();
            step.settle();
        }
    }
}
