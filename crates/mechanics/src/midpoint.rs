//! The motion of a mechanism in one step, for given impulses of contact.
//!
//! At the start of the step contact, loads, the drag of a fluid and changes of prescribed speeds act as
//! impulses, with the reactions of joints and supports in the configuration there. Within the step gravity,
//! gyroscopic terms, joints and supports act by the midpoint rule of Simo & Wong (1991), which conserves
//! energy and momentum. The configuration depends on the twist, so both are found by iteration.

use crate::body::{Body, BodyState, Momentum};
use crate::configuration::Configuration;
use crate::freedom::Directions;
use crate::gimbal::{self, Axes};
use crate::impulses::Impulses;
use crate::mechanism::{Mechanism, MechanismState};
use crate::mobility::Mobility;
use crate::moving::{MovingBody, MovingJoint};
use crate::steering::Steering;
use crate::step::{Conditions, Step};
use crate::system::{Answer, on_body, rows, share_out};
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::DVec3;

/// Largest number of iterations.
const ITERATIONS: usize = 40;
/// Change of the twists in an iteration, relative to the twists, below which they have converged; chosen near
/// round-off.
const CONVERGED: f64 = 1e-15;
/// Change of the twists in an iteration, relative to the twists, below which they have converged if it no
/// longer decreases.
const STAGNANT: f64 = 1e-9;

impl Mechanism {
    /// Fills a step with the bodies and joints as they are.
    pub(crate) fn begin(&self, state: &MechanismState, conditions: &Conditions, step: &mut Step) {
        step.conditions = *conditions;
        step.bodies.clear();
        step.bodies.extend(self.bodies().iter().zip(&state.bodies).map(|(body, now)| {
            let speeds = body.speeds(conditions.time + 0.5 * conditions.dt);
            MovingBody::new(body, now, speeds)
        }));
        step.joints.clear();
        step.joints.extend(self.joints().iter().map(|joint| MovingJoint::new(joint.bodies())));
    }

    /// Finds what the joints change of the velocities at the start of the step, so that these satisfy them.
    pub(crate) fn join(&self, state: &MechanismState, step: &mut Step) {
        self.configure_start(state, step);
        let Step { bodies, joints, system, .. } = step;
        system.factor(bodies, joints, Answer::Rigid);
        let sought = rows(joints).map(|(joint, row)| -joint.velocity(row, |body| state.bodies[body].twist));
        share_out(system.solve(sought), joints, |joint| &mut joint.reaction);
        for (n, moving) in bodies.iter_mut().enumerate() {
            moving.kick = moving.mobility.response(&on_body(joints, n, |joint| &joint.reaction));
            let impulse = moving.inertia.momentum(&moving.kick);
            moving.struck = moving.struck.after(&impulse, moving.inertia.arm);
        }
    }

