//! A free asymmetric top (Landau & Lifshitz, Mechanics, 3rd ed. 1976, §37).
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{Crossings, Largest, below, elliptic_k, energy, run};
use glam::{DQuat, DVec3};
use mechanics::{Body, Inertia, Mechanism, MechanismState, Pose, Twist};

const MOMENTS: DVec3 = DVec3::new(1.0, 2.0, 2.5);

fn top(angular: DVec3) -> (Mechanism, MechanismState) {
    let mechanism = Mechanism::new(vec![Body::free(Inertia::principal(1.0, MOMENTS))], vec![]).unwrap();
    let rotation = DQuat::from_rotation_z(0.4) * DQuat::from_rotation_x(-1.1);
    let pose = Pose { position: DVec3::new(1.0, -2.0, 0.5), rotation };
    let linear = DVec3::new(0.3, 0.1, -0.2);
    let state = mechanism.state(&[(pose, Twist { linear, angular: rotation * angular })]);
    (mechanism, state)
}

/// Energy and angular momentum over 25 revolutions of 400 steps: the scheme conserves both exactly.
#[test]
fn energy_and_angular_momentum_are_conserved() {
    for angular in [DVec3::new(1.0, 0.3, 0.2), DVec3::new(0.1, 1.0, 0.1), DVec3::new(0.2, -0.3, 1.0)] {
        let (mechanism, mut state) = top(angular);
        let about = DVec3::new(3.0, 4.0, 5.0);
        let start = energy(&mechanism, &state, DVec3::ZERO);
        let momentum = mechanism.angular_momentum(&state, about);
        let dt = std::f64::consts::TAU / angular.length() / 400.0;
        let (mut of_energy, mut of_momentum) = (Largest::default(), Largest::default());
        run((&mechanism, &mut state), DVec3::ZERO, (dt, 10_000), |_, now, _| {
            of_energy.add(energy(&mechanism, now, DVec3::ZERO) / start - 1.0);
            of_momentum.add((mechanism.angular_momentum(now, about) - momentum).length() / momentum.length());
        });
        below("energy", of_energy.0, 1e-12);
        // The round-off of the position, over 50 m of travel.
        below("angular momentum", of_momentum.0, 1e-11);
    }
}

/// Interval of the flips about the unstable middle axis [s]: 2 K(k)/λ.
fn flip(angular: DVec3) -> f64 {
    let (a, b, c) = (MOMENTS.x, MOMENTS.y, MOMENTS.z);
    let twice_energy = (MOMENTS * angular * angular).element_sum();
    let square = (MOMENTS * angular).length_squared();
    let (rate, k) = if square > twice_energy * b {
        let rate = ((c - b) * (square - twice_energy * a) / (a * b * c)).sqrt();
        (rate, ((b - a) * (twice_energy * c - square) / ((c - b) * (square - twice_energy * a))).sqrt())
    } else {
        let rate = ((b - a) * (twice_energy * c - square) / (a * b * c)).sqrt();
        (rate, ((c - b) * (square - twice_energy * a) / ((b - a) * (twice_energy * c - square))).sqrt())
    };
    2.0 * elliptic_k(k) / rate
}

/// The flips about the middle axis (Dzhanibekov): their interval, to second order in the step.
#[test]
fn the_middle_axis_flips_at_the_right_intervals() {
    let angular = DVec3::new(0.02, 3.0, 0.01);
    let errors = [2000, 4000].map(|per_flip| {
        let (mechanism, mut state) = top(angular);
        let exact = flip(angular);
        let (mut crossings, mut of_energy) = (Crossings::default(), Largest::default());
        let start = energy(&mechanism, &state, DVec3::ZERO);
        run(
            (&mechanism, &mut state),
            DVec3::ZERO,
            (exact / per_flip as f64, 9 * per_flip),
            |time, now, _| {
                let body = &now.bodies[0];
                crossings.add(time, (body.pose.rotation.inverse() * body.momentum.angular).y);
                of_energy.add(energy(&mechanism, now, DVec3::ZERO) / start - 1.0);
            },
        );
        below("energy", of_energy.0, 1e-12);
        crossings.period() / (2.0 * exact) - 1.0
    });
    eprintln!("interval of the flips: relative errors {errors:?}");
    below("interval of the flips", errors[1].abs(), 1e-4);
    below("order 2", (errors[0] / errors[1] - 4.0).abs(), 0.2);
}
