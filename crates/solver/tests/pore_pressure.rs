//! The pressure of the pore water beside exact solutions.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use physics::elastic::Elastic;
use physics::law::Law;
use physics::mohr_coulomb::MohrCoulomb;
use physics::shape::Block;
use solver::fields::PORE_PRESSURE;
use solver::grid::Grid;
use solver::initial::at_rest;
use solver::material::Material;
use solver::model::{BodyModel, Model, PoreWater};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;
use std::f64::consts::PI;

/// A column of elastic soil of this height [m] between smooth walls, in a box of 0.5 m.
fn column(cells: usize, permeability: f64) -> Model {
    let material = Material { k0: 0.0, ..Material::linear_elastic(Elastic::new(10e6, 0.2), 1600.0) };
    let faces = [uniform(0.0, 0.1, 2), uniform(0.0, 0.1, 2), uniform(0.0, 0.5, cells)];
    let water = PoreWater { permeability, unit_weight: 1e4, level: 2.0 };
    Model { soil_gravity: 6.0, pore_water: Some(water), ..Model::bare(Grid::new(faces), material) }
}

/// Pore pressure in the lowest cell [Pa].
fn at_base(model: &Model, state: &State) -> f64 {
    state.soil.history[PORE_PRESSURE][model.grid.index(0, 0, 0)]
}

/// Consolidation under the own weight, which comes on at once: water bears it all at first. Terzaghi's equation, drained at the top
/// only: p = γ′H Σ 2 (−1)ⁿ/m² sin(m z/H) exp(−m² T) with m = (2n + 1) π/2 and T = c_v t/H².
#[test]
fn a_column_consolidates_as_terzaghi_says() {
    for (cells, surface, tolerance) in
        [(25, 0.4, 0.01), (50, 0.4, 0.005), (50, 0.4034, 0.01), (50, 0.3966, 0.01)]
    {
        let model = column(cells, 2e-4);
        let mut state = at_rest::<f64>(&model, &below(surface));
        for stress in &mut state.soil.stress {
            stress.fill(0.0);
        }
        let weight = 1600.0 * 6.0 * surface;
        let oedometer = 10e6 * 0.8 / (1.2 * 0.6);
        let speed = 2e-4 / 1e4 * oedometer / (surface * surface);
        let mut workspace = Workspace::new(&model, &mut state, 1);
        for time in [0.1, 0.3, 0.6] {
            while speed * state.time < time {
                step(&model, &mut state, &mut workspace).unwrap();
            }
            let depth = surface - model.grid.centre(2, 0);
            let term = |n: u32| {
                let m = (f64::from(n) + 0.5) * PI;
                let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
                2.0 * sign / (m * m) * (m * depth / surface).sin() * (-m * m * time).exp()
            };
            let exact = weight * (0..50).map(term).sum::<f64>();
            let found = at_base(&model, &state);
            assert!((found / exact - 1.0).abs() < tolerance, "{cells} {surface} {time}: {found} {exact}");
        }
    }
}

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
        edge_inset: 0.5,
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

/// Water that cannot flow bears what compresses the soil: its volume does not change, however stiff water and soil are.
#[test]
fn soil_that_cannot_drain_keeps_its_volume_and_presses_on_the_body() {
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
    assert!(pore > 0.3 * undrained, "{pore} of {undrained} N s");
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
    assert_eq!(least, -PoreWater::ATMOSPHERE);
}
