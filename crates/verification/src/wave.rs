//! A1: an elastic wave along a bar.

use crate::error::VerifyError;
use crate::runner::Runner;
use glam::DVec3;
use physics::elastic::Elastic;
use solver::grid::Grid;
use solver::initial::{Filling, at_rest};
use solver::material::Material;
use solver::model::{Method, Model};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;
use std::time::Instant;

/// Cells of the coarse bar; the fine one has twice as many.
const CELLS: usize = 200;
/// Coarse cells that the wave travels.
const TRAVEL: f64 = 100.0;
/// Standard deviation of the pulse, and where it starts, in coarse cells.
const PULSE: [f64; 2] = [6.0, 45.0];
/// Peak velocity [m/s]: displacements stay far below those at which a remap is due.
const PEAK: f64 = 1e-6;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    const SPEED: &str = "wave speed over √(M/ρ)";
    const ERROR: &str = "L2 error over the pulse's";
    let damped = travel(1, Method::default().bulk_viscosity, None)?;
    runner.put("A1", "200 cells, b₁ = 0.02", damped.seconds, &[(SPEED, damped.speed)])?;
    let (coarse, fine) = (travel(1, [0.0; 2], None)?, travel(2, [0.0; 2], None)?);
    let plain = "200 cells, no bulk viscosity";
    runner.put("A1", plain, coarse.seconds, &[(SPEED, coarse.speed)])?;
    let order = ("order of the L2 error", (coarse.error / fine.error).log2());
    let both = "200 and 400 cells, no bulk viscosity";
    runner.put("A1", both, coarse.seconds + fine.seconds, &[order])?;
    runner.put("A1", plain, coarse.seconds, &[(ERROR, coarse.error)])?;
    let remapped = travel(1, [0.0; 2], Some(-1.0))?;
    runner.put("A1", "200 cells, remap in every step", remapped.seconds, &[(ERROR, remapped.error)])
}

struct Travelled {
    /// Speed over √(M/ρ).
    speed: f64,
    /// L2 error of the velocity over the L2 norm of the pulse.
    error: f64,
    seconds: f64,
}

/// Sends a pulse along a bar of `refinement` times as many cells.
fn travel(refinement: usize, bulk_viscosity: [f64; 2], remap: Option<f64>) -> Result<Travelled, VerifyError> {
    let clock = Instant::now();
    let coarse = 1.0 / CELLS as f64;
    let mut model = bar(CELLS * refinement, bulk_viscosity);
    if let Some(displacement) = remap {
        model.method.remap_displacement = displacement;
    }
    let everywhere = Filling::between(DVec3::splat(-1e9), DVec3::splat(1e9));
    let mut state = at_rest(&model, &everywhere);
    let (c, dt) = (model.wave_speed(), model.time_step());
    // Velocities are half a step ahead of stresses.
    let pulse = |x: f64, time: f64| {
        let distance = (x - c * time) / coarse - PULSE[1];
        PEAK * (-0.5 * (distance / PULSE[0]).powi(2)).exp()
    };
    set(&model, &mut state, |x| pulse(x, 0.5 * dt), |x| pulse(x, 0.0));
    let begin = centre(&model, &state);
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let steps = (TRAVEL * coarse / (c * dt)).round() as usize;
    for _ in 0..steps {
        step(&model, &mut state, &mut workspace)?;
    }
    let time = steps as f64 * dt;
    let speed = (centre(&model, &state) - begin) / time / c;
    let error = difference(&model, &state, |x| pulse(x, time + 0.5 * dt));
    Ok(Travelled { speed, error, seconds: clock.elapsed().as_secs_f64() })
}

/// A bar along x, one cell wide, between smooth walls.
fn bar(cells: usize, bulk_viscosity: [f64; 2]) -> Model {
    let h = 1.0 / cells as f64;
    let along = (0..=cells).map(|n| n as f64 * h).collect();
    let grid = Grid::new([along, vec![0.0, h], vec![0.0, h]]);
    let method = Method { hourglass: 0.0, bulk_viscosity, ..Method::default() };
    Model { method, ..Model::bare(grid, Material::linear_elastic(Elastic::new(20e6, 0.3), 1600.0)) }
}

/// Velocities of a wave that travels to the right, and its stresses −ρ c v.
fn set(model: &Model, state: &mut State, velocity: impl Fn(f64) -> f64, at_stress: impl Fn(f64) -> f64) {
    let grid = &model.grid;
    let elastic = &model.material().elastic;
    let (lateral, axial) = (elastic.bulk - 2.0 / 3.0 * elastic.shear, elastic.constrained());
    for i in 0..=grid.cells()[0] {
        for (j, k) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            state.nodes.velocity[0][grid.index(i, j, k)] = velocity(grid.faces[0][i]);
        }
        if i < grid.cells()[0] {
            let cell = grid.index(i, 0, 0);
            let stress = -model.material().density * model.wave_speed() * at_stress(grid.centre(0, i));
            state.soil.stress[0][cell] = stress;
            state.soil.stress[1][cell] = stress * lateral / axial;
            state.soil.stress[2][cell] = stress * lateral / axial;
        }
    }
}

/// Where the kinetic energy has its centre [m].
fn centre(model: &Model, state: &State) -> f64 {
    let faces = &model.grid.faces[0];
    let energy = |i: usize| state.nodes.velocity[0][model.grid.index(i, 0, 0)].powi(2);
    let sum = |weight: &dyn Fn(usize) -> f64| (0..faces.len()).map(|i| energy(i) * weight(i)).sum::<f64>();
    sum(&|i| faces[i]) / sum(&|_| 1.0)
}

/// L2 norm of the difference to a velocity, over that of the velocity.
fn difference(model: &Model, state: &State, exact: impl Fn(f64) -> f64) -> f64 {
    let faces = &model.grid.faces[0];
    let (mut off, mut all) = (0.0, 0.0);
    for (i, x) in faces.iter().enumerate() {
        let v = exact(*x);
        off += (state.nodes.velocity[0][model.grid.index(i, 0, 0)] - v).powi(2);
        all += v * v;
    }
    (off / all).sqrt()
}
