//! Boundaries at constant stress: nothing moves at rest, what is too much leaves, and the balances count it.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{sand, uniform};
use glam::DVec3;
use physics::elastic::Elastic;
use solver::balance::{elastic_energy, kinetic_energy};
use solver::boundary::Boundaries;
use solver::boundary::Boundary::{ConstantStress, RoughWall, SmoothWall};
use solver::energy::{soil_mass, soil_volume};
use solver::grid::Grid;
use solver::halo::Halo;
use solver::initial::at_rest_on;
use solver::material::Material;
use solver::model::{Filling, Ground, Model};
use solver::precision::Precision;
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

const OVERBURDEN: f64 = 20e3;

/// A box of soil under a lid that keeps its pressure, with such sides or smooth ones.
fn covered<R: Precision>(sides: bool) -> Model {
    let mut model = sand([uniform(-0.2, 0.2, 16), uniform(0.0, 0.1, 4), uniform(-0.3, 0.0, 12)]);
    let side = if sides { ConstantStress } else { SmoothWall };
    model.boundaries = Boundaries([[side; 2], [SmoothWall; 2], [RoughWall, ConstantStress]]);
    model.grid = Grid::with_open_faces(model.grid.faces.clone(), model.boundaries.open_faces(), R::LANES);
    let everywhere = Filling::between(DVec3::splat(f64::NEG_INFINITY), DVec3::INFINITY);
    model.ground = Ground { fillings: vec![everywhere], overburden: OVERBURDEN, ..Ground::default() };
    model
}

fn run<R: Precision>(model: &Model, state: &mut State<R>, steps: usize) {
    let mut workspace = Workspace::new(model, state, 2);
    (0..steps).for_each(|_| step(model, state, &mut workspace).unwrap());
}

/// Mean vertical stress in the domain [Pa].
fn vertical<R: Precision>(model: &Model, state: &State<R>) -> f64 {
    let grid = &model.grid;
    let inside =
        (0..grid.entries).filter(|c| state.soil.fraction[*c].to_f64() > 0.0 && grid.is_in_domain(*c));
    let all: Vec<f64> = inside.map(|c| state.soil.stress[2][c].to_f64()).collect();
    all.iter().sum::<f64>() / all.len() as f64
}

#[test]
fn soil_at_rest_stays_at_rest() {
    for sides in [false, true] {
        let model = covered::<f64>(sides);
        let mut state = at_rest_on::<f64>(&model, &model.ground);
        let weight = 0.15 * model.material().density * model.soil_gravity;
        assert!((vertical(&model, &state) / -(OVERBURDEN + weight) - 1.0).abs() < 1e-12);
        run(&model, &mut state, 300);
        let fastest = state.nodes.velocity.iter().flatten().fold(0.0, |fastest: f64, v| fastest.max(v.abs()));
        assert!(fastest < 1e-12, "{fastest} m/s");
    }
}

/// Elastic soil without weight that is 1 kPa above the pressure of the lid.
fn relieved<R: Precision>() {
    let mut model = covered::<R>(false);
    model.materials = vec![Material { k0: 1.0, ..Material::linear_elastic(Elastic::new(5e6, 0.3), 1600.0) }];
    (model.gravity, model.soil_gravity) = (0.0, 0.0);
    let mut state = at_rest_on::<R>(&model, &model.ground);
    for c in 0..model.grid.entries {
        for stress in &mut state.soil.stress[..3] {
            stress[c] = R::cast(stress[c].to_f64() * (1.0 + 1e3 / OVERBURDEN));
        }
    }
    state.energy_balance.elastic_start = elastic_energy(&model, &state, &Halo::whole());
    let start = soil_mass(&model.grid, &state.soil, &Halo::whole());
    run(&model, &mut state, 3000);
    let rise = vertical(&model, &state) / -OVERBURDEN - 1.0;
    assert!(rise.abs() < 2e-3, "{rise}");
    // The soil rises by Δσ H/M over its height; what has passed the lid is gone.
    let elastic = model.material().elastic;
    let strain = 1e3 / (elastic.bulk + 4.0 / 3.0 * elastic.shear);
    let lost = 1.0 - soil_mass(&model.grid, &state.soil, &Halo::whole()) / start;
    let balance = &state.energy_balance;
    let passed = -balance.inflow_mass / start;
    assert!((lost - passed).abs() < 1e-4 * strain + 10.0 * R::ROUND_OFF, "{lost} {passed}");
    let risen = state.nodes.displacement[2].iter().map(|u| u.to_f64()).fold(0.0, f64::max) / 0.3;
    assert!(((lost + risen) / strain - 1.0).abs() < 0.05, "{lost} + {risen} of {strain}");
    let volume = soil_volume(&model.grid, &state.soil, &Halo::whole());
    assert!((volume / balance.volume_start - 1.0).abs() < 1e-3);
    let now = elastic_energy(&model, &state, &Halo::whole()) + kinetic_energy(&model, &state, &Halo::whole());
    let spent = balance.plastic + balance.viscous + balance.hourglass + balance.remap;
    let unexplained = now + spent - balance.elastic_start - balance.inflow_elastic - balance.external;
    // 1.2 % was found before the limit was set.
    assert!(unexplained.abs() < 0.02 * balance.external.abs(), "{unexplained} J of {} J", balance.external);
}

#[test]
fn a_lid_lets_go_what_is_above_its_pressure() {
    relieved::<f64>();
    relieved::<f32>();
}