    /// Finds twists and momenta of a step, beginning with the twists that the step holds.
    pub(crate) fn integrate(&self, state: &MechanismState, step: &mut Step) {
        self.configure_start(state, step);
        self.react(state, step);
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            self.configure(state, step);
            let change = self.move_within(step);
            if change <= CONVERGED || change >= last && change < STAGNANT {
                break;
            }
            last = change;
        }
        for moving in &mut step.bodies {
            let Impulses { gravity, joint, drive, .. } = moving.impulses;
            moving.end = moving.struck.after(&(gravity + joint + drive), moving.inertia.arm);
        }
    }

    /// Attitudes, mobilities, loads and rows of the joints at the start of the step.
    fn configure_start(&self, state: &MechanismState, step: &mut Step) {
        let conditions = step.conditions;
        for ((body, now), moving) in self.bodies().iter().zip(&state.bodies).zip(&mut step.bodies) {
            moving.configuration = Configuration::new(&now.pose, &Twist::ZERO, conditions.dt);
            moving.tilt_axis = now.tilt_axis;
            moving.inertia = moving.configuration.mean_inertia(&body.inertia);
            moving.axes = axes(moving, now);
            moving.mobility = mobility(body, moving);
            moving.impulses.load = load(body, &moving.axes, &conditions) + drag(body, now, conditions.dt);
        }
        self.find_rows(step);
    }

    /// Attitudes, mobilities, gravity and rows of the joints in the mean configuration, for the twists so
    /// far.
    fn configure(&self, state: &MechanismState, step: &mut Step) {
        let Conditions { dt, gravity, .. } = step.conditions;
        for ((body, now), moving) in self.bodies().iter().zip(&state.bodies).zip(&mut step.bodies) {
            moving.configuration = Configuration::new(&now.pose, &moving.twist, dt);
            let end = &moving.configuration.end;
            moving.tilt_axis =
                if body.motion[3].is_fixed() { now.tilt_axis } else { gimbal::tilt_axis(end, now.tilt_axis) };
            moving.inertia = moving.configuration.mean_inertia(&body.inertia);
            moving.axes = axes(moving, now);
            moving.mobility = mobility(body, moving);
            let lifted = moving.configuration.mean(body.fluid.centre);
            moving.impulses.gravity = Wrench::at(moving.inertia.arm, body.inertia.mass * dt * gravity)
                + body.fluid.buoyancy(lifted, dt, gravity);
        }
        self.find_rows(step);
    }

    fn find_rows(&self, step: &mut Step) {
        let bodies = &step.bodies;
        for (joint, moving) in self.joints().iter().zip(&mut step.joints) {
            let where_is =
                |body: Option<usize>| body.map_or(&Configuration::GROUND, |n| &bodies[n].configuration);
            moving.rows = joint.rows(joint.bodies().map(where_is), step.conditions.dt);
        }
    }

    /// The start of the step: contact, loads and changes of prescribed speeds, and what joints and supports
    /// answer.
    fn react(&self, state: &MechanismState, step: &mut Step) {
        let Step { bodies, joints, system, conditions, .. } = step;
        for ((body, now), moving) in self.bodies().iter().zip(&state.bodies).zip(bodies.iter_mut()) {
            let change = std::array::from_fn(|n| moving.speeds[n] - now.speeds[n]);
            let jump = match body.steering {
                Some(Steering::Coupled { acceleration, .. }) => conditions.dt * acceleration,
                _ => body.driven(&change, &moving.axes),
            };
            let met = moving.impulses.contact + moving.impulses.touch + moving.impulses.load;
            moving.kick = respond(moving, &met, &jump);
        }
        system.factor(bodies, joints, Answer::Rigid);
        let sought = rows(joints).map(|(joint, row)| -joint.velocity(row, |body| bodies[body].kick));
        share_out(system.solve(sought), joints, |joint| &mut joint.reaction);
        for (n, ((body, now), moving)) in self.bodies().iter().zip(&state.bodies).zip(bodies).enumerate() {
            let reaction = on_body(joints, n, |joint| &joint.reaction);
            moving.kick += moving.mobility.response(&reaction);
            let Impulses { contact, touch, load, .. } = moving.impulses;
            let free = contact + touch + load + reaction;
            moving.impulses.joint_reaction = reaction;
            moving.impulses.drive_reaction = support(body, moving, &moving.kick, &free);
            let all = free + moving.impulses.drive_reaction;
            moving.struck = now.momentum.after(&all, moving.inertia.arm);
            moving.met = met(body, moving, &now.momentum);
        }
    }

    /// Within the step: gravity, gyroscopic terms, joints and supports. Returns the relative change of the
    /// twists.
    fn move_within(&self, step: &mut Step) -> f64 {
        let Step { bodies, joints, system, .. } = step;
        for (body, moving) in self.bodies().iter().zip(bodies.iter_mut()) {
            let driven = match body.steering {
                Some(Steering::Coupled { .. }) => moving.before + moving.kick,
                _ => body.driven(&moving.speeds, &moving.axes),
            };
            moving.next = respond(moving, &mean_momentum(moving), &driven);
        }
        system.factor(bodies, joints, Answer::All);
        let sought =
            rows(joints).map(|(joint, row)| row.bias - joint.velocity(row, |body| bodies[body].next));
        share_out(system.solve(sought), joints, |joint| &mut joint.within);
        let (mut change, mut size) = (0.0_f64, 0.0_f64);
        for (n, (body, moving)) in self.bodies().iter().zip(bodies).enumerate() {
            let half = on_body(joints, n, |joint| &joint.within);
            moving.next += moving.mobility.response(&half);
            let free = mean_momentum(moving) + half;
            moving.impulses.joint = 2.0 * half;
            moving.impulses.drive = 2.0 * support(body, moving, &moving.next, &free);
            let within = moving.impulses.gravity + moving.impulses.joint + moving.impulses.drive;
            moving.torque = within.moment_about(moving.inertia.arm);
            let length = size_of_motion(body);
            let speed = |twist: &Twist| twist.linear.length() / length + twist.angular.length();
            change = change.max(speed(&(moving.next - moving.twist)));
            size = size.max(speed(&moving.next));
            moving.twist = moving.next;
        }
        if size > 0.0 { change / size } else { change }
    }
}

