//! W1: a column of elastic soil under water consolidates under its own weight.

use crate::error::VerifyError;
use crate::runner::Runner;
use glam::DVec3;
use physics::elastic::Elastic;
use solver::fields::PORE_PRESSURE;
use solver::grid::Grid;
use solver::initial::{Filling, at_rest};
use solver::material::Material;
use solver::model::{Model, PoreWater};
use solver::step::step;
use solver::workspace::Workspace;
use std::f64::consts::PI;
use std::time::Instant;

/// Cells over the box, height of the column [m], and the name of the variant.
const COLUMNS: [(usize, f64, &str); 4] = [
    (25, 0.4, "25 cells"),
    (50, 0.4, "50 cells"),
    (50, 0.4034, "50 cells, H = 0.4034 m"),
    (50, 0.3966, "50 cells, H = 0.3966 m"),
];
/// Times of the readings, T = c_v t/H².
const TIMES: [f64; 3] = [0.1, 0.3, 0.6];
/// Height of the box [m].
const BOX: f64 = 0.5;
/// Permeability [m/s].
const PERMEABILITY: f64 = 2e-4;
/// Unit weight of the water [N/m³].
const UNIT_WEIGHT: f64 = 1e4;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (cells, height, name) in COLUMNS {
        let clock = Instant::now();
        let ratios = consolidate(&model(cells), height)?;
        for (time, ratio) in TIMES.into_iter().zip(ratios) {
            let figure = ("pore pressure at the base over the exact one", ratio);
            let seconds = clock.elapsed().as_secs_f64();
            runner.put("W1", &format!("{name}, T = {time}"), seconds, &[figure])?;
        }
    }
    Ok(())
}

/// A box of saturated elastic soil without stress between smooth walls, two cells wide.
fn model(cells: usize) -> Model {
    let width = BOX / cells as f64;
    let faces = |cells: usize| (0..=cells).map(|n| n as f64 * width).collect();
    let material = Material { k0: 0.0, ..Material::linear_elastic(Elastic::new(10e6, 0.2), 1600.0) };
    let water = PoreWater { permeability: PERMEABILITY, unit_weight: UNIT_WEIGHT, level: 2.0 };
    let grid = Grid::new([faces(2), faces(2), faces(cells)]);
    Model { soil_gravity: 6.0, pore_water: Some(water), ..Model::bare(grid, material) }
}

/// Excess pore pressure in the lowest cell over the exact one, at each of the times.
fn consolidate(model: &Model, height: f64) -> Result<[f64; 3], VerifyError> {
    let column = Filling::between(DVec3::splat(-1e9), DVec3::new(1e9, 1e9, height));
    let mut state = at_rest::<f64>(model, &column);
    state.soil.stress.iter_mut().for_each(|stress| stress.fill(0.0));
    let mut workspace = Workspace::new(model, &mut state, 1);
    let material = model.material();
    let diffusivity = PERMEABILITY / UNIT_WEIGHT * material.elastic.constrained();
    let pressure = material.density * model.soil_gravity * height;
    let base = model.grid.index(0, 0, 0);
    let depth = 1.0 - model.grid.centre(2, 0) / height;
    let mut ratios = [0.0; 3];
    for (ratio, time) in ratios.iter_mut().zip(TIMES) {
        while diffusivity * state.time < time * height * height {
            step(model, &mut state, &mut workspace)?;
        }
        *ratio = state.soil.history[PORE_PRESSURE][base] / (pressure * exact(depth, time));
    }
    Ok(ratios)
}

/// Terzaghi's excess pore pressure over γ′ H, at a depth over H and a time T, drained at the top only, from
/// γ′ z at the start.
fn exact(depth: f64, time: f64) -> f64 {
    let term = |n: u32| {
        let m = (f64::from(n) + 0.5) * PI;
        let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        2.0 * sign / (m * m) * (m * depth).sin() * (-m * m * time).exp()
    };
    (0..50).map(term).sum()
}
