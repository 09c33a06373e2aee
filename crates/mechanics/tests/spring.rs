//! Springs with dampers, and cables.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{Crossings, GRAVITY, Largest, below, run};
use glam::DVec3;
use mechanics::joint::Spring;
use mechanics::{Body, Conditions, Inertia, Mechanism, MechanismState, Pose, Step, Twist};
use std::sync::Arc;

const STIFFNESS: f64 = 200.0;

/// Two spheres of 2 kg and 3 kg; the spring holds them at points of their surfaces.
fn dumbbell(stretch: f64, damping: f64) -> (Mechanism, MechanismState) {
    let bodies = vec![Body::free(Inertia::sphere(2.0, 0.1)), Body::free(Inertia::sphere(3.0, 0.1))];
    let points = [DVec3::new(0.1, 0.0, 0.0), DVec3::new(-0.1, 0.0, 0.0)];
    let bodies_of = [Some(0), Some(1)];
    let spring =
        Spring { bodies: bodies_of, points, stiffness: STIFFNESS, damping, length: 0.5, is_cable: false };
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
    below("force of the spring", (state.joints[0].impulses[0] / dt + 10.0).abs(), 1e-9);
}

#[test]
fn a_cable_hangs_slack_until_it_is_taut() {
    const LENGTH: f64 = 0.4;
    let cable = Spring {
        bodies: [None, Some(0)],
        points: [DVec3::ZERO; 2],
        stiffness: 1e4,
        damping: 0.0,
        length: LENGTH,
        is_cable: true,
    };
    let mechanism =
        Mechanism::new(vec![Body::free(Inertia::sphere(2.0, 0.1))], vec![Arc::new(cable)]).unwrap();
    let mut state = mechanism.state(&[(Pose::IDENTITY, Twist::ZERO)]);
    let mut bounces = Largest::default();
    let mut energies = Largest::default();
    run((&mechanism, &mut state), GRAVITY, (1e-5, 60_000), |time, now, _| {
        let z = now.bodies[0].pose.position.z;
        if -z < LENGTH {
            let falls = time < (2.0 * LENGTH / 9.81_f64).sqrt();
            if falls {
                bounces.add((z + 0.5 * 9.81 * time * time) / LENGTH);
            }
        }
        energies.add(common::energy(&mechanism, now, GRAVITY) / (2.0 * 9.81 * LENGTH));
    });
    below("free fall", bounces.0, 1e-9);
    // The step in which it becomes taut is computed without it: v Δt more of extension.
    below("energy of the bounce", energies.0, 1e-3);
    let pull = state.joints[0].on_second.force;
    assert!(pull.z > 0.0 && pull.x == 0.0, "it pulls upwards: {pull}");
}
