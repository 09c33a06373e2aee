//! The motion of a mechanism in one step without contact: loads, drives, gravity, inertia, joints.
//!
//! At the start of the step loads and changes of prescribed speeds act as impulses, as contact does, with the reactions of joints and
//! supports. Within the step gravity, gyroscopic terms, joints and supports act by the midpoint rule of Simo & Wong (1991), which
//! conserves energy and momentum. The configuration depends on the twist, so both are found by iteration.

use crate::body::{Body, BodyState};
use crate::configuration::Configuration;
use crate::freedom::{self, Directions};
use crate::gimbal::{self, Axes};
use crate::impulses::Impulses;
use crate::joint::Row;
use crate::mechanism::{Mechanism, MechanismState};
use crate::mobility::Mobility;
use crate::moving::{MovingBody, MovingJoint};
use crate::step::Step;
use crate::system::Answer;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::DVec3;

/// The circumstances of one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conditions {
    /// Time at the start of the step [s].
    pub time: f64,
    /// Duration of the step [s].
    pub dt: f64,
    /// Acceleration of gravity [m/s²].
    pub gravity: DVec3,
}

/// Largest number of iterations.
const ITERATIONS: usize = 40;
/// Change of the twists in an iteration, relative to the twists, below which they have converged; chosen near round-off.
const CONVERGED: f64 = 1e-15;
/// The same, below which they have converged if it no longer decreases.
const STAGNANT: f64 = 1e-9;

impl Mechanism {
    /// Finds the velocities of a step without contact.
    pub fn predict(&self, state: &MechanismState, conditions: &Conditions, step: &mut Step) {
        self.begin(state, conditions, step);
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            self.configure(state, conditions, step);
            self.react(state, step);
            let change = self.move_within(state, step);
            if change <= CONVERGED || change >= last && change < STAGNANT {
                break;
            }
            last = change;
        }
        let Step { bodies, joints, .. } = step;
        for (body, now) in bodies.iter_mut().zip(&state.bodies) {
            finish(body, now);
        }
        for joint in joints {
            joint.prepare(bodies);
        }
    }

    fn begin(&self, state: &MechanismState, conditions: &Conditions, step: &mut Step) {
        step.dt = conditions.dt;
        step.bodies.clear();
        step.bodies.extend(self.bodies().iter().zip(&state.bodies).map(|(body, now)| {
            let configuration = Configuration::new(&now.pose, &now.twist, conditions.dt);
            let mut moving = MovingBody::new(body, configuration, now.twist);
            moving.speeds = body.speeds(conditions.time + 0.5 * conditions.dt);
            moving
        }));
        step.joints.clear();
        step.joints.extend(self.joints().iter().map(|joint| MovingJoint::new(joint.bodies())));
    }

    /// Attitudes, mobilities, loads and rows of the joints for the twists so far.
    fn configure(&self, state: &MechanismState, conditions: &Conditions, step: &mut Step) {
        for ((body, now), moving) in self.bodies().iter().zip(&state.bodies).zip(&mut step.bodies) {
            moving.configuration = Configuration::new(&now.pose, &moving.predicted, conditions.dt);
            moving.inertia = moving.configuration.mean_inertia(&body.inertia);
            let end = &moving.configuration.end;
            moving.tilt_axis =
                if body.motion[3].is_fixed() { now.tilt_axis } else { gimbal::tilt_axis(end, now.tilt_axis) };
            let axes = axes(moving, now);
            moving.mobility = Mobility::new(&moving.inertia, &Directions::new(body, &axes));
            moving.impulses.load = load(body, &axes, conditions);
            let weight = body.inertia.mass * conditions.dt * conditions.gravity;
            moving.impulses.gravity = Wrench::at(moving.inertia.arm, weight);
        }
        for (joint, moving) in self.joints().iter().zip(&mut step.joints) {
            let attitude =
                |body: Option<usize>| body.map_or(&Configuration::GROUND, |n| &step.bodies[n].configuration);
            let rows = joint.rows(joint.bodies().map(attitude), conditions.dt);
            moving.rows = rows;
        }
    }

    /// The start of the step: loads and changes of prescribed speeds, and what joints and supports answer.
    fn react(&self, state: &MechanismState, step: &mut Step) {
        let Step { bodies, joints, system, .. } = step;
        let mut is_idle = true;
        for ((body, now), moving) in self.bodies().iter().zip(&state.bodies).zip(bodies.iter_mut()) {
            let change = std::array::from_fn(|n| moving.speeds[n] - now.speeds[n]);
            let jump = freedom::driven(body, &change, &axes(moving, now));
            moving.twist = respond(moving, &moving.impulses.load, &jump);
            is_idle &= moving.twist == Twist::ZERO && moving.impulses.load == Wrench::ZERO;
        }
        if is_idle {
            return;
        }
        system.factor(bodies, joints, Answer::Rigid);
        let sought = rows(joints).map(|(joint, row)| -joint.velocity(row, |body| bodies[body].twist));
        let impulses = system.solve(sought);
        share_out(impulses, joints, |joint| &mut joint.reaction);
        for (n, (body, moving)) in self.bodies().iter().zip(bodies).enumerate() {
            let reaction = on_body(joints, n, |joint| &joint.reaction);
            moving.twist += moving.mobility.response(&reaction);
            let free = moving.impulses.load + reaction;
            moving.impulses.joint_reaction = reaction;
            moving.impulses.drive_reaction = support(body, moving, &free);
        }
    }

    /// Within the step: gravity, gyroscopic terms, joints and supports. Returns the relative change of the twists.
    fn move_within(&self, state: &MechanismState, step: &mut Step) -> f64 {
        let Step { bodies, joints, system, .. } = step;
        for ((body, now), moving) in self.bodies().iter().zip(&state.bodies).zip(bodies.iter_mut()) {
            let driven = freedom::driven(body, &moving.speeds, &axes(moving, now));
            moving.twist = respond(moving, &mean_momentum(moving, now), &driven);
        }
        system.factor(bodies, joints, Answer::All);
        let sought =
            rows(joints).map(|(joint, row)| row.bias - joint.velocity(row, |body| bodies[body].twist));
        let impulses = system.solve(sought);
        share_out(impulses, joints, |joint| &mut joint.within);
        let (mut change, mut size) = (0.0_f64, 0.0_f64);
        for (n, ((body, now), moving)) in self.bodies().iter().zip(&state.bodies).zip(bodies).enumerate() {
            let half = on_body(joints, n, |joint| &joint.within);
            moving.twist += moving.mobility.response(&half);
            let free = mean_momentum(moving, now) + half;
            moving.impulses.joint = 2.0 * half;
            moving.impulses.drive = 2.0 * support(body, moving, &free);
            let within = moving.impulses.gravity + moving.impulses.joint + moving.impulses.drive;
            moving.torque = within.moment_about(moving.inertia.arm);
            let length = size_of_motion(body);
            let speed = |twist: &Twist| twist.linear.length() / length + twist.angular.length();
            change = change.max(speed(&(moving.twist - moving.predicted)));
            size = size.max(speed(&moving.twist));
            moving.predicted = moving.twist;
        }
        if size > 0.0 { change / size } else { change }
    }
}

