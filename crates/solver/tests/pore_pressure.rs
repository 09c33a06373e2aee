//! The pressure of the pore water: resumed runs, threads, undrained and cavitating soil. Beside exact
//! solutions: `coulter verify W1 W2`.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use geometry::Block;
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use physics::law::Law;
use physics::mohr_coulomb::MohrCoulomb;
use solver::fields::PORE_PRESSURE;
use solver::initial::at_rest;
use solver::model::{BodyModel, Model, PoreWater};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

/// A block pressed into sand under water, with remaps.
fn pressed(permeability: f64) -> Model {
    let mut model = sand([uniform(-0.2, 0.2, 20), uniform(-0.2, 0.2, 20), uniform(-0.2, 0.1, 15)]);
    model.pore_water = Some(PoreWater { permeability, unit_weight: 1e4, level: 1.0 });
    model.method.remap_displacement = 0.02;
    let fixed = Motion::Fixed;
    let down = Motion::Prescribed { before: 0.0, speed: -0.2, start: 0.0, ramp: 0.005, end: f64::INFINITY };
    model.bodies.push(BodyModel {
        name: "block".into(),
        shape: Box::new(Block { size: DVec3::new(0.12, 0.1, 0.06) }),
        start: Pose::at(DVec3::new(0.003, -0.004, 0.03)),
        inertia: Inertia::principal(2.0, DVec3::splat(0.01)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [fixed.clone(), fixed.clone(), down, fixed.clone(), fixed.clone(), fixed],
    });
    model
}

fn go(model: &Model, state: &mut State, threads: usize, steps: usize) {
    let mut workspace = Workspace::new(model, state, threads);
    for _ in 0..steps {
        step(model, state, &mut workspace).unwrap();
    }
}

#[test]
fn a_run_that_resumes_takes_the_same_course_on_any_number_of_threads() {
    let model = pressed(1e-4);
    let begin = at_rest::<f64>(&model, &below(0.0));
    let mut straight = begin.clone();
    go(&model, &mut straight, 1, 150);
    assert!(straight.remaps > 5);
    let mut resumed = begin;
    for (threads, steps) in [(2, 33), (1, 50), (3, 67)] {
        go(&model, &mut resumed, threads, steps);
    }
    assert!(straight == resumed);
}

#[test]
fn water_that_cannot_flow_presses_on_the_body_and_water_that_can_does_not() {
    let force = |permeability: f64| {
        let model = pressed(permeability);
        let mut state = at_rest::<f64>(&model, &below(0.0));
        go(&model, &mut state, 2, 300);
        let impulse = state.bodies[0].contact_impulse;
        let seepage = state.energy_balance.seepage;
        assert!(seepage > 0.0, "{seepage} J");
        [impulse.normal.z, impulse.pore.z]
    };
    let [[drained, none], [undrained, pore]] = [1e3, 1e-9].map(force);
    assert!(none.abs() < 0.01 * drained, "{none} of {drained} N s");
    assert!(pore > 0.1 * undrained, "{pore} of {undrained} N s");
}

/// Water cavitates rather than bear more tension than the atmosphere and its depth allow.
#[test]
fn water_cavitates() {
    let mut model = pressed(1e-7);
    let mut dilates = model.materials[0];
    let law = MohrCoulomb::new(dilates.elastic, 0.6, 0.6, 0.0, 0.0);
    dilates.yield_law = Some(Law::MohrCoulomb(law));
    model.materials = vec![dilates];
    let water = PoreWater { permeability: 1e-7, unit_weight: 1e4, level: -1.0 };
    model.pore_water = Some(water);
    let mut state = at_rest::<f64>(&model, &below(0.0));
    go(&model, &mut state, 2, 800);
    let least = state.soil.history[PORE_PRESSURE].iter().fold(0.0, |least: f64, p| least.min(*p));
    // The remap averages: to round-off.
    assert!((least / -PoreWater::ATMOSPHERE - 1.0).abs() < 1e-12, "{least} Pa");
}
