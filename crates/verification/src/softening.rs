//! B5n: a smooth wall pushed into a bank of sand that softens, with a characteristic length.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../validation/B5n_softening_bank/case.toml");
/// Height of the bank in the case file [m].
const HEIGHT: f64 = 1.0;
/// Cells over the height.
const MESHES: [u32; 3] = [32, 64, 128];
/// Displacements over the height at which K_p is read, as the mean over [`WINDOW`] to either side.
const STATIONS: [f64; 9] = [0.02, 0.04, 0.06, 0.08, 0.1, 0.12, 0.14, 0.16, 0.18];
const WINDOW: f64 = 0.01;
/// Side of the square of looser sand at the wall's toe, from which the failure starts [m].
const LOOSE: f64 = 0.2;
/// Part of the density by which it is lighter.
const LIGHTER: f64 = 0.06;
/// Height of the line across which the width of the band is read, over that of the bank, from the floor.
const LINE: f64 = 0.5;
const K_P: &str = "K_p over the undisturbed height";
const WIDTH: &str = "width of the band at half the height [mm]";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for cells in MESHES {
        let variant = name(cells);
        if runner.wants("B5n", &variant)? {
            runner.part("B5n", &variant, |runner| push(runner, cells))?;
        }
    }
    compare(runner)
}

fn name(cells: u32) -> String {
    format!("H/h = {cells}")
}

/// The variant of a mesh at a station.
fn at(mesh: &str, station: f64) -> String {
    format!("{mesh}, u = {station} H")
}

/// How much the meshes differ.
fn compare(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "H/h = 32, 64, 128";
    if !runner.wants("B5n", variant)? {
        return Ok(());
    }
    for station in STATIONS {
        let found = MESHES.map(|cells| runner.obtained("B5n", &at(&name(cells), station), K_P));
        runner.put("B5n", &at(variant, station), 0.0, &[("difference of K_p", spread(found))])?;
    }
    let found = MESHES.map(|cells| runner.obtained("B5n", &name(cells), WIDTH));
    runner.put("B5n", variant, 0.0, &[("difference of the width of the band", spread(found))])
}

/// The range over the mean.
fn spread(found: [f64; 3]) -> f64 {
    let [low, high] = [f64::min, f64::max].map(|of| found.into_iter().fold(found[0], of));
    3.0 * (high - low) / found.iter().sum::<f64>()
}

fn push(runner: &mut Runner, cells: u32) -> Result<(), VerifyError> {
    let variant = name(cells);
    let mut simulation = runner.simulation(CASE, &[format!("grid.cell={} m", HEIGHT / f64::from(cells))])?;
    loosen(&mut simulation);
    runner.finish("B5n", &variant, &mut simulation)?;
    let unit = 0.5 * simulation.case.soil.unit_weight * HEIGHT * HEIGHT;
    let samples = &simulation.history.bodies[0];
    let k_p = |station: f64| {
        let from_to = [station - WINDOW, station + WINDOW].map(|u| u * HEIGHT);
        mean(samples, from_to, |s| s.displacement, |s| s.drag) / unit
    };
    for station in STATIONS {
        runner.put("B5n", &at(&variant, station), simulation.wall_s, &[(K_P, k_p(station))])?;
    }
    runner.put("B5n", &variant, simulation.wall_s, &[(WIDTH, 1e3 * width(&simulation))])
}

/// Makes the sand at the toe of the wall looser, and that of the whole bank so much denser that its mass
/// stays.
fn loosen(simulation: &mut Simulation) {
    let grid = &simulation.model.grid;
    let mass = &mut simulation.state.soil.mass;
    // Part of the width of a cell that the square covers, which begins at `low`.
    let covered = |axis: usize, n: usize, low: f64| {
        let (from, to) = (grid.faces[axis][n].max(low), grid.faces[axis][n + 1].min(low + LOOSE));
        (to - from).max(0.0) / grid.width(axis, n)
    };
    let (mut total, mut removed) = (0.0, 0.0);
    for k in 0..grid.cells()[2] {
        for i in 0..grid.cells()[0] {
            let lighter = LIGHTER * covered(0, i, 0.0) * covered(2, k, grid.faces[2][0]);
            let c = grid.index(i, 0, k);
            total += mass[c];
            removed += lighter * mass[c];
            mass[c] *= 1.0 - lighter;
        }
    }
    for mass in mass.iter_mut() {
        *mass *= total / (total - removed);
    }
}

/// Length of the line across the bank along which the plastic strain exceeds half of its largest value
/// there [m], interpolated between cells.
fn width(simulation: &Simulation) -> f64 {
    let grid = &simulation.model.grid;
    let height = grid.faces[2][0] + LINE * HEIGHT;
    let Some(k) = (0..grid.cells()[2]).find(|k| grid.faces[2][k + 1] > height) else { return f64::NAN };
    let strain = &simulation.state.soil.history[solver::fields::PLASTIC_STRAIN];
    let points: Vec<[f64; 2]> =
        (0..grid.cells()[0]).map(|i| [grid.centre(0, i), strain[grid.index(i, 0, k)]]).collect();
    let half = 0.5 * points.iter().fold(0.0, |most: f64, point| most.max(point[1]));
    let above = |pair: &[[f64; 2]]| {
        let [low, high] = [pair[0][1].min(pair[1][1]), pair[0][1].max(pair[1][1])];
        let part = if high > low { (high - half) / (high - low) } else { f64::from(u8::from(low > half)) };
        part.clamp(0.0, 1.0) * (pair[1][0] - pair[0][0])
    };
    points.windows(2).map(above).sum()
}
