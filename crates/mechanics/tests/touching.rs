//! Bodies that touch: impacts, sliding, a stack, Newton's cradle.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{GRAVITY, Largest, below, energy, run};
use glam::{DQuat, DVec3};
use mechanics::joint::{Hinge, Joint};
use mechanics::{Body, Inertia, Mechanism, MechanismState, Motion, Pair, Pose, Surfaces, Touch, Twist};
use std::sync::Arc;

/// Two balls.
#[derive(Debug)]
struct Balls {
    bodies: [usize; 2],
    radius: f64,
    surfaces: Surfaces,
}

impl Pair for Balls {
    fn bodies(&self) -> [usize; 2] {
        self.bodies
    }

    fn surfaces(&self) -> Surfaces {
        self.surfaces
    }

    fn touches(&self, poses: [&Pose; 2], _: [&Twist; 2], _: f64, found: &mut Vec<Touch>) {
        let between = poses[1].position - poses[0].position;
        let (normal, gap) = (between.normalize(), between.length() - 2.0 * self.radius);
        if gap < 0.1 * self.radius {
            found.push(Touch { arms: [self.radius * normal, -self.radius * normal], normal, gap });
        }
    }
}

/// The lower corners of a block over the upper face of another; a ball is a block with one corner.
#[derive(Debug)]
struct OnTop {
    bodies: [usize; 2],
    /// Height of the face above the reference point of the lower body [m].
    top: f64,
    /// Corners of the upper body, about its reference point [m].
    corners: Vec<DVec3>,
    surfaces: Surfaces,
}

impl Pair for OnTop {
    fn bodies(&self) -> [usize; 2] {
        self.bodies
    }

    fn surfaces(&self) -> Surfaces {
        self.surfaces
    }

    fn touches(&self, [below, above]: [&Pose; 2], _: [&Twist; 2], _: f64, found: &mut Vec<Touch>) {
        let normal = below.axes() * DVec3::Z;
        for corner in &self.corners {
            let arm = above.axes() * *corner;
            let from = above.position + arm - below.position;
            let gap = normal.dot(from) - self.top;
            if gap < 0.01 {
                found.push(Touch { arms: [from - gap * normal, arm], normal, gap });
            }
        }
    }
}

const FIXED: [Motion; 6] = [const { Motion::Fixed }; 6];

fn ball(mass: f64, radius: f64) -> Inertia {
    let tensor = 0.4 * mass * radius * radius;
    Inertia { mass, tensor: glam::DMat3::from_diagonal(DVec3::splat(tensor)), ..Inertia::NONE }
}

fn at(x: f64, z: f64) -> Pose {
    Pose::at(DVec3::new(x, 0.0, z))
}

fn corners(size: DVec3) -> Vec<DVec3> {
    let half = 0.5 * size;
    [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)]
        .map(|(x, y)| DVec3::new(x * half.x, y * half.y, -half.z))
        .to_vec()
}

#[test]
fn two_balls_part_as_their_restitution_says() {
    for (restitution, masses) in [(1.0, [2.0, 2.0]), (0.5, [1.0, 3.0]), (0.0, [5.0, 0.1])] {
        let bodies = masses.map(|mass| Body::free(ball(mass, 0.1))).to_vec();
        let surfaces = Surfaces { friction: 0.0, restitution };
        let pair = Arc::new(Balls { bodies: [0, 1], radius: 0.1, surfaces });
        let mechanism = Mechanism::new(bodies, vec![]).unwrap().touching(vec![pair]);
        let speed = |u: f64| Twist { linear: DVec3::new(u, 0.0, 0.0), angular: DVec3::ZERO };
        let mut state = mechanism.state(&[(at(0.0, 0.0), speed(1.0)), (at(0.25, 0.0), speed(-0.5))]);
        run((&mechanism, &mut state), DVec3::ZERO, (1e-3, 200), |_, _, _| {});
        let [m, n] = masses;
        let (centre, parting) = ((m - 0.5 * n) / (m + n), restitution * 1.5);
        let expected = [centre - n / (m + n) * parting, centre + m / (m + n) * parting];
        for (body, expected) in state.bodies.iter().zip(expected) {
            below("velocity", body.twist.linear.x - expected, 1e-12);
        }
    }
}

