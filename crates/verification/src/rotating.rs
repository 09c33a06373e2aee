//! A3: a free elastic block makes one revolution.

use crate::advection::{each_node, fill, over_cells};
use crate::error::VerifyError;
use crate::runner::Runner;
use glam::DVec2;
use physics::elastic::Elastic;
use physics::tensor::contract;
use solver::balance::kinetic_energy;
use solver::energy::soil_volume;
use solver::grid::Grid;
use solver::halo::Halo;
use solver::initial::at_rest_filled;
use solver::material::Material;
use solver::model::Model;
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;
use std::f64::consts::TAU;
use std::time::{Duration, Instant};

const YOUNG: f64 = 1e7;
/// Half edges of the block [m].
const HALF: DVec2 = DVec2::new(0.5, 0.25);
/// Speed of the corners of the block over that of the compression wave.
const MACH: f64 = 0.01;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for cells in [16, 32] {
        let variant = format!("{cells} cells along the block");
        if runner.wants("A3", &variant)? {
            rotate(runner, &variant, cells)?;
        }
    }
    Ok(())
}

fn rotate(runner: &mut Runner, variant: &str, cells: u32) -> Result<(), VerifyError> {
    let clock = Instant::now();
    let model = empty_slab(1.0 / f64::from(cells));
    let grid = &model.grid;
    let mut fraction = vec![0.0; grid.entries];
    fill(grid, |x| x.x.abs() <= HALF.x && x.z.abs() <= HALF.y, &mut fraction);
    let mut state = at_rest_filled(&model, fraction.clone());
    let rate = MACH * model.wave_speed() / HALF.length();
    each_node(grid, |n, x| {
        if state.nodes.mass[n] > 0.0 {
            state.nodes.velocity[0][n] = rate * x.z;
            state.nodes.velocity[2][n] = -rate * x.x;
        }
    });
    let (volume, kinetic) =
        (soil_volume(grid, &state.soil, &Halo::whole()), kinetic_energy(&model, &state, &Halo::whole()));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let mut reported = Instant::now();
    let mut stress = 0.0_f64;
    while state.time < runner.lasting(TAU / rate) {
        step(&model, &mut state, &mut workspace)?;
        if state.step.is_multiple_of(100) {
            stress = stress.max(root_mean_square(&model, &state));
        }
        if reported.elapsed() > Duration::from_secs(15) {
            reported = Instant::now();
            runner.report_progress(&format!("A3: {variant}, {:.0} %", 1e2 * state.time * rate / TAU));
        }
    }
    let seconds = clock.elapsed().as_secs_f64();
    runner.report_progress(&format!("A3: {variant}, {} steps in {seconds:.1} s", state.step));
    let misplaced =
        0.5 * over_cells(grid, |c, size| (state.soil.fraction[c] - fraction[c]).abs() * size) / volume;
    let figures = [
        ("volume over the initial volume", soil_volume(grid, &state.soil, &Halo::whole()) / volume),
        ("largest stress, root mean square over E", stress / YOUNG),
        ("shape error", misplaced),
        ("kinetic energy over the initial energy", kinetic_energy(&model, &state, &Halo::whole()) / kinetic),
    ];
    runner.put("A3", variant, seconds, &figures)
}

/// Root of the mean squared stress (Frobenius norm) over the soil [Pa].
fn root_mean_square(model: &Model, state: &State) -> f64 {
    let soil = &state.soil;
    let squared = over_cells(&model.grid, |c, size| {
        let s = soil.stress.each_ref().map(|field| field[c]);
        soil.fraction[c] * size * contract(s, s)
    });
    (squared / soil_volume(&model.grid, soil, &Halo::whole())).sqrt()
}

/// The model of an empty slab round the origin, one cell thick.
fn empty_slab(cell: f64) -> Model {
    let n = (0.625 / cell).round();
    let faces = |from: f64, to: f64| {
        let count = (to - from).round() as usize;
        (0..=count).map(|i| (from + i as f64) * cell).collect::<Vec<f64>>()
    };
    let grid = Grid::new([faces(-n, n), faces(-0.5, 0.5), faces(-n, n)]);
    Model::bare(grid, Material::linear_elastic(Elastic::new(YOUNG, 0.3), 1600.0))
}
