//! A set-up turned as a whole about z: body, motion and grid; its forces turn with it.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand};
use glam::{DQuat, DVec3};
use mechanics::{Inertia, Motion, Pose};
use physics::shape::{Block, Disc, Shape};
use solver::initial::at_rest;
use solver::model::BodyModel;
use solver::state::{Body, State};
use solver::step::step;
use solver::workspace::Workspace;
use std::f64::consts::FRAC_PI_2;

const STEPS: usize = 100;

/// The body after each of the first steps of a tow along x, turned by a number of right angles.
fn towed(shape: Box<dyn Shape>, quarters: u32) -> Vec<(Body, DVec3)> {
    let rotation = DQuat::from_rotation_z(FRAC_PI_2 * f64::from(quarters));
    let across: Vec<f64> = (-10..=10).map(|n| 0.02 * f64::from(n)).collect();
    let above = (-6..=3).map(|n| 0.02 * f64::from(n)).collect();
    let mut model = sand([across.clone(), across, above]);
    let height = 0.085 - 0.1 + shape.bounds().1.z;
    let start = rotation * DVec3::new(-0.03, 0.013, height);
    let velocity = rotation * DVec3::new(0.3, 0.0, -0.15);
    let along = |axis: usize| Motion::Prescribed {
        speed: velocity[axis],
        start: 0.0,
        ramp: 0.002,
        end: f64::INFINITY,
    };
    model.bodies.push(BodyModel {
        name: "body".into(),
        shape,
        start: Pose { position: start, rotation },
        inertia: Inertia::principal(1.0, DVec3::splat(0.005)),
        friction: 0.3,
        shear_limit: f64::INFINITY,
        motion: [along(0), along(1), along(2), Motion::Fixed, Motion::Fixed, Motion::FREE],
    });
    let mut state = at_rest(&model, &below(0.0));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let each = |_| {
        step(&model, &mut state, &mut workspace).unwrap();
        (state.bodies[0].clone(), spin(&state))
    };
    (0..STEPS).map(each).collect()
}

/// Angular velocity in the body frame [rad/s].
fn spin(state: &State) -> DVec3 {
    state.pose(0).rotation.inverse() * state.twist(0).angular
}

fn compare(shape: impl Fn() -> Box<dyn Shape>) {
    let original = towed(shape(), 0);
    let total = original.last().unwrap().0.contact_impulse;
    assert!(total.normal.length() > 1e-4 && total.friction.length() > 1e-5, "{total:?}");
    for quarters in [1, 2, 3] {
        let back = DQuat::from_rotation_z(-FRAC_PI_2 * f64::from(quarters));
        let turned = towed(shape(), quarters);
        for (n, (a, b)) in original.iter().zip(&turned).enumerate() {
            let (now, then) = (&b.0.contact_impulse, &a.0.contact_impulse);
            let scale = total.normal.length();
            for (turned, original) in [(now.normal, then.normal), (now.friction, then.friction)] {
                let difference = (back * turned - original).length() / scale;
                assert!(difference < 1e-6, "{quarters} right angles, step {n}: {difference:e}");
            }
            let difference = (back * now.moment - then.moment).length() / (0.1 * scale);
            assert!(difference < 1e-6, "{quarters} right angles, step {n}: moment {difference:e}");
            assert!((b.1 - a.1).length() < 1e-6 * original.last().unwrap().1.length().max(1e-3));
        }
    }
}

#[test]
fn the_forces_on_a_disc_turn_with_the_whole() {
    compare(|| Box::new(Disc { diameter: 0.2, thickness: 0.08 }));
}

#[test]
fn the_forces_on_a_block_turn_with_the_whole() {
    compare(|| Box::new(Block { size: DVec3::new(0.16, 0.09, 0.12) }));
}
