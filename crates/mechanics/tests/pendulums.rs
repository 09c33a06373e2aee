//! Pendulums on hinges: compound pendulum, double pendulum, chain.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{Crossings, GRAVITY, Largest, below, elliptic_k, energy, run};
use glam::{DQuat, DVec3};
use mechanics::joint::{Hinge, Joint};
use mechanics::{Body, Inertia, Mechanism, MechanismState, Motion, Pose, Twist};
use std::sync::Arc;

const FIXED: Motion = Motion::Fixed;

const MASS: f64 = 1.5;
const LENGTH: f64 = 0.8;

/// Moment of inertia of a rod about its middle, across it [kg m²].
fn across() -> f64 {
    rod().tensor.y_axis.y
}

fn rod() -> Inertia {
    Inertia::cuboid(MASS, DVec3::new(0.05, 0.03, LENGTH))
}

/// Rods that hang from hinges along y, each turned by an angle from the vertical; reference points in the
/// middle.
fn chain(angles: &[f64]) -> (Mechanism, MechanismState, Vec<[Option<usize>; 2]>) {
    let mut hinge = DVec3::new(0.3, -0.2, 1.0);
    let (mut starts, mut joints, mut ends) =
        (Vec::<(Pose, Twist)>::new(), Vec::<Arc<dyn Joint>>::new(), vec![]);
    for (n, angle) in angles.iter().enumerate() {
        let rotation = DQuat::from_rotation_y(*angle);
        let half = rotation * DVec3::new(0.0, 0.0, -0.5 * LENGTH);
        let pose = Pose { position: hinge + half, rotation };
        let above = starts.last().map_or(Pose::IDENTITY, |start| start.0);
        let bodies = [n.checked_sub(1), Some(n)];
        joints.push(Arc::new(Hinge::at(hinge, DVec3::Y, bodies, [&above, &pose])));
        starts.push((pose, Twist::ZERO));
        ends.push(bodies);
        hinge += 2.0 * half;
    }
    let mechanism = Mechanism::new(vec![Body::free(rod()); angles.len()], joints).unwrap();
    let state = mechanism.state(&starts);
    (mechanism, state, ends)
}

/// Largest distance between the ends that the hinges hold together [m].
fn gap(state: &MechanismState, ends: &[[Option<usize>; 2]]) -> f64 {
    let end = |body: usize, z: f64| state.bodies[body].pose.point(DVec3::new(0.0, 0.0, z));
    let each = ends.iter().map(|bodies| {
        let above = bodies[0].map_or(DVec3::new(0.3, -0.2, 1.0), |body| end(body, -0.5 * LENGTH));
        above.distance(end(bodies[1].unwrap(), 0.5 * LENGTH))
    });
    each.fold(0.0, f64::max)
}

/// Angle of a rod from the vertical [rad].
fn angle(state: &MechanismState, rod: usize) -> f64 {
    let down = state.bodies[rod].pose.rotation * DVec3::NEG_Z;
    (-down.x).atan2(-down.z)
}

/// A compound pendulum released at an angle: T = 4 √(J/(m g s)) K(sin(θ/2)) (Landau & Lifshitz 1976, §11),
/// with the moment J about the hinge and the distance s from it to the centre of mass.
#[test]
fn compound_pendulum() {
    for start in [0.1, 1.5, 2.8] {
        let inertia = across() + MASS * 0.25 * LENGTH * LENGTH;
        let slow = (inertia / (MASS * 9.81 * 0.5 * LENGTH)).sqrt();
        let exact = 4.0 * slow * elliptic_k((0.5_f64 * start).sin());
        let errors = [250, 500].map(|per_swing| {
            let (mechanism, mut state, ends) = chain(&[start]);
            let first = energy(&mechanism, &state, GRAVITY);
            let lowest = MASS * 9.81 * (1.0 - 0.5 * LENGTH);
            let (mut crossings, mut error, mut gaps) =
                (Crossings::default(), Largest::default(), Largest::default());
            run(
                (&mechanism, &mut state),
                GRAVITY,
                (exact / per_swing as f64, 20 * per_swing),
                |time, now, _| {
                    error.add((energy(&mechanism, now, GRAVITY) - first) / (first - lowest));
                    gaps.add(gap(now, &ends) / LENGTH);
                    crossings.add(time, angle(now, 0));
                },
            );
            below("energy over that of the swing", error.0, 1e-10);
            below("gap", gaps.0, 1e-12);
            crossings.period() / exact - 1.0
        });
        eprintln!("{start} rad: relative errors of the period {errors:?}");
        below("period", errors[1].abs(), 1e-4);
        below("order 2", (errors[0] / errors[1] - 4.0).abs(), 0.2);
    }
}