#[test]
fn oblique_impacts_with_friction_keep_momentum_and_gain_no_energy() {
    let bodies = vec![Body::free(ball(1.0, 0.1)), Body::free(ball(2.0, 0.1))];
    let surfaces = Surfaces { friction: 0.3, restitution: 0.8 };
    let pair = Arc::new(Balls { bodies: [0, 1], radius: 0.1, surfaces });
    let mechanism = Mechanism::new(bodies, vec![]).unwrap().touching(vec![pair]);
    let first = Twist { linear: DVec3::new(1.0, 0.0, 0.2), angular: DVec3::new(1.0, -5.0, 2.0) };
    let mut state =
        mechanism.state(&[(at(0.0, 0.0), first), (Pose::at(DVec3::new(0.25, 0.05, 0.06)), Twist::ZERO)]);
    let momenta = |state: &MechanismState| {
        (mechanism.linear_momentum(state), mechanism.angular_momentum(state, DVec3::ONE))
    };
    let (before, had) = (momenta(&state), mechanism.kinetic_energy(&state));
    let mut work = 0.0;
    run((&mechanism, &mut state), DVec3::ZERO, (1e-3, 300), |_, _, step| {
        work += step.work(0).touch + step.work(1).touch;
    });
    let (after, has) = (momenta(&state), mechanism.kinetic_energy(&state));
    below("momentum", (after.0 - before.0).length(), 1e-12);
    // The place of contact is a gap away from the surface of one of them: by that much the moments differ.
    below("angular momentum", (after.1 - before.1).length(), 1e-4);
    below("energy and work", has - had - work, 1e-12);
    assert!(has < 0.95 * had && state.bodies[1].twist.linear.x > 0.3);
}

#[test]
fn a_ball_rebounds_to_the_square_of_its_restitution() {
    let (dt, height) = (1e-4, 0.5);
    for restitution in [0.9, 0.5] {
        let surfaces = Surfaces { friction: 0.5, restitution };
        let lowest = vec![DVec3::new(0.0, 0.0, -0.1)];
        let pair = Arc::new(OnTop { bodies: [0, 1], top: 0.0, corners: lowest, surfaces });
        let bodies = vec![Body::new(Inertia::NONE, FIXED), Body::free(ball(1.0, 0.1))];
        let mechanism = Mechanism::new(bodies, vec![]).unwrap().touching(vec![pair]);
        let mut state =
            mechanism.state(&[(Pose::IDENTITY, Twist::ZERO), (at(0.0, 0.1 + height), Twist::ZERO)]);
        let (mut lowest, mut highest, mut fell) = (f64::INFINITY, 0.0_f64, false);
        let until = 0.319 * (1.0 + 2.0 * restitution);
        run((&mechanism, &mut state), GRAVITY, (dt, (until / dt) as usize), |_, state, _| {
            let z = state.bodies[1].pose.position.z - 0.1;
            fell |= state.bodies[1].twist.linear.z > 0.0;
            lowest = lowest.min(z);
            highest = if fell { highest.max(z) } else { highest };
        });
        below("overlap", lowest.min(0.0), 1e-12);
        // It turns round up to a step before it touches.
        let (rebound, way) = (restitution * restitution * height, (2.0 * 9.81 * height).sqrt() * dt);
        below("rebound", highest / rebound - 1.0, 1.5 * way / rebound);
    }
}

#[test]
fn a_block_slides_down_an_incline_or_stays() {
    let (angle, size, dt) = (0.5_f64, DVec3::new(0.3, 0.2, 0.1), 1e-3);
    let rotation = DQuat::from_rotation_y(angle);
    for (friction, stays) in [(0.3, false), (0.0, false), (0.6, true)] {
        let surfaces = Surfaces { friction, restitution: 0.0 };
        let pair = Arc::new(OnTop { bodies: [0, 1], top: 0.0, corners: corners(size), surfaces });
        let bodies = vec![Body::new(Inertia::NONE, FIXED), Body::free(Inertia::cuboid(2.0, size))];
        let mechanism = Mechanism::new(bodies, vec![]).unwrap().touching(vec![pair]);
        let start = Pose { position: rotation * DVec3::new(0.0, 0.0, 0.05), rotation };
        let ground = Pose { position: DVec3::ZERO, rotation };
        let mut state = mechanism.state(&[(ground, Twist::ZERO), (start, Twist::ZERO)]);
        let mut work = 0.0;
        let had = energy(&mechanism, &state, GRAVITY);
        run((&mechanism, &mut state), GRAVITY, (dt, 500), |_, _, step| work += step.work(1).touch);
        let moved = rotation.inverse() * (state.bodies[1].pose.position - start.position);
        let accelerated = 9.81 * (angle.sin() - friction * angle.cos());
        let expected = if stays { 0.0 } else { 0.5 * accelerated * 0.5 * 0.5 };
        below("way", moved.x - expected, 1e-9);
        below("across", moved.y.abs().max(moved.z.abs()), 1e-9);
        below("energy", energy(&mechanism, &state, GRAVITY) - had - work, 1e-9);
    }
}

