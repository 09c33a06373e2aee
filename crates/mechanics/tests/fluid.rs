//! Bodies in a fluid at rest: buoyancy at the centre of the volume, drag against the motion.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{Crossings, GRAVITY, Largest, below, energy, run};
use glam::{DQuat, DVec3};
use mechanics::{Body, Fluid, Inertia, Invalid, Mechanism, Motion, Pose, Twist};
use std::f64::consts::TAU;

fn body(fluid: Fluid) -> Body {
    Body { fluid, ..Body::free(Inertia::sphere(2.0, 0.1)) }
}

#[test]
fn a_body_that_floats_in_the_fluid_swings_about_its_centre_of_buoyancy() {
    let arm = 0.03;
    let fluid = Fluid { displaced: 2.0, centre: DVec3::new(0.0, 0.0, arm), drag: 0.0 };
    let mechanism = Mechanism::new(vec![body(fluid)], vec![]).unwrap();
    let pose = Pose { position: DVec3::ZERO, rotation: DQuat::from_rotation_y(1e-3) };
    let mut state = mechanism.state(&[(pose, Twist::ZERO)]);
    let before = energy(&mechanism, &state, GRAVITY);
    let (mut swings, mut lost) = (Crossings::default(), Largest::default());
    run((&mechanism, &mut state), GRAVITY, (1e-3, 5000), |time, state, _| {
        swings.add(time, (state.bodies[0].pose.rotation * DVec3::Z).x);
        lost.add(energy(&mechanism, state, GRAVITY) - before);
    });
    let inertia = 0.4 * 2.0 * 0.1_f64.powi(2);
    let expected = TAU * (inertia / (2.0 * 9.81 * arm)).sqrt();
    below("period", (swings.period() / expected - 1.0).abs(), 1e-4);
    below("energy", lost.0 / (2.0 * 9.81 * arm), 1e-12);
    below("position", state.bodies[0].pose.position.length(), 1e-12);
}

#[test]
fn a_body_sinks_at_the_speed_at_which_drag_bears_its_submerged_weight() {
    let fluid = Fluid { displaced: 0.5, centre: DVec3::ZERO, drag: 3.0 };
    let mechanism = Mechanism::new(vec![body(fluid)], vec![]).unwrap();
    let mut state = mechanism.state(&[(Pose::IDENTITY, Twist::ZERO)]);
    let terminal = (1.5 * 9.81 / 3.0_f64).sqrt();
    // dv/dt = g' (1 − v²/v∞²)
    let time_scale = terminal / (1.5 * 9.81 / 2.0);
    let mut error = Largest::default();
    let mut work = 0.0;
    run((&mechanism, &mut state), GRAVITY, (1e-4, 20_000), |time, state, step| {
        error.add(state.bodies[0].twist.linear.z + terminal * ((time - 0.5e-4) / time_scale).tanh());
        work += step.work(0).total();
    });
    below("speed", error.0 / terminal, 1e-4);
    below("speed at the end", state.bodies[0].twist.linear.z / terminal + 1.0, 1e-4);
    below("work", (work / mechanism.kinetic_energy(&state) - 1.0).abs(), 1e-9);
}

#[test]
fn a_drive_bears_the_drag_of_a_body_that_is_towed() {
    let mut motion = [const { Motion::Fixed }; 6];
    motion[0] = Motion::Prescribed { before: 0.0, speed: 2.0, start: 0.0, ramp: 0.1, end: f64::INFINITY };
    let fluid = Fluid { displaced: 0.0, centre: DVec3::ZERO, drag: 3.0 };
    let towed = Body { fluid, ..Body::new(Inertia::sphere(2.0, 0.1), motion) };
    let mechanism = Mechanism::new(vec![towed], vec![]).unwrap();
    let mut state = mechanism.state(&[(Pose::IDENTITY, Twist::ZERO)]);
    let mut impulse = 0.0;
    run((&mechanism, &mut state), GRAVITY, (1e-3, 200), |_, _, step| {
        let impulses = step.impulses(0);
        impulse = (impulses.drive + impulses.drive_reaction).force.x;
    });
    below("force", (impulse / 1e-3 / 12.0 - 1.0).abs(), 1e-9);
}

#[test]
fn what_is_not_a_number_is_refused() {
    let broken = body(Fluid { drag: f64::NAN, ..Fluid::NONE });
    assert_eq!(Mechanism::new(vec![broken], vec![]).unwrap_err(), Invalid::Fluid);
}