/// The same pendulum in three descriptions: on a hinge; with a fixed reference point and only its tilt free.
#[test]
fn a_hinge_and_a_single_free_rotation_are_the_same() {
    let (mechanism, mut state, _) = chain(&[1.0]);
    // Its hinge is along y: the axle, about which it spins.
    let inertia = rod().with_centre(DVec3::new(0.0, 0.0, -0.5 * LENGTH));
    let alone = Body::new(inertia, [FIXED, FIXED, FIXED, FIXED, FIXED, Motion::FREE]);
    let other = Mechanism::new(vec![alone], vec![]).unwrap();
    let pose = Pose { position: DVec3::ZERO, rotation: DQuat::from_rotation_y(1.0) };
    let mut twin = other.state(&[(pose, Twist::ZERO)]);
    let first = energy(&other, &twin, GRAVITY);
    let (mut error, mut angles) = (Largest::default(), vec![]);
    run((&mechanism, &mut state), GRAVITY, (2e-3, 5000), |_, now, _| angles.push(angle(now, 0)));
    let mut expected = angles.into_iter();
    let mut apart = Largest::default();
    run((&other, &mut twin), GRAVITY, (2e-3, 5000), |_, now, _| {
        apart.add(angle(now, 0) - expected.next().unwrap());
        error.add((energy(&other, now, GRAVITY) - first) / first);
        assert_eq!(now.bodies[0].pose.position, DVec3::ZERO);
        assert_eq!(now.bodies[0].pose.rotation.x, 0.0);
    });
    below("difference of the angles [rad]", apart.0, 1e-9);
    below("energy", error.0, 1e-12);
}

/// A double pendulum of two equal rods: frequencies of its normal modes, ω² = (3 ∓ 6/√7) g/L for thin rods;
/// here from the quadratic of its mass and stiffness matrices (Landau & Lifshitz 1976, §23).
#[test]
fn double_pendulum_small() {
    let (inertia, s) = (across() + MASS * 0.25 * LENGTH * LENGTH, 0.5 * LENGTH);
    let (m11, m12, m22) = (inertia + MASS * LENGTH * LENGTH, MASS * LENGTH * s, inertia);
    let (k1, k2) = (MASS * 9.81 * (s + LENGTH), MASS * 9.81 * s);
    let (a, b, c) = (m11 * m22 - m12 * m12, -(m11 * k2 + m22 * k1), k1 * k2);
    for sign in [-1.0, 1.0] {
        let square = (-b + sign * (b * b - 4.0 * a * c).sqrt()) / (2.0 * a);
        let ratio = (k1 - square * m11) / (square * m12);
        let exact = std::f64::consts::TAU / square.sqrt();
        let amplitude = 1e-4 / ratio.abs().max(1.0);
        let (mechanism, mut state, ends) = chain(&[amplitude, amplitude * ratio]);
        let first = energy(&mechanism, &state, GRAVITY);
        let depth = MASS * 9.81 * (s * (1.0 - amplitude.cos()) * 3.0 + s * (1.0 - (amplitude * ratio).cos()));
        let (mut crossings, mut error, mut gaps) =
            (Crossings::default(), Largest::default(), Largest::default());
        run((&mechanism, &mut state), GRAVITY, (exact / 500.0, 10_000), |time, now, _| {
            error.add((energy(&mechanism, now, GRAVITY) - first) / depth);
            gaps.add(gap(now, &ends) / LENGTH);
            crossings.add(time, angle(now, 0));
        });
        below("energy over that of the swing", error.0, 1e-6);
        below("gap", gaps.0, 1e-12);
        below("period", (crossings.period() / exact - 1.0).abs(), 2e-5);
    }
}

/// The same at moderate and large amplitudes, where it is chaotic: energy and gap.
#[test]
fn double_pendulum_large() {
    for start in [[0.8, 1.0], [2.0, 2.5]] {
        let (mechanism, mut state, ends) = chain(&start);
        let first = energy(&mechanism, &state, GRAVITY);
        let lowest = MASS * 9.81 * (2.0 - 2.0 * LENGTH);
        let (mut error, mut gaps) = (Largest::default(), Largest::default());
        run((&mechanism, &mut state), GRAVITY, (4e-3, 10_000), |_, now, _| {
            error.add((energy(&mechanism, now, GRAVITY) - first) / (first - lowest));
            gaps.add(gap(now, &ends) / LENGTH);
        });
        below("energy over that of the swing", error.0, 1e-9);
        below("gap", gaps.0, 1e-12);
    }
}

/// A chain of twenty links, released when straight and level.
#[test]
fn a_chain_of_twenty_links_holds_together() {
    let (mechanism, mut state, ends) = chain(&[std::f64::consts::FRAC_PI_2; 20]);
    let first = energy(&mechanism, &state, GRAVITY);
    let (mut error, mut gaps) = (Largest::default(), Largest::default());
    run((&mechanism, &mut state), GRAVITY, (2e-3, 750), |_, now, _| {
        error.add((energy(&mechanism, now, GRAVITY) - first) / (20.0 * MASS * 9.81 * 8.0));
        gaps.add(gap(now, &ends) / LENGTH);
    });
    below("energy", error.0, 1e-9);
    below("gap", gaps.0, 1e-11);
}
