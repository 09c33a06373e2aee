//! C2: collapse of a round column of sand, in three dimensions.

use crate::advection::fill;
use crate::column::Soil;
use crate::error::VerifyError;
use crate::probe::thickness;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use glam::DVec3;
use std::f64::consts::PI;

const CASE: &str = include_str!("../validation/C2_round_column/case.toml");
const SAND: &str = include_str!("../validation/C2_round_column/sand.toml");
/// Radius of the column [m].
const RADIUS: f64 = 0.1;
/// Thickness of the sand at the front, in cells.
const FRONT: f64 = 0.5;

const RUN_OUT: &str = "run-out (r − r₀)/r₀";

/// Aspect ratio, friction angle [°] and cells over the radius.
const VARIANTS: [[f64; 3]; 18] = [
    [0.6, 31.0, 10.0],
    [1.0, 31.0, 10.0],
    [2.0, 31.0, 10.0],
    [3.0, 31.0, 10.0],
    [0.6, 31.0, 20.0],
    [1.0, 31.0, 20.0],
    [2.0, 31.0, 20.0],
    [3.0, 31.0, 20.0],
    [0.6, 37.0, 10.0],
    [1.0, 37.0, 10.0],
    [2.0, 37.0, 10.0],
    [3.0, 37.0, 10.0],
    [0.6, 37.0, 20.0],
    [1.0, 37.0, 20.0],
    [2.0, 37.0, 20.0],
    [3.0, 37.0, 20.0],
    [0.6, 37.0, 40.0],
    [1.0, 37.0, 40.0],
];

/// Aspect ratio and cells over the radius, of sand with its density as state.
const OF_SAND: [[f64; 2]; 6] = [[0.6, 10.0], [1.0, 10.0], [2.0, 10.0], [3.0, 10.0], [0.6, 20.0], [1.0, 20.0]];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let constant = VARIANTS.map(|[a, angle, cells]| (Soil::MohrCoulomb(angle), [a, cells]));
    let sand = OF_SAND.map(|sizes| (Soil::Sand, sizes));
    for (soil, sizes @ [a, cells]) in constant.into_iter().chain(sand) {
        let name = format!("a = {a}, {}, r₀/h = {cells}", soil.name());
        if runner.wants("C2", &name)? {
            runner.part("C2", &name, |runner| collapse(runner, &name, soil, sizes))?;
        }
    }
    Ok(())
}

fn collapse(runner: &mut Runner, variant: &str, soil: Soil, [a, cells]: [f64; 2]) -> Result<(), VerifyError> {
    let height = a * RADIUS;
    // Space for a run-out a third longer than the published one.
    let published = runner.expectation("C2", variant, RUN_OUT)?.value()?;
    let cell = RADIUS / cells;
    let extent = (RADIUS * (1.0 + 1.35 * published) / cell).ceil() * cell;
    let mut overrides = vec![
        format!("ground.surface={height} m"),
        format!("grid.cell={cell} m"),
        format!("domain.x=['0 m', '{extent} m']"),
        format!("domain.y=['0 m', '{extent} m']"),
        format!("domain.z=['0 m', '{} m']", ((height / cell).round() + 2.0) * cell),
    ];
    let (text, angle) = soil.case([CASE, SAND]);
    overrides.extend(angle);
    let case = runner.simulation(text, &overrides)?.case;
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
    let figures = [
        (RUN_OUT, (end - RADIUS) / RADIUS),
        ("front along the diagonal over that along x", along([1, 1]) / along([1, 0])),
        ("final height over r₀", thickness(&simulation, 0, 0) / RADIUS),
    ];
    runner.put("C2", variant, simulation.wall_s, &figures)
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
