//! A4: sand at rest stays at rest.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use glam::DVec3;
use solver::initial::{Filling, at_rest};
use solver::step::step;
use solver::workspace::Workspace;
use std::time::Instant;

const CASE: &str = include_str!("../validation/A4_soil_at_rest/case.toml");
/// Heights of the surface above a face of the grid, in cells.
const HEIGHTS: [f64; 4] = [0.0, 0.5, 0.01, 0.99];
const STEPS: usize = 10_000;
/// Whether a remap is forced in every step, and the width of the cells along x and y over that along z.
const VARIANTS: [(&str, bool, u32); 4] = [
    ("10⁴ steps", false, 1),
    ("10⁴ steps, remap in each", true, 1),
    ("10⁴ steps, flat cells 3:3:1", false, 3),
    ("10⁴ steps, remap in each, flat cells 3:3:1", true, 3),
];
/// Width of the cells along x and y in the case file [m].
const CELL: f64 = 0.05;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (variant, every_step, flatness) in VARIANTS {
        let clock = Instant::now();
        let (mut speed, mut stress) = (0.0_f64, [0.0_f64; 2]);
        for height in HEIGHTS {
            let (fastest, error) = rest(runner, height, every_step, flatness)?;
            speed = speed.max(fastest);
            stress = [stress[0].max(error[0]), stress[1].max(error[1])];
        }
        let seconds = clock.elapsed().as_secs_f64();
        runner.report_progress(&format!("A4: {variant}, {seconds:.1} s"));
        let figures = [
            ("largest speed [m/s]", speed),
            ("deviation of the vertical stress from the profile", stress[0]),
            ("deviation of the horizontal stress from the profile", stress[1]),
        ];
        runner.put("A4", variant, seconds, &figures)?;
    }
    Ok(())
}

/// Largest speed [m/s], and largest relative deviations of vertical and horizontal stress.
fn rest(
    runner: &mut Runner,
    height: f64,
    every_step: bool,
    flatness: u32,
) -> Result<(f64, [f64; 2]), VerifyError> {
    let overrides = [
        format!("grid.cell={} m", CELL / f64::from(flatness)),
        format!("grid.aspect=[{flatness}, {flatness}, 1]"),
    ];
    let Simulation { mut model, .. } = runner.simulation(CASE, &overrides)?;
    let cell = model.grid.finest();
    let surface = height * cell;
    if every_step {
        model.method.remap_displacement = -1.0;
    }
    let mut state =
        at_rest::<f64>(&model, &Filling::between(DVec3::splat(-1e9), DVec3::new(1e9, 1e9, surface)));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let mut speed = 0.0_f64;
    for _ in 0..runner.lasting(STEPS) {
        step(&model, &mut state, &mut workspace)?;
        speed = state.nodes.velocity.iter().flatten().fold(speed, |most, v| most.max(v.abs()));
    }
    let grid = &model.grid;
    let weight = model.material().density * model.soil_gravity;
    let scale = weight * (surface - grid.faces[2][0]);
    let mut error = [0.0_f64; 2];
    for k in 0..grid.cells()[2] {
        let c = grid.index(0, 0, k);
        if state.soil.fraction[c] == 1.0 {
            let vertical = -weight * (surface - grid.centre(2, k));
            error[0] = error[0].max((state.soil.stress[2][c] - vertical).abs() / scale);
            let horizontal = model.material().k0 * vertical;
            error[1] = error[1].max((state.soil.stress[0][c] - horizontal).abs() / scale);
        }
    }
    Ok((speed, error))
}
