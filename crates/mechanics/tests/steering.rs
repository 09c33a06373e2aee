//! Bodies that another program steers.
#![allow(clippy::unwrap_used)] // clippy does not recognise test helpers

mod common;

use common::GRAVITY;
use glam::{DQuat, DVec3};
use mechanics::{
    Body, Conditions, Inertia, Mechanism, MechanismState, Mobility, Pose, Steering, Step, Twist, Wrench,
};

fn steered(body: Body, steering: Steering) -> Mechanism {
    Mechanism::new(vec![body], vec![]).unwrap().steered(&[Some(steering)])
}

fn at_start(mechanism: &Mechanism, twist: Twist) -> MechanismState {
    let pose = Pose { position: DVec3::ONE, rotation: DQuat::from_rotation_x(0.3) };
    let mut state = mechanism.state(&[(pose, Twist::ZERO)]);
    state.bodies[0].twist = twist;
    state.bodies[0] = mechanism.bodies()[0].taken_over(&state.bodies[0]);
    state
}

/// A step under an impulse of contact.
fn step(mechanism: &Mechanism, state: &mut MechanismState, impulse: Wrench) -> Step {
    let mut step = Step::default();
    mechanism.predict(state, &Conditions { time: 0.0, dt: 0.01, gravity: GRAVITY }, &mut step);
    step.apply_wrench(0, &impulse);
    mechanism.advance(state, &mut step);
    step
}

const IMPULSE: Wrench = Wrench { force: DVec3::new(1.0, 2.0, 3.0), moment: DVec3::new(0.1, -0.2, 0.3) };

fn near(a: &Twist, b: &Twist) {
    let apart = (a.linear - b.linear).length() + (a.angular - b.angular).length();
    assert!(apart < 1e-14, "{a:?} {b:?}");
}

#[test]
fn a_prescribed_twist_is_kept_whatever_acts() {
    let twist = Twist { linear: DVec3::new(0.1, 0.2, -0.3), angular: DVec3::new(1.0, 2.0, 3.0) };
    let mechanism = steered(Body::free(Inertia::sphere(2.0, 0.1)), Steering::Prescribed(twist));
    let mut state = at_start(&mechanism, Twist::ZERO);
    let taken = step(&mechanism, &mut state, IMPULSE);
    near(&state.bodies[0].twist, &twist);
    assert!(state.bodies[0].pose.position.distance(DVec3::ONE + 0.01 * twist.linear) < 1e-15);
    // The other program takes up what contact does; no energy stays here.
    assert_eq!(taken.impulses(0).drive_reaction, -1.0 * IMPULSE);
    assert_eq!(taken.work(0).total(), 0.0);
    assert_eq!(mechanism.kinetic_energy(&state), 0.0);
}

#[test]
fn a_coupled_body_yields_as_its_mobility_says() {
    let mut rows = [[0.0; 6]; 6];
    for (n, row) in rows.iter_mut().enumerate() {
        row[n] = 1.0 + n as f64;
    }
    (rows[0][4], rows[4][0]) = (0.5, 0.5);
    let mobility = Mobility::of(&rows).unwrap();
    let before = Twist { linear: DVec3::new(0.1, 0.0, -0.3), angular: DVec3::new(0.0, 2.0, 0.0) };
    let acceleration = Twist { linear: DVec3::new(0.0, 1.0, -9.81), angular: DVec3::X };
    let mechanism =
        steered(Body::free(Inertia::sphere(2.0, 0.1)), Steering::Coupled { mobility, acceleration });
    let mut state = at_start(&mechanism, before);
    let taken = step(&mechanism, &mut state, IMPULSE);
    near(&state.bodies[0].twist, &(before + 0.01 * acceleration + mobility.response(&IMPULSE)));
    assert_eq!(taken.work(0).total(), 0.0);
    let met = 0.5 * (before + state.bodies[0].twist);
    assert!((taken.work(0).contact - IMPULSE.dot(&met)).abs() < 1e-14);
}

#[test]
fn a_load_acts_on_a_body_that_moves_by_itself() {
    let load = Wrench { force: DVec3::new(3.0, 0.0, 0.0), moment: DVec3::ZERO };
    let body = Body::free(Inertia::sphere(2.0, 0.1));
    let mechanism = steered(body, Steering::Loaded(load));
    let mut state = at_start(&mechanism, Twist::ZERO);
    step(&mechanism, &mut state, Wrench::ZERO);
    assert!((state.bodies[0].twist.linear.x - 0.015).abs() < 1e-15);
}

/// What a case holds stays held, and the rest of the mechanism answers to that.
#[test]
fn a_mobility_is_held_along_twists() {
    let mut rows = [[0.0; 6]; 6];
    for (n, row) in rows.iter_mut().enumerate() {
        row[n] = 1.0;
    }
    (rows[0][1], rows[1][0]) = (0.5, 0.5);
    let along = [Twist { linear: DVec3::Y, angular: DVec3::ZERO }];
    let change = Twist { linear: DVec3::new(0.0, 2.0, 1.0), angular: DVec3::ZERO };
    let (held, change) = Mobility::of(&rows).unwrap().held(&along, change);
    let moved = held.response(&IMPULSE);
    assert!(moved.linear.y.abs() < 1e-15);
    // 1 − ½ · ½ of what it would be alone.
    assert!((moved.linear.x - 0.75).abs() < 1e-15 && (moved.linear.z - 3.0).abs() < 1e-15, "{moved:?}");
    near(&change, &Twist { linear: DVec3::new(-1.0, 0.0, 1.0), angular: DVec3::ZERO });
}

/// A body that comes back from another program has the momentum of its velocity.
#[test]
fn a_body_that_returns_has_its_momentum() {
    let body = Body::free(Inertia::sphere(2.0, 0.1));
    let twist = Twist { linear: DVec3::X, angular: DVec3::Z };
    let led = steered(body.clone(), Steering::Prescribed(twist));
    let mut state = at_start(&led, Twist::ZERO);
    step(&led, &mut state, Wrench::ZERO);
    assert!(state.bodies[0].is_elsewhere());
    let own = body.taken_over(&state.bodies[0]);
    assert!(!own.is_elsewhere());
    assert!((own.momentum.linear - 2.0 * DVec3::X).length() < 1e-14);
    assert!((body.kinetic_energy(&own) - (1.0 + 0.5 * 0.4 * 2.0 * 0.01)).abs() < 1e-14);
}
