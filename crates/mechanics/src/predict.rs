//! The velocities of a step without contact.

use crate::mechanism::{Mechanism, MechanismState};
use crate::moving::{MovingBody, MovingJoint};
use crate::step::{Conditions, Step};

impl Mechanism {
    /// Finds the velocities of a step without contact, for contact to begin with.
    pub fn predict(&self, state: &MechanismState, conditions: &Conditions, step: &mut Step) {
        step.conditions = *conditions;
        step.bodies.clear();
        step.bodies.extend(self.bodies().iter().zip(&state.bodies).map(|(body, now)| {
            let speeds = body.speeds(conditions.time + 0.5 * conditions.dt);
            MovingBody::new(body, now, speeds)
        }));
        step.joints.clear();
        step.joints.extend(self.joints().iter().map(|joint| MovingJoint::new(joint.bodies())));
        self.settle(state, step);
        for body in &mut step.bodies {
            body.predicted = body.twist;
        }
        let Step { bodies, joints, .. } = step;
        for joint in joints {
            joint.prepare(bodies);
        }
    }
}