#[test]
fn a_stack_of_five_rests_on_its_weights() {
    let (size, masses) = (DVec3::new(0.2, 0.2, 0.1), [5.0, 1.0, 3.0, 0.5, 2.0]);
    let surfaces = Surfaces { friction: 0.5, restitution: 0.3 };
    let mut bodies = vec![Body::new(Inertia::NONE, FIXED)];
    let mut starts = vec![(Pose::IDENTITY, Twist::ZERO)];
    let mut pairs: Vec<Arc<dyn Pair>> = Vec::new();
    for (n, mass) in masses.iter().enumerate() {
        bodies.push(Body::free(Inertia::cuboid(*mass, size)));
        starts.push((at(0.0, 0.05 + 0.1 * n as f64), Twist::ZERO));
        let top = if n == 0 { 0.0 } else { 0.05 };
        pairs.push(Arc::new(OnTop { bodies: [n, n + 1], top, corners: corners(size), surfaces }));
    }
    let mechanism = Mechanism::new(bodies, vec![]).unwrap().touching(pairs);
    let mut state = mechanism.state(&starts);
    let (dt, steps) = (1e-3, 1000);
    let mut fastest = Largest::default();
    run((&mechanism, &mut state), GRAVITY, (dt, steps), |_, state, _| {
        state.bodies.iter().for_each(|body| fastest.add(body.twist.linear.length()));
    });
    below("speed", fastest.0, 1e-9);
    for n in 0..5 {
        let above: f64 = masses[n..].iter().sum();
        // The velocity at the end of a step is that of half a step of fall: the first needs half the impulse.
        let carried = state.joints[n].on_second.force.z / (dt * (steps as f64 - 0.5));
        below("load", carried / (9.81 * above) - 1.0, 1e-9);
        below("place", state.bodies[n + 1].pose.position.z - starts[n + 1].0.position.z, 1e-9);
    }
}

#[test]
fn newtons_cradle_passes_an_impact_on_to_its_last_ball() {
    let (radius, length, angle) = (0.05, 0.5, 0.4_f64);
    let surfaces = Surfaces { friction: 0.0, restitution: 1.0 };
    let (mut starts, mut joints, mut pairs) =
        (Vec::new(), Vec::<Arc<dyn Joint>>::new(), Vec::<Arc<dyn Pair>>::new());
    for n in 0..5 {
        let pivot = DVec3::new(2.0 * radius * n as f64, 0.0, length);
        let rotation = DQuat::from_rotation_y(if n == 0 { angle } else { 0.0 });
        let pose = Pose { position: pivot + rotation * DVec3::new(0.0, 0.0, -length), rotation };
        joints.push(Arc::new(Hinge::at(pivot, DVec3::Y, [None, Some(n)], [&Pose::IDENTITY, &pose])));
        starts.push((pose, Twist::ZERO));
        if n > 0 {
            pairs.push(Arc::new(Balls { bodies: [n - 1, n], radius, surfaces }));
        }
    }
    let mechanism = Mechanism::new(vec![Body::free(ball(1.0, radius)); 5], joints).unwrap().touching(pairs);
    let mut state = mechanism.state(&starts);
    let had = energy(&mechanism, &state, GRAVITY);
    let height = |state: &MechanismState, n: usize| state.bodies[n].pose.position.z;
    let (mut highest, mut moved) = (0.0_f64, 0.0_f64);
    // The first falls for a quarter of a period, the last rises for another.
    run((&mechanism, &mut state), GRAVITY, (1e-4, 7400), |_, state, _| {
        highest = highest.max(height(state, 4));
        moved = (1..4).fold(moved, |most, n| most.max(height(state, n)));
    });
    let raised = length * (1.0 - angle.cos());
    below("height of the last", highest / raised - 1.0, 1e-5);
    below("height of those between", moved / raised, 1e-9);
    below("energy", energy(&mechanism, &state, GRAVITY) / had - 1.0, 1e-5);
}
