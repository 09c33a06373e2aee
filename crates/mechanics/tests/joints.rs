//! Sliders, friction in hinges, and what joints report.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{GRAVITY, Largest, below, energy, run};
use glam::{DQuat, DVec3};
use mechanics::joint::{Hinge, Joint, Slider};
use mechanics::{Body, Inertia, Mechanism, MechanismState, Pose, Twist};
use std::sync::Arc;

fn of(
    bodies: Vec<Body>,
    joint: impl Joint + 'static,
    start: &[(Pose, Twist)],
) -> (Mechanism, MechanismState) {
    let mechanism = Mechanism::new(bodies, vec![Arc::new(joint)]).unwrap();
    let state = mechanism.state(start);
    (mechanism, state)
}

#[test]
fn a_block_slides_down_an_incline() {
    let along = DVec3::new(3.0, 1.0, -2.0).normalize();
    let start = Pose { position: DVec3::new(0.4, -0.2, 0.3), rotation: DQuat::from_rotation_x(0.3) };
    let slider = Slider::at(start.position, along, [None, Some(0)], [&Pose::IDENTITY, &start]);
    let body = Body::free(Inertia::cuboid(2.0, DVec3::new(0.1, 0.2, 0.3)));
    let (mechanism, mut state) = of(vec![body], slider, &[(start, Twist::ZERO)]);
    run((&mechanism, &mut state), GRAVITY, (1e-3, 1000), |_, _, _| {});
    let moved = state.bodies[0].pose.position - start.position;
    below("distance", (moved.dot(along) / (0.5 * GRAVITY.dot(along)) - 1.0).abs(), 1e-12);
    below("off the axis", moved.reject_from(along).length(), 1e-12);
    below("rotation", state.bodies[0].pose.rotation.angle_between(start.rotation), 1e-7);
    let force = state.joints[0].on_second.force;
    below("force", (force + 2.0 * GRAVITY.reject_from(along)).length(), 1e-9);
}

#[test]
fn a_slider_on_a_tumbling_body_keeps_its_axis_and_energy() {
    let away = Pose::at(DVec3::new(0.3, 0.1, 0.2));
    let axis = DVec3::new(1.0, 2.0, 0.5);
    let bodies = vec![
        Body::free(Inertia::cuboid(3.0, DVec3::new(0.3, 0.2, 0.1))),
        Body::free(Inertia::cuboid(1.0, DVec3::splat(0.1))),
    ];
    let slider = Slider::at(away.position, axis, [Some(0), Some(1)], [&Pose::IDENTITY, &away]);
    let push = Twist { linear: DVec3::new(0.1, 0.0, 0.2), angular: DVec3::new(2.0, -1.0, 3.0) };
    let (mechanism, mut state) = of(bodies, slider, &[(Pose::IDENTITY, push), (away, Twist::ZERO)]);
    let first = energy(&mechanism, &state, DVec3::ZERO);
    let (mut drift, mut gained) = (Largest::default(), Largest::default());
    run((&mechanism, &mut state), DVec3::ZERO, (1e-3, 3000), |_, now, _| {
        let offset = now.bodies[0].pose.point_in_body(now.bodies[1].pose.position) - away.position;
        drift.add(offset.reject_from(axis).length());
        drift.add((now.bodies[0].pose.axes().transpose() * now.bodies[1].pose.axes() * axis - axis).length());
        gained.add(energy(&mechanism, now, DVec3::ZERO) / first - 1.0);
    });
    below("drift", drift.0, 1e-9);
    below("energy", gained.0, 1e-9);
}

/// A wheel on a fixed axle that spins at 10 rad/s, with a bearing of this torque [N m].
fn wheel(friction: f64) -> (Mechanism, MechanismState) {
    let hinge = Hinge::at(DVec3::ZERO, DVec3::Y, [None, Some(0)], [&Pose::IDENTITY; 2]);
    let body = Body::free(Inertia::sphere(2.0, 0.1));
    let spin = Twist { linear: DVec3::ZERO, angular: DVec3::Y * 10.0 };
    of(vec![body], hinge.with_friction(friction), &[(Pose::IDENTITY, spin)])
}

#[test]
fn a_drive_turns_a_wheel_with_its_torque_and_does_the_work() {
    let (torque, friction) = (0.03, 0.02);
    let inertia = Inertia::sphere(2.0, 0.1).tensor.y_axis.y;
    let hinge = Hinge::at(DVec3::ZERO, DVec3::Y, [None, Some(0)], [&Pose::IDENTITY; 2]).with_drive(torque);
    let body = || vec![Body::free(Inertia::sphere(2.0, 0.1))];
    for (hinge, net) in [(hinge, torque), (hinge.with_friction(friction), torque - friction)] {
        let (mechanism, mut state) = of(body(), hinge, &[(Pose::IDENTITY, Twist::ZERO)]);
        run((&mechanism, &mut state), DVec3::ZERO, (1e-3, 1000), |_, _, _| {});
        let rate = state.bodies[0].twist.angular.y;
        // Friction is viscous while the wheel creeps.
        below("rate", (rate / (net / inertia) - 1.0).abs(), 2e-3);
        below(
            "energy",
            (energy(&mechanism, &state, DVec3::ZERO) / (0.5 * inertia * rate * rate) - 1.0).abs(),
            2e-3,
        );
    }
}

#[test]
fn friction_in_a_hinge_stops_a_wheel_and_holds_it() {
    let torque = 0.02;
    let inertia = Inertia::sphere(2.0, 0.1).tensor.y_axis.y;
    let (mechanism, mut state) = wheel(torque);
    let stops = inertia * 10.0 / torque;
    let mut error = Largest::default();
    run((&mechanism, &mut state), DVec3::ZERO, (1e-3, 5000), |time, now, _| {
        let exact = (10.0 - torque * time / inertia).max(0.0);
        // It creeps to rest below 1e-3 rad/s.
        error.add((now.bodies[0].twist.angular.y - exact).abs() / 10.0);
    });
    assert!(stops < 5.0);
    below("rate", error.0, 2e-4);
    below("work", energy(&mechanism, &state, DVec3::ZERO), 1e-12);
    let (mechanism, mut free) = wheel(0.0);
    run((&mechanism, &mut free), DVec3::ZERO, (1e-3, 5000), |_, _, _| {});
    below("without friction", (free.bodies[0].twist.angular.y - 10.0).abs(), 1e-12);
    below("torque of a free hinge", free.joints[0].on_second.moment.length(), 1e-12);
}
