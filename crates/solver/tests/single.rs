//! In single precision soil rests, moves and keeps its mass to about seven digits, and mirror images and
//! threads still agree to the bit.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use geometry::Disc;
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::initial::at_rest;
use solver::model::{BodyModel, Model};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

/// The state after a number of steps on a number of threads.
fn after(model: &Model, surface: f64, threads: usize, steps: usize) -> State<f32> {
    let mut state = at_rest::<f32>(model, &below(surface));
    let mut workspace = Workspace::new(model, &mut state, threads);
    for _ in 0..steps {
        step(model, &mut state, &mut workspace).unwrap();
    }
    state
}

/// A disc with its centre at `y` [m], pushed into sand and towed.
fn tow(y: f64) -> Model {
    let moving =
        |speed| Motion::Prescribed { before: 0.0, speed, start: 0.0, ramp: 0.01, end: f64::INFINITY };
    let across = (-8..=8).map(|n| 0.02 * f64::from(n)).collect();
    let mut model = sand([uniform(-0.2, 0.24, 22), across, uniform(-0.12, 0.06, 9)]);
    model.bodies.push(BodyModel {
        name: "disc".into(),
        shape: Box::new(Disc { diameter: 0.2, thickness: 0.08 }),
        start: Pose::at(DVec3::new(0.0, y, 0.1)),
        inertia: Inertia::principal(1.0, DVec3::splat(0.005)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [
            moving(0.3),
            Motion::Fixed,
            moving(-0.15),
            Motion::Fixed,
            Motion::Fixed,
            Motion::Free { load: 0.0, support: 0.0, start: 0.0, ramp: 0.0 },
        ],
    });
    model
}

#[test]
fn soil_at_rest_hardly_moves() {
    for surface in [0.4, 0.425, 0.4005, 0.4495] {
        for every_step in [false, true] {
            let mut model = sand([uniform(0.0, 0.3, 6), uniform(0.0, 0.2, 4), uniform(0.0, 0.5, 10)]);
            if every_step {
                model.method.remap_displacement = -1.0;
            }
            let state = after(&model, surface, 1, 500);
            let speed = state.nodes.velocity.iter().flatten().fold(0.0_f32, |a, v| v.abs().max(a));
            assert!(speed < 1e-6, "{speed:e} m/s with the surface at {surface} m, remap {every_step}");
        }
    }
}

#[test]
fn a_tow_keeps_the_soil() {
    let model = tow(0.0);
    let state = after(&model, 0.0, 1, 800);
    let body = &state.bodies[0];
    let leak = body.leaked_volume / body.embedded_volume;
    assert!(leak < 1e-3, "{leak:e} of the embedded volume is soil");
    let before = model.material().density * state.energy_balance.volume_start;
    let mass: f64 = state.soil.mass.iter().map(|mass| f64::from(*mass)).sum();
    let lost = (mass + state.energy_balance.debris_mass) / before - 1.0;
    assert!(lost.abs() < 1e-6, "{lost:e} of the mass");
}

#[test]
fn threads_and_mirror_images_agree_to_the_bit() {
    let (left, right) = (tow(-0.007), tow(0.007));
    let (one, two, image) =
        (after(&left, 0.0, 1, 300), after(&left, 0.0, 2, 300), after(&right, 0.0, 1, 300));
    assert_eq!(one, two);
    let grid = &left.grid;
    let [nx, ny, nz] = grid.cells();
    for (i, j, k) in (0..nx * ny * nz).map(|n| (n % nx, n / nx % ny, n / nx / ny)) {
        let (cell, other) = (grid.index(i, j, k), grid.index(i, ny - 1 - j, k));
        assert_eq!(one.soil.fraction[cell], image.soil.fraction[other], "cell {i} {j} {k}");
    }
    assert_eq!(one.twist(0).angular.y, image.twist(0).angular.y);
}
