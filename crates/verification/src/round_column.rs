//! C2: collapse of a round column of sand, in three dimensions.

use crate::advection::fill;
use crate::error::VerifyError;
use crate::probe::thickness;
use crate::row::Row;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use glam::DVec3;
use std::f64::consts::PI;

const CASE: &str = include_str!("../../../validation/C2_round_column/case.toml");
const RUN_OUT: &str = "Lube et al. (2004): 1.24 a for a < 1.7, then 1.6 √a";
const HEIGHT: &str = "Lube et al. (2004): a for a < 1, 0.88 a^⅙ for a > 1.7";
/// Radius of the column [m].
const RADIUS: f64 = 0.1;
/// Thickness of the sand at the front, in cells.
const FRONT: f64 = 0.5;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A quarter of a round column of dry sand (aspect ratio a = H/r₀) collapses on a floor without slip. The radius \
    of the deposit is that of a circle of the area in which it is more than half a cell thick; the run-out (r − r₀)/r₀ must be the \
    published one within 15 %. The ratio of the fronts along the diagonal of the grid and along x is given for information and should be 1. \
    The height, that of the column of cells at the axis, is compared without a tolerance.";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variants: &[(f64, u32, u32)] = if runner.options.fast {
        &[(1.0, 31, 10)]
    } else {
        &[
            (0.6, 31, 10),
            (1.0, 31, 10),
            (2.0, 31, 10),
            (3.0, 31, 10),
            (0.6, 31, 20),
            (1.0, 31, 20),
            (2.0, 31, 20),
            (3.0, 31, 20),
            (0.6, 37, 10),
            (1.0, 37, 10),
            (2.0, 37, 10),
            (3.0, 37, 10),
            (0.6, 37, 20),
            (1.0, 37, 20),
            (2.0, 37, 20),
            (3.0, 37, 20),
            (0.6, 37, 40),
            (1.0, 37, 40),
        ]
    };
    for &(a, angle, cells) in variants {
        let name = format!("a = {a}, φ = {angle}°, r₀/h = {cells}");
        runner
            .part("C2", &name, |runner| collapse(runner, &name, [a, f64::from(angle), f64::from(cells)]))?;
    }
    Ok(())
}

fn collapse(runner: &mut Runner, variant: &str, [a, angle, cells]: [f64; 3]) -> Result<(), VerifyError> {
    let height = a * RADIUS;
    // Space for a run-out a third longer than the published one.
    let cell = RADIUS / cells;
    let extent = (RADIUS * (1.0 + 1.35 * run_out(a)) / cell).ceil() * cell;
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("ground.surface={height} m"),
        format!("grid.cell={cell} m"),
        format!("domain.x=['0 m', '{extent} m']"),
        format!("domain.y=['0 m', '{extent} m']"),
        format!("domain.z=['0 m', '{} m']", ((height / cell).round() + 2.0) * cell),
    ];
    let case = runner.simulation(CASE, &overrides)?.case;
    let mut simulation = Simulation::filled(&case, |grid| {
        let mut fraction = vec![0.0; grid.entries];
        fill(grid, |x| x.x.hypot(x.y) <= RADIUS && x.z <= height, &mut fraction);
        fraction
    });
    runner.finish("C2", variant, &mut simulation)?;
    let limit = FRONT * cell;
    let area = 4.0 * area(&simulation, limit);
    let end = (area / PI).sqrt();
    let along = |direction: [usize; 2]| ray(&simulation, limit, direction);
    let info = |quantity, value| Row::info("C2", variant, quantity, value).took(simulation.wall_s);
    let tall = if a < 1.0 {
        [a; 2]
    } else if a > 1.7 {
        [0.88 * a.powf(1.0 / 6.0); 2]
    } else {
        [0.88, 1.0]
    };
    runner.rows.extend([
        info("run-out (r − r₀)/r₀", (end - RADIUS) / RADIUS).within(run_out(a), 0.15, RUN_OUT),
        info("front along the diagonal over that along x", along([1, 1]) / along([1, 0])),
        info("final height over r₀", thickness(&simulation, 0, 0) / RADIUS)
            .compared_with(tall[0], tall[1], HEIGHT),
    ]);
    Ok(())
}

fn run_out(a: f64) -> f64 {
    if a < 1.7 { 1.24 * a } else { 1.6 * a.sqrt() }
}

/// Area in which the sand is thicker than `limit` [m²].
fn area(simulation: &Simulation, limit: f64) -> f64 {
    let grid = &simulation.model.grid;
    let [nx, ny, _] = grid.cells();
    let columns = (0..nx).flat_map(|i| (0..ny).map(move |j| (i, j)));
    let thick = columns.filter(|(i, j)| thickness(simulation, *i, *j) > limit);
    thick.map(|(i, j)| grid.width(0, i) * grid.width(1, j)).sum()
}

/// How far from the axis the sand reaches along a direction of the grid [m], between columns of cells.
fn ray(simulation: &Simulation, limit: f64, [right, back]: [usize; 2]) -> f64 {
    let grid = &simulation.model.grid;
    let at = |n: usize| thickness(simulation, n * right, n * back);
    let Some(first) = (1..grid.cells()[0]).find(|n| at(*n) < limit) else { return f64::NAN };
    let ratio = (at(first - 1) - limit) / (at(first - 1) - at(first));
    let radius = |n: usize| DVec3::new(grid.centre(0, n * right), grid.centre(1, n * back), 0.0).length();
    radius(first - 1) * (1.0 - ratio) + radius(first) * ratio
}
