//! A10: a copper bar hits a rigid wall end on.

use crate::error::VerifyError;
use crate::probe::thickness;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use solver::fields::PLASTIC_STRAIN;
use std::f64::consts::PI;

const CASE: &str = include_str!("../validation/A10_taylor_bar/case.toml");
const ON_BLOCK: &str = include_str!("../validation/A10_taylor_bar/on_block.toml");
/// Radius of the bar in the case file [mm].
const BAR: f64 = 3.2;
const DEVIATION: &str = "largest deviation of the length during the impact";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variants: &[(&str, &str, u32)] =
        &[("R/h = 8", CASE, 8), ("R/h = 16", CASE, 16), ("on a rigid block, R/h = 8", ON_BLOCK, 8)];
    for &(name, case, cells) in variants {
        if runner.wants("A10", name)? {
            runner.part("A10", name, |runner| impact(runner, name, case, cells))?;
        }
    }
    Ok(())
}

fn impact(runner: &mut Runner, variant: &str, case: &str, cells: u32) -> Result<(), VerifyError> {
    let mut simulation = runner.simulation(case, &[format!("grid.cell={} mm", BAR / f64::from(cells))])?;
    let mut lengths = vec![(0.0, length(&simulation))];
    runner.finish_watched("A10", variant, &mut simulation, |now| {
        lengths.push((now.state.time, length(now)));
    })?;
    let soil = &simulation.state.soil;
    let strains =
        soil.history[PLASTIC_STRAIN].iter().zip(&soil.fraction).filter(|(_, fraction)| **fraction > 0.5);
    let curve = &runner.expectation("A10", variant, DEVIATION)?.curve;
    let figures = [
        ("final length [mm]", length(&simulation)),
        ("radius of the foot [mm]", foot(&simulation)),
        (DEVIATION, length_error(&lengths, curve)),
        ("largest equivalent plastic strain", strains.map(|(e, _)| *e).fold(0.0, f64::max)),
        ("foot along the diagonal over that along x", roundness(&simulation)),
    ];
    runner.put("A10", variant, simulation.wall_s, &figures)
}

/// Length of the bar at its axis [mm].
fn length(simulation: &Simulation) -> f64 {
    1e3 * thickness(simulation, 0, 0)
}

/// Largest relative deviation from a curve: the length every 10 µs after the impact [mm].
fn length_error(lengths: &[(f64, f64)], curve: &[f64]) -> f64 {
    let at = |time: f64| {
        let [(before, first), (after, second)] = lengths
            .windows(2)
            .find(|pair| pair[1].0 >= time)
            .or_else(|| lengths.windows(2).last())
            .map_or([(f64::NAN, f64::NAN); 2], |pair| [pair[0], pair[1]]);
        first + (second - first) * ((time - before) / (after - before)).min(1.0)
    };
    let errors = curve.iter().enumerate().map(|(n, exact)| (at(1e-5 * (n + 1) as f64) / exact - 1.0).abs());
    // `max` would drop what is not a number.
    errors.fold(0.0, |most, error| if error > most || error.is_nan() { error } else { most })
}

/// Lowest layer of cells above the wall, which is at z = 0.
fn lowest(simulation: &Simulation) -> usize {
    let grid = &simulation.model.grid;
    (0..grid.cells()[2]).find(|k| grid.centre(2, *k) > 0.0).unwrap_or(0)
}

/// Radius of the foot at the wall [mm].
fn foot(simulation: &Simulation) -> f64 {
    let wall = lowest(simulation);
    let [low, middle, high] = [wall, wall + 1, wall + 2].map(|layer| radius(simulation, layer));
    (15.0 * low - 10.0 * middle + 3.0 * high) / 8.0
}

/// Radius of the circle that has the area of the bar in a layer of cells [mm].
fn radius(simulation: &Simulation, layer: usize) -> f64 {
    let (grid, fraction) = (&simulation.model.grid, &simulation.state.soil.fraction);
    let [nx, ny, _] = grid.cells();
    let columns = (0..nx).flat_map(|i| (0..ny).map(move |j| (i, j)));
    let area = |(i, j)| fraction[grid.index(i, j, layer)] * grid.width(0, i) * grid.width(1, j);
    1e3 * (4.0 * columns.map(area).sum::<f64>() / PI).sqrt()
}

/// How far the lowest layer reaches along the diagonal over how far along x.
fn roundness(simulation: &Simulation) -> f64 {
    let (grid, fraction) = (&simulation.model.grid, &simulation.state.soil.fraction);
    let wall = lowest(simulation);
    let reach = |back: usize| {
        (0..grid.cells()[0]).map(|n| fraction[grid.index(n, n * back, wall)] * grid.width(0, n)).sum::<f64>()
    };
    reach(1) * 2_f64.sqrt() / reach(0)
}