/// Mean axes of the rotational freedoms over the step.
fn axes(moving: &MovingBody, now: &BodyState) -> Axes {
    let configuration = &moving.configuration;
    gimbal::mean_axes((&configuration.start, now.tilt_axis), (&configuration.end, moving.tilt_axis))
}

/// Impulse of the loads: each along the axis of its freedom.
fn load(body: &Body, axes: &Axes, conditions: &Conditions) -> Wrench {
    let middle = conditions.time + 0.5 * conditions.dt;
    let mut sum = Wrench::ZERO;
    for (n, motion) in body.motion.iter().enumerate() {
        let impulse = motion.load(middle) * conditions.dt;
        if impulse != 0.0 {
            sum += if n < 3 {
                Wrench { force: impulse * DVec3::AXES[n], moment: DVec3::ZERO }
            } else {
                Wrench::couple(impulse * axes[n - 3])
            };
        }
    }
    sum
}

/// The twist that a momentum makes of the free motions beside a prescribed twist.
fn respond(moving: &MovingBody, momentum: &Wrench, driven: &Twist) -> Twist {
    *driven + moving.mobility.response(&(*momentum - moving.inertia.momentum(driven)))
}

/// The mean momentum of the step, about the reference point, without joints and supports: that at the start, after the impulses
/// there, half of gravity's, and the gyroscopic remainder −¼ w × T of the midpoint rule.
fn mean_momentum(moving: &MovingBody, now: &BodyState) -> Wrench {
    let Impulses { load, joint_reaction, drive_reaction, gravity, .. } = moving.impulses;
    let gyroscopic = Wrench::couple(-0.25 * moving.configuration.turn().cross(moving.torque));
    let start = now.momentum.about_reference(moving.inertia.arm);
    start + load + joint_reaction + drive_reaction + 0.5 * gravity + gyroscopic
}

/// What drives and supports add to an impulse for the body to move as it does; nothing on a body that moves freely.
fn support(body: &Body, moving: &MovingBody, free: &Wrench) -> Wrench {
    if body.moves_freely() { Wrench::ZERO } else { moving.inertia.momentum(&moving.twist) - *free }
}

/// All rows of all joints, in order.
fn rows(joints: &[MovingJoint]) -> impl Iterator<Item = (&MovingJoint, &Row)> {
    joints.iter().flat_map(|joint| joint.rows.as_slice().iter().map(move |row| (joint, row)))
}

/// Hands the impulses of all rows to their joints.
fn share_out(impulses: &[f64], joints: &mut [MovingJoint], of: impl Fn(&mut MovingJoint) -> &mut [f64; 6]) {
    let mut rest = impulses;
    for joint in joints {
        let (own, others) = rest.split_at(joint.rows.as_slice().len());
        of(joint)[..own.len()].copy_from_slice(own);
        rest = others;
    }
}

/// Sum of the joints' impulses on a body.
fn on_body(joints: &[MovingJoint], body: usize, of: impl Fn(&MovingJoint) -> &[f64; 6]) -> Wrench {
    let mut sum = Wrench::ZERO;
    for joint in joints.iter().filter(|joint| joint.bodies.contains(&Some(body))) {
        for (row, impulse) in joint.rows.as_slice().iter().zip(of(joint)) {
            sum += *impulse * joint.on(row, body);
        }
    }
    sum
}

/// Radius of gyration [m], to compare velocities with rates of rotation; 1 for a body without one.
fn size_of_motion(body: &Body) -> f64 {
    let tensor = body.inertia.tensor;
    let radius = ((tensor.x_axis.x + tensor.y_axis.y + tensor.z_axis.z) / body.inertia.mass).sqrt();
    if radius > 0.0 && radius.is_finite() { radius } else { 1.0 }
}

/// The momentum at the end of the step.
fn finish(moving: &mut MovingBody, now: &BodyState) {
    let Impulses { load, joint_reaction, drive_reaction, gravity, joint, drive, .. } = moving.impulses;
    let arm = moving.inertia.arm;
    let between = load + joint_reaction + drive_reaction;
    moving.momentum = now.momentum.after(&between, arm).after(&(gravity + joint + drive), arm);
}
