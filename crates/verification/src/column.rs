//! C1: collapse of a column of sand in plane strain.

use crate::error::VerifyError;
use crate::probe::thickness;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../validation/C1_column_collapse/case.toml");
const SAND: &str = include_str!("../validation/C1_column_collapse/sand.toml");
/// Half width of the column in the case file [m].
const WIDTH: f64 = 0.1;
/// Thickness of the soil at the front, in cells.
const FRONT: f64 = 0.5;
/// Thickness at the front by another definition, the same on every grid, over the width of the column.
const FRONT_FIXED: f64 = 0.025;

/// Aspect ratios that are run with φ = 37° and with the law for sand, and with φ = 31°.
const STEEP: [f64; 5] = [0.5, 1.0, 2.0, 3.0, 4.0];
const FLAT: [f64; 4] = [1.0, 2.0, 3.0, 4.0];

/// What a column consists of.
#[derive(Clone, Copy)]
pub(crate) enum Soil {
    /// Mohr–Coulomb soil with this friction angle [°] and ψ = 0.
    MohrCoulomb(f64),
    /// Sand with its density as state.
    Sand,
}

impl Soil {
    /// The soil as in the name of a variant.
    pub(crate) fn name(self) -> String {
        match self {
            Self::MohrCoulomb(angle) => format!("φ = {angle}°"),
            Self::Sand => "sand".to_owned(),
        }
    }

    /// Which of two case files, with Mohr–Coulomb soil and with sand, is run, and what is set in it.
    pub(crate) fn case(self, [mohr_coulomb, sand]: [&str; 2]) -> (&str, Option<String>) {
        match self {
            Self::MohrCoulomb(angle) => (mohr_coulomb, Some(format!("soil.friction_angle={angle} deg"))),
            Self::Sand => (sand, None),
        }
    }
}

const STEEP_SOIL: Soil = Soil::MohrCoulomb(37.0);

const RUN_OUT: &str = "run-out (L − L₀)/L₀";
const RUN_OUT_FIXED: &str = "run-out, front where 0.025 L₀ thick";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for a in STEEP {
        for cells in [10, 20, 40] {
            wanted(runner, STEEP_SOIL, a, cells)?;
        }
        convergence(runner, a)?;
    }
    for a in FLAT {
        for cells in [20, 40] {
            wanted(runner, Soil::MohrCoulomb(31.0), a, cells)?;
        }
    }
    for a in STEEP {
        for cells in [20, 40] {
            wanted(runner, Soil::Sand, a, cells)?;
        }
    }
    Ok(())
}

/// Runs a variant if it is part of this verification.
fn wanted(runner: &mut Runner, soil: Soil, a: f64, cells: u32) -> Result<(), VerifyError> {
    let variant = name(soil, a, cells);
    if runner.wants("C1", &variant)? {
        runner.part("C1", &variant, |runner| collapse(runner, soil, a, cells))?;
    }
    Ok(())
}

/// How the run-out changes from mesh to mesh.
fn convergence(runner: &mut Runner, a: f64) -> Result<(), VerifyError> {
    let case = format!("a = {a}, φ = 37°, L₀/h = 10, 20, 40");
    if !runner.wants("C1", &case)? {
        return Ok(());
    }
    let at = |cells| runner.obtained("C1", &name(STEEP_SOIL, a, cells), RUN_OUT_FIXED);
    let [coarse, middle, fine] = [at(10), at(20), at(40)];
    let ratio = ((fine - middle) / (middle - coarse)).abs();
    runner.put("C1", &case, 0.0, &[("change of the run-out over the previous change", ratio)])
}

/// Run-out for a = 1, φ = 37° on a mesh of this many cells over L₀; the front is where the sand is 0.025 L₀
/// thick.
pub(crate) fn run_out_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    collapse(runner, STEEP_SOIL, 1.0, cells)?;
    Ok(runner.obtained("C1", &name(STEEP_SOIL, 1.0, cells), RUN_OUT_FIXED))
}

fn name(soil: Soil, a: f64, cells: u32) -> String {
    format!("a = {a}, {}, L₀/h = {cells}", soil.name())
}

fn collapse(runner: &mut Runner, soil: Soil, a: f64, cells: u32) -> Result<(), VerifyError> {
    let variant = name(soil, a, cells);
    let mut overrides =
        vec![format!("ground.surface={} m", a * WIDTH), format!("grid.cell={} m", WIDTH / f64::from(cells))];
    let (case, angle) = soil.case([CASE, SAND]);
    overrides.extend(angle);
    if a > 2.0 {
        // Space and time for columns that are higher than the box of the case file allows for.
        overrides.extend([
            "domain.x=['0 m', '1 m']".to_owned(),
            "domain.z=['0 m', '0.45 m']".to_owned(),
            "run.duration=1 s".to_owned(),
        ]);
    }
    let mut simulation = runner.simulation(case, &overrides)?;
    let mut late = f64::NAN;
    runner.finish_watched("C1", &variant, &mut simulation, |now| {
        if late.is_nan() && now.state.time >= 0.9 * now.case.duration {
            late = front(now, FRONT * now.case.grid.cell);
        }
    })?;
    let cell = simulation.case.grid.cell;
    let end = front(&simulation, FRONT * cell);
    let fixed = front(&simulation, FRONT_FIXED * WIDTH);
    let figures = [
        (RUN_OUT, (end - WIDTH) / WIDTH),
        (RUN_OUT_FIXED, (fixed - WIDTH) / WIDTH),
        ("final height over L₀", thickness(&simulation, 0, 0) / WIDTH),
        ("travel of the front in the last tenth of the time [cells]", (end - late) / cell),
    ];
    runner.put("C1", &variant, simulation.wall_s, &figures)
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
