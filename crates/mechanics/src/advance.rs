//! The end of a step: the bodies move.

use crate::impulses::Impulses;
use crate::mechanism::{Mechanism, MechanismState};
use crate::step::Step;
use crate::wrench::Wrench;

impl Mechanism {
    /// Takes the step with the impulses of contact and puts the state at its end.
    ///
    /// The impulses are kept and the motion is found anew with them: contact saw the bodies' linear response
    /// in the predicted configuration and joints that were relaxed, which differs from the motion by terms of
    /// second order in the step.
    pub fn advance(&self, state: &mut MechanismState, step: &mut Step) {
        step.take_touches();
        let is_struck =
            |impulses: &Impulses| impulses.contact != Wrench::ZERO || impulses.touch != Wrench::ZERO;
        if step.bodies.iter().any(|body| is_struck(&body.impulses)) {
            self.integrate(state, step);
        } else {
            for body in &mut step.bodies {
                body.twist = body.predicted;
            }
        }
        for (now, moving) in state.bodies.iter_mut().zip(&step.bodies) {
            now.pose = now.pose.moved(&moving.twist, step.conditions.dt);
            now.twist = moving.twist;
            now.momentum = moving.end;
            now.speeds = moving.speeds;
            now.tilt_axis = moving.tilt_axis;
        }
        let (joints, pairs) = state.joints.split_at_mut(step.joints.len());
        for (pair, now) in pairs.iter_mut().enumerate() {
            now.on_second += step.of_pair(pair);
        }
        for (now, joint) in joints.iter_mut().zip(&step.joints) {
            now.impulses = std::array::from_fn(|k| joint.reaction[k] + 2.0 * joint.within[k]);
            for (row, impulse) in joint.rows.as_slice().iter().zip(now.impulses) {
                now.on_second += impulse * row.wrench[1];
            }
        }
    }
}
