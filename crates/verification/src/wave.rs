//! A1: an elastic wave along a bar, also of flat cells along their long and their short side.

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
/// Flat cells.
const FLAT: DVec3 = DVec3::new(3.0, 3.0, 1.0);

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    const SPEED: &str = "wave speed over √(M/ρ)";
    const ERROR: &str = "L2 error over the pulse's";
    let damped = |bar: Bar| travel(&Bar { bulk_viscosity: Method::default().bulk_viscosity, ..bar });
    let cubes = damped(Bar::PLAIN)?;
    runner.put("A1", "200 cells, b₁ = 0.02", cubes.seconds, &[(SPEED, cubes.speed)])?;
    for (axis, name) in [(0, "x"), (2, "z")] {
        let flat = damped(Bar { axis, aspect: FLAT, ..Bar::PLAIN })?;
        let variant = format!("200 flat cells 3:3:1 along {name}, b₁ = 0.02");
        runner.put("A1", &variant, flat.seconds, &[(SPEED, flat.speed)])?;
    }
    let (coarse, fine) = (travel(&Bar::PLAIN)?, travel(&Bar { refinement: 2, ..Bar::PLAIN })?);
    let plain = "200 cells, no bulk viscosity";
    runner.put("A1", plain, coarse.seconds, &[(SPEED, coarse.speed)])?;
    let order = ("order of the L2 error", (coarse.error / fine.error).log2());
    let both = "200 and 400 cells, no bulk viscosity";
    runner.put("A1", both, coarse.seconds + fine.seconds, &[order])?;
    runner.put("A1", plain, coarse.seconds, &[(ERROR, coarse.error)])?;
    let remapped = travel(&Bar { remap_displacement: -1.0, ..Bar::PLAIN })?;
    runner.put("A1", "200 cells, remap in every step", remapped.seconds, &[(ERROR, remapped.error)])
}

/// A bar between smooth walls, one cell wide.
#[derive(Clone, Copy)]
struct Bar {
    /// Refinement: cells over those of the coarse bar.
    refinement: usize,
    /// Axis of the bar.
    axis: usize,
    /// Shape of the cells.
    aspect: DVec3,
    bulk_viscosity: [f64; 2],
    remap_displacement: f64,
}

impl Bar {
    /// The coarse bar, of cubes along x, without bulk viscosity.
    const PLAIN: Self = Self {
        refinement: 1,
        axis: 0,
        aspect: DVec3::ONE,
        bulk_viscosity: [0.0; 2],
        remap_displacement: 0.1,
    };
}

struct Travelled {
    /// Speed over √(M/ρ).
    speed: f64,
    /// L2 error of the velocity over the L2 norm of the pulse.
    error: f64,
    seconds: f64,
}

/// Sends a pulse along a bar.
fn travel(bar: &Bar) -> Result<Travelled, VerifyError> {
    let clock = Instant::now();
    let coarse = 1.0 / CELLS as f64;
    let (model, axis) = (model(bar), bar.axis);
    let everywhere = Filling::between(DVec3::splat(-1e9), DVec3::splat(1e9));
    let mut state = at_rest(&model, &everywhere);
    let (c, dt) = (model.wave_speed(), model.time_step());
    // Velocities are half a step ahead of stresses.
    let pulse = |x: f64, time: f64| {
        let distance = (x - c * time) / coarse - PULSE[1];
        PEAK * (-0.5 * (distance / PULSE[0]).powi(2)).exp()
    };
    set(&model, axis, &mut state, |x| pulse(x, 0.5 * dt), |x| pulse(x, 0.0));
    let begin = centre(&model, axis, &state);
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let steps = (TRAVEL * coarse / (c * dt)).round() as usize;
    for _ in 0..steps {
        step(&model, &mut state, &mut workspace)?;
    }
    let time = steps as f64 * dt;
    let speed = (centre(&model, axis, &state) - begin) / time / c;
    let error = difference(&model, axis, &state, |x| pulse(x, time + 0.5 * dt));
    Ok(Travelled { speed, error, seconds: clock.elapsed().as_secs_f64() })
}

fn model(bar: &Bar) -> Model {
    let cells = CELLS * bar.refinement;
    let h = 1.0 / cells as f64;
    let faces = std::array::from_fn(|axis| match axis == bar.axis {
        true => (0..=cells).map(|n| n as f64 * h).collect(),
        false => vec![0.0, h * (bar.aspect[axis] / bar.aspect[bar.axis])],
    });
    let grid = Grid::new(faces).with_aspect(bar.aspect);
    let Bar { bulk_viscosity, remap_displacement, .. } = *bar;
    let method = Method { hourglass: 0.0, bulk_viscosity, remap_displacement, ..Method::default() };
    Model { method, ..Model::bare(grid, Material::linear_elastic(Elastic::new(20e6, 0.3), 1600.0)) }
}

/// Cell, or corner `side` of its low face, of layer `n` of the bar.
fn index(model: &Model, axis: usize, n: usize, side: [usize; 2]) -> usize {
    let mut layers = [0; 3];
    layers[axis] = n;
    [layers[(axis + 1) % 3], layers[(axis + 2) % 3]] = side;
    model.grid.index(layers[0], layers[1], layers[2])
}

/// Velocities of a wave that travels to the right, and its stresses −ρ c v.
fn set(
    model: &Model,
    axis: usize,
    state: &mut State,
    velocity: impl Fn(f64) -> f64,
    at_stress: impl Fn(f64) -> f64,
) {
    let grid = &model.grid;
    let elastic = &model.material().elastic;
    let (lateral, axial) = (elastic.bulk - 2.0 / 3.0 * elastic.shear, elastic.constrained());
    for i in 0..=grid.cells()[axis] {
        for side in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            state.nodes.velocity[axis][index(model, axis, i, side)] = velocity(grid.faces[axis][i]);
        }
        if i < grid.cells()[axis] {
            let cell = index(model, axis, i, [0, 0]);
            let stress = -model.material().density * model.wave_speed() * at_stress(grid.centre(axis, i));
            for (q, component) in state.soil.stress.iter_mut().take(3).enumerate() {
                component[cell] = if q == axis { stress } else { stress * lateral / axial };
            }
        }
    }
}

/// Where the kinetic energy has its centre [m].
fn centre(model: &Model, axis: usize, state: &State) -> f64 {
    let faces = &model.grid.faces[axis];
    let energy = |i: usize| state.nodes.velocity[axis][index(model, axis, i, [0, 0])].powi(2);
    let sum = |weight: &dyn Fn(usize) -> f64| (0..faces.len()).map(|i| energy(i) * weight(i)).sum::<f64>();
    sum(&|i| faces[i]) / sum(&|_| 1.0)
}

/// L2 norm of the difference to a velocity, over that of the velocity.
fn difference(model: &Model, axis: usize, state: &State, exact: impl Fn(f64) -> f64) -> f64 {
    let faces = &model.grid.faces[axis];
    let (mut off, mut all) = (0.0, 0.0);
    for (i, x) in faces.iter().enumerate() {
        let v = exact(*x);
        off += (state.nodes.velocity[axis][index(model, axis, i, [0, 0])] - v).powi(2);
        all += v * v;
    }
    (off / all).sqrt()
}
