//! C1: collapse of a column of sand in plane strain.

use super::bench::{Bench, VerifyError};
use super::row::Row;
use crate::simulation::Simulation;

const CASE: &str = include_str!("../../../../validation/C1_column_collapse/case.toml");
const SOURCE: &str = "Lube et al. (2005): 1.2 a; Lajeunesse et al. (2005): 1.8 a";
const HEIGHTS: &str = "Lube et al. (2005): a for a < 1.15, else 0.65 a^0.4";
/// Half width of the column in the case file [m].
const WIDTH: f64 = 0.1;
/// The front is where the soil is this many cells thick.
const FRONT: f64 = 0.5;

/// What it is about.
pub(super) const ABOUT: &str = "A column of dry sand (aspect a = H/L₀, one side a plane of symmetry) collapses on a floor \
    without slip. The front is where the soil is half a cell thick, counted from the column outwards; the run-out \
    (L − L₀)/L₀ must lie between two published laws ± 10 %. The height is that of the column of cells at the plane of \
    symmetry; no tolerance is set for it.";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    let variants: &[(u32, u32, u32)] = if bench.wish.fast {
        &[(37, 1, 20)]
    } else {
        &[
            (37, 1, 20),
            (37, 1, 40),
            (37, 2, 20),
            (37, 2, 40),
            (31, 1, 20),
            (31, 1, 40),
            (31, 2, 20),
            (31, 2, 40),
        ]
    };
    for &(angle, aspect, cells) in variants {
        collapse(bench, angle, aspect, cells)?;
    }
    Ok(())
}

fn collapse(bench: &mut Bench, angle: u32, aspect: u32, cells: u32) -> Result<(), VerifyError> {
    let variant = format!("a = {aspect}, φ = {angle}°, L₀/h = {cells}");
    let a = f64::from(aspect);
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("ground.surface={} m", a * WIDTH),
        format!("grid.cell={} m", WIDTH / f64::from(cells)),
    ];
    let mut simulation = bench.simulation(CASE, &overrides)?;
    let mut late = f64::NAN;
    while !simulation.is_done() {
        simulation.advance()?;
        if late.is_nan() && simulation.state.time >= 0.9 * simulation.case.duration {
            late = front(&simulation);
        }
    }
    bench.tell(&format!("C1: {variant}, {} steps in {:.1} s", simulation.state.step, simulation.wall_s));
    bench.keep("C1", &variant, &simulation);
    let seconds = simulation.wall_s;
    let end = front(&simulation);
    let mut put = |row: Row| bench.rows.push(row.took(seconds));
    let row = Row::note("C1", variant.as_str(), "run-out (L − L₀)/L₀", (end - WIDTH) / WIDTH);
    put(row.between(1.2 * a, 1.8 * a, 0.1, SOURCE));
    let height = if a < 1.15 { a } else { 0.65 * a.powf(0.4) };
    let row = Row::note("C1", variant.as_str(), "final height over L₀", thickness(&simulation, 0) / WIDTH);
    put(row.beside(height, height, HEIGHTS));
    let cell = simulation.case.grid.cell;
    put(Row::note(
        "C1",
        variant.as_str(),
        "front's way in the last tenth of the time [cells]",
        (end - late) / cell,
    ));
    Ok(())
}

/// Thickness of the soil in column `i` [m].
fn thickness(simulation: &Simulation, i: usize) -> f64 {
    let (grid, fraction) = (&simulation.model.grid, &simulation.state.soil.fraction);
    (0..grid.cells()[2]).map(|k| fraction[grid.index(i, 0, k)] * grid.width(2, k)).sum()
}

/// Where the soil is half a cell thick, from the plane of symmetry outwards [m].
fn front(simulation: &Simulation) -> f64 {
    let grid = &simulation.model.grid;
    let limit = FRONT * simulation.case.grid.cell;
    let columns = grid.cells()[0];
    let Some(first) = (0..columns).find(|i| thickness(simulation, *i) < limit) else { return f64::NAN };
    if first == 0 {
        return f64::NAN;
    }
    let (inner, outer) = (thickness(simulation, first - 1), thickness(simulation, first));
    let share = (inner - limit) / (inner - outer);
    grid.centre(0, first - 1) * (1.0 - share) + grid.centre(0, first) * share
}
