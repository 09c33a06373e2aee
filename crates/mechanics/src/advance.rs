//! The end of a step: joints are closed, bodies move, momenta take up the impulses of contact.

use crate::body::{Body, BodyState};
use crate::configuration::Configuration;
use crate::mechanism::{Mechanism, MechanismState};
use crate::moving::MovingBody;
use crate::step::Step;
use crate::system::Answer;
use crate::wrench::Wrench;

/// Largest number of rounds in which joints are closed after contact.
const ROUNDS: usize = 6;
/// Correction of the velocities, relative to them, at which joints are closed; chosen near round-off.
const CLOSED: f64 = 1e-14;

impl Mechanism {
    /// Takes the velocities of a step over into the state: poses, momenta, twists.
    pub fn advance(&self, state: &mut MechanismState, step: &mut Step) {
        if step.bodies.iter().any(|body| body.twist != body.predicted) {
            self.close_joints(state, step);
        }
        for ((body, now), moving) in self.bodies().iter().zip(&mut state.bodies).zip(&mut step.bodies) {
            advance_body(body, now, moving, step.dt);
        }
        for (impulses, joint) in state.joints.iter_mut().zip(&step.joints) {
            *impulses = [0.0; 6];
            for (k, row) in joint.rows.as_slice().iter().enumerate() {
                let relaxed = if row.compliance > 0.0 { 2.0 } else { 1.0 } * joint.relaxed[k];
                impulses[k] = joint.reaction[k] + 2.0 * joint.within[k] + relaxed;
            }
        }
    }

    /// Restores the joints all at once, in the configuration of the final twists. What contact changed in the mean configuration
    /// would otherwise open them by a term of second order.
    fn close_joints(&self, state: &MechanismState, step: &mut Step) {
        let Step { bodies, joints, system, dt } = step;
        if joints.is_empty() {
            return;
        }
        for _ in 0..ROUNDS {
            for (joint, moving) in self.joints().iter().zip(joints.iter_mut()) {
                let attitude = |body: Option<usize>| {
                    let moved = |n: usize| Configuration::new(&state.bodies[n].pose, &bodies[n].twist, *dt);
                    body.map_or(Configuration::GROUND, moved)
                };
                let [first, second] = joint.bodies().map(attitude);
                moving.rows = joint.rows([&first, &second], *dt);
            }
            system.factor(bodies, joints, Answer::All);
            let missing = joints.iter().flat_map(|joint| {
                let rows = joint.rows.as_slice().iter().enumerate();
                rows.map(|(k, row)| joint.missing(k, row, bodies))
            });
            let mut rest = system.solve(missing);
            let before = bodies.iter().map(|body| body.twist).collect::<Vec<_>>();
            for joint in joints.iter_mut() {
                let (own, others) = rest.split_at(joint.rows.as_slice().len());
                joint.apply(own, bodies);
                rest = others;
            }
            let change = bodies.iter().zip(&before).all(|(body, before)| {
                let change = body.twist - *before;
                change.linear.length() <= CLOSED * before.linear.length()
                    && change.angular.length() <= CLOSED * before.angular.length()
            });
            if change {
                break;
            }
        }
    }
}

/// Moves one body.
fn advance_body(body: &Body, now: &mut BodyState, moving: &mut MovingBody, dt: f64) {
    let change = moving.twist - moving.predicted;
    // A spring acts half before and half after the middle: its impulse is twice its share in the mean momentum.
    let springs = moving.inertia.momentum(&moving.mobility.response(&moving.springs));
    let taken_up = moving.inertia.momentum(&change) + springs;
    now.momentum = moving.momentum.after(&taken_up, moving.inertia.arm);
    let impulses = &mut moving.impulses;
    impulses.joint += 2.0 * moving.springs;
    if !body.moves_freely() {
        let others = impulses.contact + 2.0 * moving.springs;
        impulses.drive_reaction += taken_up - others - moving.relaxed;
    }
    let end = Configuration::new(&now.pose, &moving.twist, dt);
    impulses.gravity = Wrench::at(end.mean(body.inertia.centre), impulses.gravity.force);
    if !body.motion[3].is_fixed() {
        now.tilt_axis = crate::gimbal::tilt_axis(&end.end, now.tilt_axis);
    }
    now.pose = now.pose.moved(&moving.twist, dt);
    now.twist = moving.twist;
    now.speeds = moving.speeds;
}