/// Mobility in the configuration that a body has so far.
fn mobility(body: &Body, moving: &MovingBody) -> Mobility {
    match body.steering {
        Some(Steering::Coupled { mobility, .. }) => mobility,
        _ => Mobility::new(&moving.inertia, &Directions::new(&body.motion, &moving.axes)),
    }
}

/// Mean axes of the rotational freedoms over the step.
fn axes(moving: &MovingBody, now: &BodyState) -> Axes {
    let configuration = &moving.configuration;
    gimbal::mean_axes(&configuration.start, now.tilt_axis, &configuration.end, moving.tilt_axis)
}

/// Impulse of the loads: each along the axis of its freedom.
fn load(body: &Body, axes: &Axes, conditions: &Conditions) -> Wrench {
    let middle = conditions.time + 0.5 * conditions.dt;
    let mut sum = match body.steering {
        Some(Steering::Loaded(load)) => conditions.dt * load,
        _ => Wrench::ZERO,
    };
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

/// Impulse of the fluid's drag, at the velocity of the step before.
fn drag(body: &Body, now: &BodyState, dt: f64) -> Wrench {
    if body.fluid.drag == 0.0 {
        return Wrench::ZERO;
    }
    let arm = now.pose.axes() * body.fluid.centre;
    Wrench::at(arm, dt * body.fluid.drag(now.twist.at(arm)))
}

/// The twist that a momentum makes of the free motions beside a prescribed twist.
fn respond(moving: &MovingBody, momentum: &Wrench, driven: &Twist) -> Twist {
    *driven + moving.mobility.response(&(*momentum - moving.inertia.momentum(driven)))
}

/// The mean momentum of the step, about the reference point, without joints and supports: that at the start,
/// after the impulses there, half of gravity's, and the gyroscopic remainder −¼ w × T of the midpoint rule.
fn mean_momentum(moving: &MovingBody) -> Wrench {
    let gyroscopic = Wrench::couple(-0.25 * moving.configuration.turn().cross(moving.torque));
    moving.struck.about_reference(moving.inertia.arm) + 0.5 * moving.impulses.gravity + gyroscopic
}

/// What drives and supports add to an impulse for the body to take on a twist. They do not act along free
/// directions: there the round-off is removed, so that momentum in them is kept. Another program that moves
/// the body takes up all.
fn support(body: &Body, moving: &MovingBody, twist: &Twist, free: &Wrench) -> Wrench {
    if body.steering.is_some_and(|steering| steering.replaces_motion()) {
        return Wrench::ZERO - *free;
    }
    if body.moves_freely() {
        return Wrench::ZERO;
    }
    let mut support = moving.inertia.momentum(twist) - *free;
    for (axis, motion) in body.motion[..3].iter().enumerate() {
        if motion.is_free() {
            support.force[axis] = 0.0;
        }
    }
    if body.rotates_freely() {
        support.moment = DVec3::ZERO;
    }
    for (axis, motion) in moving.axes.iter().zip(&body.motion[3..]) {
        if motion.is_free() {
            support.moment -= support.moment.dot(*axis) / axis.length_squared() * *axis;
        }
    }
    support
}

/// The twist that the impulses at the start of the step meet: the mean of those of the momenta before and
/// after them. A body without mass or tensor has the twists of the step instead.
fn met(body: &Body, moving: &MovingBody, before: &Momentum) -> Twist {
    let mut mean = 0.5 * (moving.before + moving.twist);
    let of_both = 0.5 * (before.angular + moving.struck.angular);
    let start = moving.configuration.start;
    let inverse = body.inertia.inverse_tensor();
    if inverse != glam::DMat3::ZERO {
        mean.angular = start * (inverse * (start.transpose() * of_both));
    }
    if body.inertia.mass > 0.0 {
        let of_centre = (0.5 / body.inertia.mass) * (before.linear + moving.struck.linear);
        mean.linear = of_centre - mean.angular.cross(moving.inertia.arm);
    }
    mean
}

/// Radius of gyration [m], to compare velocities with rates of rotation; 1 for a body without one.
fn size_of_motion(body: &Body) -> f64 {
    let tensor = body.inertia.tensor;
    let radius = ((tensor.x_axis.x + tensor.y_axis.y + tensor.z_axis.z) / body.inertia.mass).sqrt();
    if radius > 0.0 && radius.is_finite() { radius } else { 1.0 }
}
