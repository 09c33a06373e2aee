//! The heavy symmetric top (Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, §5.7), with its tip
//! on a ball joint and with its reference point fixed.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{GRAVITY, Largest, below, energy, run};
use glam::{DQuat, DVec3};
use mechanics::joint::Ball;
use mechanics::{Body, Inertia, Mechanism, MechanismState, Motion, Pose, Twist};
use std::sync::Arc;

const MASS: f64 = 2.0;
/// From the tip to the centre of mass, along the body's z [m].
const ARM: f64 = 0.15;
/// Moments about the figure axis and across it, about the centre of mass [kg m²].
const ALONG: f64 = 0.01;
const ACROSS: f64 = 0.006;

/// The two descriptions: on a ball joint, with its reference point at the centre of mass; and at its fixed
/// reference point.
fn tops(tilt: f64, angular: DVec3) -> [(Mechanism, MechanismState); 2] {
    let rotation = DQuat::from_rotation_x(tilt);
    let axis = rotation * DVec3::Z;
    let inertia = Inertia::principal(MASS, DVec3::new(ACROSS, ACROSS, ALONG));
    let pose = Pose { position: ARM * axis, rotation };
    let joint = Ball::at(DVec3::ZERO, [Some(0), None], [&pose, &Pose::IDENTITY]);
    let on_joint = Mechanism::new(vec![Body::free(inertia)], vec![Arc::new(joint)]).unwrap();
    let first = on_joint.state(&[(pose, Twist { linear: angular.cross(ARM * axis), angular })]);
    let [fixed, free] = [|| Motion::Fixed, || Motion::FREE];
    let body = Body::new(
        inertia.with_centre(DVec3::new(0.0, 0.0, ARM)),
        [fixed(), fixed(), fixed(), free(), free(), free()],
    );
    let held = Mechanism::new(vec![body], vec![]).unwrap();
    let pose = Pose { position: DVec3::ZERO, rotation };
    let second = held.state(&[(pose, Twist { linear: DVec3::ZERO, angular })]);
    [(on_joint, first), (held, second)]
}

/// Figure axis in space.
fn figure_axis(state: &MechanismState) -> DVec3 {
    state.bodies[0].pose.rotation * DVec3::Z
}

/// Released with spin alone, the top nutates. Energy and vertical angular momentum are conserved exactly; the
/// axial one swings with the potential energy by ¼ Δt² ω₃ Δ(m g z), a term of second order that does not
/// grow.
#[test]
fn energy_and_both_angular_momenta_are_conserved() {
    let tilt = 0.7;
    let spin = 60.0;
    for (mechanism, mut state) in tops(tilt, spin * DVec3::new(0.0, -f64::sin(tilt), f64::cos(tilt))) {
        let first = energy(&mechanism, &state, GRAVITY);
        let vertical = mechanism.angular_momentum(&state, DVec3::ZERO).z;
        let axial = state.bodies[0].momentum.angular.dot(figure_axis(&state));
        let [mut of_energy, mut of_vertical, mut of_axial, mut nutation] =
            [(); 4].map(|()| Largest::default());
        // 33 revolutions of 300 steps.
        run(
            (&mechanism, &mut state),
            GRAVITY,
            (std::f64::consts::TAU / spin / 300.0, 10_000),
            |_, now, _| {
                of_energy.add(energy(&mechanism, now, GRAVITY) / first - 1.0);
                of_vertical.add(mechanism.angular_momentum(now, DVec3::ZERO).z / vertical - 1.0);
                of_axial.add(now.bodies[0].momentum.angular.dot(figure_axis(now)) / axial - 1.0);
                nutation.add(figure_axis(now).z.acos() - tilt);
            },
        );
        assert!(nutation.0 > 0.05, "{}", nutation.0);
        below("energy", of_energy.0, 1e-11);
        below("vertical angular momentum", of_vertical.0, 1e-11);
        below("axial angular momentum", of_axial.0, 1e-6);
    }
}

/// Steady precession: I₃ ω₃ φ̇ − I₁ φ̇² cos θ = m g s, with I₁ about the tip (Goldstein, Poole & Safko 2002,
/// §5.7).
#[test]
fn steady_precession() {
    let (tilt, precession): (f64, f64) = (0.7, 4.0);
    let transverse = ACROSS + MASS * ARM * ARM;
    // Axial angular velocity ω₃.
    let axial = (MASS * 9.81 * ARM + transverse * precession.powi(2) * tilt.cos()) / (ALONG * precession);
    let axis = DVec3::new(0.0, -tilt.sin(), tilt.cos());
    let angular = precession * (DVec3::Z - tilt.cos() * axis) + axial * axis;
    for (mechanism, start) in tops(tilt, angular) {
        let errors = [100.0, 200.0].map(|per_turn| {
            let dt = std::f64::consts::TAU / axial / per_turn;
            let mut state = start.clone();
            let (mut last, mut turned, mut nutation) = (axis, 0.0, Largest::default());
            let steps = 4000 * (per_turn / 100.0) as usize;
            run((&mechanism, &mut state), GRAVITY, (dt, steps), |_, now, _| {
                let axis = figure_axis(now);
                turned += last.truncate().angle_to(axis.truncate());
                last = axis;
                nutation.add(axis.z.acos() - tilt);
            });
            eprintln!("nutation {:.1e} rad", nutation.0);
            turned / (steps as f64 * dt) / precession - 1.0
        });
        eprintln!("relative errors of the rate of precession {errors:?}");
        below("rate of precession", errors[1].abs(), 1e-3);
        below("order 2", (errors[0] / errors[1] - 4.0).abs(), 0.3);
    }
}
