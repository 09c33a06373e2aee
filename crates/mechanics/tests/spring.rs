//! A joint that yields: that a spring with a damper is one more implementation of `Joint`.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{Crossings, Largest, below, run};
use glam::DVec3;
use mechanics::joint::{Joint, Row, Rows};
use mechanics::{
    Body, Conditions, Configuration, Inertia, Mechanism, MechanismState, Pose, Step, Twist, Wrench,
};
use std::sync::Arc;

/// A spring with a damper between points of two bodies.
#[derive(Clone, Copy, Debug)]
struct Spring {
    bodies: [Option<usize>; 2],
    points: [DVec3; 2],
    stiffness: f64,
    damping: f64,
    length: f64,
}

impl Joint for Spring {
    fn bodies(&self) -> [Option<usize>; 2] {
        self.bodies
    }

    /// The change of the length in a step is Δt J u exactly, and the force that of the mean length.
    fn rows(&self, [first, second]: [&Configuration; 2], dt: f64) -> Rows {
        let start = first.point_at_start(self.points[0]) - second.point_at_start(self.points[1]);
        let end = first.point_at_end(self.points[0]) - second.point_at_end(self.points[1]);
        let along = (start + end) / (start.length() + end.length());
        let arms = [first.mean(self.points[0]), second.mean(self.points[1])];
        let resistance = 0.5 * self.stiffness * dt + self.damping;
        let mut rows = Rows::default();
        rows.push(Row {
            wrench: [Wrench::at(arms[0], along), Wrench::at(arms[1], -along)],
            bias: -self.stiffness * (start.length() - self.length) / resistance,
            compliance: 2.0 / (dt * resistance),
        });
        rows
    }

    fn energy(&self, [first, second]: [&Configuration; 2]) -> f64 {
        let length = first.point_at_start(self.points[0]).distance(second.point_at_start(self.points[1]));
        0.5 * self.stiffness * (length - self.length).powi(2)
    }
}

const STIFFNESS: f64 = 200.0;

/// Two spheres of 2 kg and 3 kg; the spring holds them at points of their surfaces.
fn dumbbell(stretch: f64, damping: f64) -> (Mechanism, MechanismState) {
    let bodies = vec![Body::free(Inertia::sphere(2.0, 0.1)), Body::free(Inertia::sphere(3.0, 0.1))];
    let points = [DVec3::new(0.1, 0.0, 0.0), DVec3::new(-0.1, 0.0, 0.0)];
    let spring = Spring { bodies: [Some(0), Some(1)], points, stiffness: STIFFNESS, damping, length: 0.5 };
    let mechanism = Mechanism::new(bodies, vec![Arc::new(spring)]).unwrap();
    let right = Pose::at(DVec3::new(0.7 + stretch, 0.0, 0.0));
    let state = mechanism.state(&[(Pose::IDENTITY, Twist::ZERO), (right, Twist::ZERO)]);
    (mechanism, state)
}

#[test]
fn it_swings_at_its_frequency() {
    let (mechanism, mut state) = dumbbell(0.05, 0.0);
    let exact = std::f64::consts::TAU / (STIFFNESS / 1.2_f64).sqrt();
    let mut crossings = Crossings::default();
    run((&mechanism, &mut state), DVec3::ZERO, (exact / 400.0, 8000), |time, now, _| {
        crossings.add(time, now.bodies[1].pose.position.x - now.bodies[0].pose.position.x - 0.7);
    });
    // The midpoint rule: 1 + (ω Δt)²/12.
    below("period", (crossings.period() / exact - 1.0).abs(), 3e-5);
}

#[test]
fn it_conserves_energy_in_any_motion() {
    let (mechanism, mut state) = dumbbell(0.2, 0.0);
    state.bodies[0] = mechanism.bodies()[0].state(
        Pose::IDENTITY,
        Twist { linear: DVec3::new(0.0, 1.0, 0.5), angular: DVec3::new(1.0, 5.0, -3.0) },
    );
    let first = common::energy(&mechanism, &state, DVec3::ZERO);
    let mut error = Largest::default();
    run((&mechanism, &mut state), DVec3::ZERO, (2e-3, 5000), |_, now, _| {
        error.add(common::energy(&mechanism, now, DVec3::ZERO) / first - 1.0);
    });
    below("energy", error.0, 1e-11);
}

#[test]
fn its_damper_and_contact_balance() {
    let (mechanism, mut state) = dumbbell(0.0, 3.0);
    let (dt, mut step) = (1e-3, Step::default());
    // A constant push on both ends stretches it to rest at F/k.
    for n in 0..20_000 {
        mechanism.predict(&state, &Conditions { time: n as f64 * dt, dt, gravity: DVec3::ZERO }, &mut step);
        step.apply(0, DVec3::ZERO, DVec3::new(-10.0 * dt, 0.0, 0.0));
        step.apply(1, DVec3::ZERO, DVec3::new(10.0 * dt, 0.0, 0.0));
        step.relax_joints();
        mechanism.advance(&mut state, &mut step);
    }
    let stretch = state.bodies[1].pose.position.x - state.bodies[0].pose.position.x - 0.7;
    below("stretch at rest", (stretch - 10.0 / STIFFNESS).abs(), 1e-12);
    below(
        "force of the spring",
        (state.joints[0][0] / dt + 10.0).abs().min((state.joints[0][0] / dt - 10.0).abs()),
        1e-9,
    );
}
