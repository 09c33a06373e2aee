//! A10: a copper bar hits a rigid wall end on.

use crate::error::VerifyError;
use crate::probe::thickness;
use crate::row::Row;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use solver::fields::PLASTIC_STRAIN;
use std::f64::consts::PI;

const CASE: &str = include_str!("../../../validation/A10_taylor_bar/case.toml");
const ON_BLOCK: &str = include_str!("../../../validation/A10_taylor_bar/on_block.toml");
const LENGTH: &str = "Lagrangian codes; tetrahedra at h = 0.38 mm: 21.42 mm";
const RADIUS: &str = "range of the design; tetrahedra at h = 0.38 mm: 7.23 mm";
const STRAIN: &str = "range of DYNA2D, DYNA3D, NIKE2D";
const HISTORY: &str = "tetrahedra at h = 0.38 mm";
/// Radius of the bar in the case file [mm].
const BAR: f64 = 3.2;
/// Length of the bar every 10 µs after the impact, of quadratic tetrahedra (TET15-P1) at h = 0.38 mm [mm]:
/// github.com/Cthonios/Carina.jl, benchmark/tet15-p1/taylor/data.
const LENGTHS: [f64; 8] = [30.14043, 28.06271, 26.18498, 24.55638, 23.21468, 22.20498, 21.58340, 21.42023];

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A copper bar (L = 32.4 mm, R = 3.2 mm, σ_y = 400 MPa, H = 100 MPa), flying at 227 m/s, hits a smooth \
    rigid wall; a quarter is modelled, the wall is the floor of the box. After 80 µs it has come to rest: its length must be that of \
    Lagrangian codes within 1.5 %, and so must the radius of its foot, extrapolated to the wall by the parabola through the three lowest \
    layers of cells. During the impact the length is compared every 10 µs with a Lagrangian run on quadratic tetrahedra. In one variant \
    the bar hits a rigid block instead, by contact.";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variants: &[(&str, &str, u32)] =
        &[("R/h = 8", CASE, 8), ("R/h = 16", CASE, 16), ("on a rigid block, R/h = 8", ON_BLOCK, 8)];
    let count = if runner.options.fast { 1 } else { variants.len() };
    for &(name, case, cells) in &variants[..count] {
        runner.part("A10", name, |runner| impact(runner, name, case, cells))?;
    }
    Ok(())
}

fn impact(runner: &mut Runner, variant: &str, case: &str, cells: u32) -> Result<(), VerifyError> {
    let mut simulation = runner.simulation(case, &[format!("grid.cell={} mm", BAR / f64::from(cells))])?;
    let mut lengths = vec![(0.0, length(&simulation))];
    runner.finish_watched("A10", variant, &mut simulation, |now| {
        lengths.push((now.state.time, length(now)));
    })?;
    let info = |quantity, value| Row::info("A10", variant, quantity, value).took(simulation.wall_s);
    let soil = &simulation.state.soil;
    let strains =
        soil.history[PLASTIC_STRAIN].iter().zip(&soil.fraction).filter(|(_, fraction)| **fraction > 0.5);
    runner.rows.extend([
        info("final length [mm]", length(&simulation)).between(21.4, 21.5, 0.015, LENGTH),
        info("radius of the foot [mm]", foot(&simulation)).between(6.8, 7.2, 0.015, RADIUS),
        info("largest deviation of the length during the impact", length_error(&lengths))
            .at_most(0.015, HISTORY),
        info("largest equivalent plastic strain", strains.map(|(e, _)| *e).fold(0.0, f64::max))
            .compared_with(2.5, 3.2, STRAIN),
        info("foot along the diagonal over that along x", roundness(&simulation)),
    ]);
    Ok(())
}

/// Length of the bar at its axis [mm].
fn length(simulation: &Simulation) -> f64 {
    1e3 * thickness(simulation, 0, 0)
}

/// Largest relative deviation from the length of the Lagrangian run.
fn length_error(lengths: &[(f64, f64)]) -> f64 {
    let at = |time: f64| {
        let [(before, first), (after, second)] = lengths
            .windows(2)
            .find(|pair| pair[1].0 >= time)
            .or_else(|| lengths.windows(2).last())
            .map_or([(f64::NAN, f64::NAN); 2], |pair| [pair[0], pair[1]]);
        first + (second - first) * ((time - before) / (after - before)).min(1.0)
    };
    let errors = LENGTHS.iter().enumerate().map(|(n, exact)| (at(1e-5 * (n + 1) as f64) / exact - 1.0).abs());
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
