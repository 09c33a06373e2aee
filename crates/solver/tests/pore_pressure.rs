//! The pressure of the pore water beside exact solutions.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, uniform};
use physics::elastic::Elastic;
use solver::fields::PORE_PRESSURE;
use solver::grid::Grid;
use solver::initial::at_rest;
use solver::material::Material;
use solver::model::{Model, PoreWater};
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
            println!("{cells} {surface} {time}: {found} {exact} {}", found / exact - 1.0);
            assert!((found / exact - 1.0).abs() < tolerance);
        }
    }
}
