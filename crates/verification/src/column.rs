//! C1: collapse of a column of sand in plane strain.

use crate::error::VerifyError;
use crate::probe::thickness;
use crate::row::Row;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../../../validation/C1_column_collapse/case.toml");
const SOURCE: &str =
    "Lube et al. (2005): 1.2 a, 1.9 a^⅔ for a > 2.8; Lajeunesse et al. (2005): 1.8 a, 2.3 a^⅔ for a ≥ 3";
const HEIGHTS: &str = "Lube et al. (2005): a for a < 1.15, else 0.65 a^0.4; Lajeunesse et al. (2005): a for a < 0.7, then 0.895 a^⅓";
const CONVERGES: &str = "design requirement: converging";
/// Half width of the column in the case file [m].
const WIDTH: f64 = 0.1;
/// Thickness of the soil at the front, in cells.
const FRONT: f64 = 0.5;
/// Thickness at the front by another definition, the same on every grid, over the width of the column.
const FRONT_FIXED: f64 = 0.025;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A column of dry sand (aspect ratio a = H/L₀, one side a plane of symmetry) collapses on a floor \
    without slip. The front is where the soil is half a cell thick, counted from the column outwards; the run-out \
    (L − L₀)/L₀ must lie between two published laws ± 10 %, and so must the final height at the plane of symmetry. From grid to grid \
    (L₀/h = 10, 20, 40) the run-out must change by less and less; for that the front has a fixed thickness, since half a cell \
    means another thickness on every grid.";

/// Aspect ratios that are run with φ = 37°, and with 31°.
const STEEP: [f64; 5] = [0.5, 1.0, 2.0, 3.0, 4.0];
const FLAT: [f64; 4] = [1.0, 2.0, 3.0, 4.0];
const RUN_OUT: &str = "run-out (L − L₀)/L₀";
const RUN_OUT_FIXED: &str = "run-out, front where 0.025 L₀ thick";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    if runner.options.fast {
        return collapse(runner, 37, 1.0, 20);
    }
    for a in STEEP {
        for cells in [10, 20, 40] {
            runner.part("C1", &name(37, a, cells), |runner| collapse(runner, 37, a, cells))?;
        }
        let at = |cells| runner.obtained("C1", &name(37, a, cells), RUN_OUT_FIXED);
        let [coarse, middle, fine] = [at(10), at(20), at(40)];
        let ratio = ((fine - middle) / (middle - coarse)).abs();
        let case = format!("a = {a}, φ = 37°, L₀/h = 10, 20, 40");
        runner.rows.push(
            Row::info("C1", case, "change of the run-out over the previous change", ratio)
                .at_most(1.0, CONVERGES),
        );
    }
    for a in FLAT {
        for cells in [20, 40] {
            runner.part("C1", &name(31, a, cells), |runner| collapse(runner, 31, a, cells))?;
        }
    }
    Ok(())
}

/// Run-out for a = 1, φ = 37° on a mesh of this many cells over L₀; the front is where the sand is 0.025 L₀ thick.
pub(crate) fn run_out_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    collapse(runner, 37, 1.0, cells)?;
    Ok(runner.obtained("C1", &name(37, 1.0, cells), RUN_OUT_FIXED))
}

fn name(angle: u32, a: f64, cells: u32) -> String {
    format!("a = {a}, φ = {angle}°, L₀/h = {cells}")
}

/// Run-outs of the two laws; where a law leaves a gap between its two parts, the first is extended up to the second.
fn run_outs(a: f64) -> [f64; 2] {
    let power = a.powf(2.0 / 3.0);
    let lube = if a < 2.8 { 1.2 * a } else { 1.9 * power };
    let lajeunesse = if a < 3.0 { 1.8 * a } else { 2.3 * power };
    [lube, lajeunesse]
}

/// Final heights of the two laws over L₀, the lower one first. Lajeunesse's factor of a^⅓ is read from the line through
/// the measured points in the figure (1.92 at a = 10, 2.78 at a = 30).
fn heights(a: f64) -> [f64; 2] {
    let lube = if a < 1.15 { a } else { 0.65 * a.powf(0.4) };
    let lajeunesse = if a < 0.7 { a } else { 0.895 * a.cbrt() };
    [lube.min(lajeunesse), lube.max(lajeunesse)]
}

fn collapse(runner: &mut Runner, angle: u32, a: f64, cells: u32) -> Result<(), VerifyError> {
    let variant = name(angle, a, cells);
    let mut overrides = vec![
        format!("soil.friction_angle={angle} deg"),
        format!("ground.surface={} m", a * WIDTH),
        format!("grid.cell={} m", WIDTH / f64::from(cells)),
    ];
    if a > 2.0 {
        // Space and time for columns that are higher than the box of the case file allows for.
        overrides.extend([
            "domain.x=['0 m', '1 m']".to_owned(),
            "domain.z=['0 m', '0.45 m']".to_owned(),
            "run.duration=1 s".to_owned(),
        ]);
    }
    let mut simulation = runner.simulation(CASE, &overrides)?;
    let mut late = f64::NAN;
    runner.finish_watched("C1", &variant, &mut simulation, |now| {
        if late.is_nan() && now.state.time >= 0.9 * now.case.duration {
            late = front(now, FRONT * now.case.grid.cell);
        }
    })?;
    let cell = simulation.case.grid.cell;
    let end = front(&simulation, FRONT * cell);
    let fixed = front(&simulation, FRONT_FIXED * WIDTH);
    let info = |quantity, value| Row::info("C1", variant.as_str(), quantity, value).took(simulation.wall_s);
    let run_out = info(RUN_OUT, (end - WIDTH) / WIDTH);
    let height = info("final height over L₀", thickness(&simulation, 0, 0) / WIDTH);
    // The coarsest grid only serves the study of convergence.
    let ([near, far], [low, high]) = (run_outs(a), heights(a));
    runner.rows.extend([
        if cells < 20 { run_out } else { run_out.between(near, far, 0.1, SOURCE) },
        info(RUN_OUT_FIXED, (fixed - WIDTH) / WIDTH),
        if cells < 20 { height } else { height.between(low, high, 0.1, HEIGHTS) },
        info("travel of the front in the last tenth of the time [cells]", (end - late) / cell),
    ]);
    Ok(())
}

/// Where the soil's thickness falls below `limit` [m], from the plane of symmetry outwards [m].
fn front(simulation: &Simulation, limit: f64) -> f64 {
    let grid = &simulation.model.grid;
    let columns = grid.cells()[0];
    let Some(first) = (0..columns).find(|i| thickness(simulation, *i, 0) < limit) else { return f64::NAN };
    if first == 0 {
        return f64::NAN;
    }
    let (inner, outer) = (thickness(simulation, first - 1, 0), thickness(simulation, first, 0));
    let ratio = (inner - limit) / (inner - outer);
    grid.centre(0, first - 1) * (1.0 - ratio) + grid.centre(0, first) * ratio
}
