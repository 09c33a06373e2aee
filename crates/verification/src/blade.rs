//! F2: the pressure of the sand in front of a blade at 45°.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::output::fields::shown_pressure;
use coulter::simulation::Simulation;
use glam::DVec3;
use physics::tensor::mean;

const CASE: &str = include_str!("../validation/F2_pressure_before_a_blade/case.toml");
/// Rise of the plane that bounds the sheared zone below, 45° − φ/2 with the φ of the case file [°].
const RISE: f64 = 27.5;
/// Distance of the zone from the blade, in cell widths.
const CLEARANCE: f64 = 2.0;
/// Displacement from which the drag is read [m].
const STEADY: f64 = 0.04;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "H/h = 16";
    if !runner.wants("F2", variant)? {
        return Ok(());
    }
    let mut simulation = runner.simulation(CASE, &[])?;
    let [at_rest, _] = roughness(&simulation, |cell| pressure_of(&simulation, cell));
    runner.finish("F2", variant, &mut simulation)?;
    let [departure, checkerboard] = roughness(&simulation, |cell| pressure_of(&simulation, cell));
    let shown = shown_pressure(&simulation.model.grid, &simulation.state);
    let columns = simulation.model.grid.cells()[0];
    let [written, written_checkerboard] = roughness(&simulation, |[i, k]| shown[k * columns + i]);
    let figures = [
        ("departure from the four neighbours over the mean, at rest", at_rest),
        ("departure from the four neighbours over the mean", departure),
        ("checkerboard over the mean", checkerboard),
        ("departure from the four neighbours over the mean, as written", written),
        ("checkerboard over the mean, as written", written_checkerboard),
        ("scatter of the drag over its mean", scatter(&simulation)),
    ];
    runner.put("F2", variant, simulation.wall_s, &figures)
}

/// Root mean square over the sheared zone, over the mean pressure there: of the departure of the pressure of
/// a column and a layer [Pa] from the mean of the four neighbours in the x–z plane, and of the part that
/// alternates along x and z.
fn roughness(simulation: &Simulation, pressure_of: impl Fn([usize; 2]) -> f64) -> [f64; 2] {
    let [nx, _, nz] = simulation.model.grid.cells();
    let cells = (1..nz - 1).flat_map(|k| (1..nx - 1).map(move |i| [i, k]));
    let zone: Vec<[usize; 2]> = cells.filter(|cell| is_in_zone(simulation, *cell)).collect();
    let (mut pressure, mut departure, mut checkerboard) = (0.0, 0.0, 0.0);
    for [i, k] in &zone {
        let p = |di: usize, dk: usize| pressure_of([i + di - 1, k + dk - 1]);
        let own = p(1, 1);
        let sides = (p(0, 1) + p(2, 1)) + (p(1, 0) + p(1, 2));
        let corners = (p(0, 0) + p(2, 0)) + (p(0, 2) + p(2, 2));
        pressure += own;
        departure += (own - 0.25 * sides).powi(2);
        checkerboard += ((4.0 * own - 2.0 * sides + corners) / 16.0).powi(2);
    }
    let count = zone.len() as f64;
    [departure, checkerboard].map(|squares| (squares / count).sqrt() / (pressure / count))
}

/// Pressure in the cell of a column and a layer [Pa].
fn pressure_of(simulation: &Simulation, [i, k]: [usize; 2]) -> f64 {
    let c = simulation.model.grid.index(i, 0, k);
    -mean(simulation.state.soil.stress.each_ref().map(|component| component[c]))
}

/// Whether the cell of a column and a layer lies in the sheared zone: above the plane that rises from the
/// toe, clear of the blade, and like its eight neighbours full of soil.
fn is_in_zone(simulation: &Simulation, [i, k]: [usize; 2]) -> bool {
    let Simulation { model, state, .. } = simulation;
    let grid = &model.grid;
    let pose = state.pose(0);
    let centre = DVec3::new(grid.centre(0, i), grid.centre(1, 0), grid.centre(2, k));
    let from_blade =
        model.bodies[0].shape.signed_distance(pose.rotation.inverse() * (centre - pose.position));
    let toe = pose.position.x - model.bodies[0].start.position.x;
    let plane = grid.faces[2][0] + RISE.to_radians().tan() * (centre.x - toe);
    let is_full = |i: usize, k: usize| state.soil.fraction[grid.index(i, 0, k)] > 0.999;
    from_blade > CLEARANCE * grid.finest()
        && centre.z > plane
        && (i - 1..=i + 1).all(|i| (k - 1..=k + 1).all(|k| is_full(i, k)))
}

/// Standard deviation of the drag over its mean, of the samples of the second half of the push.
fn scatter(simulation: &Simulation) -> f64 {
    let samples = simulation.history.bodies[0].iter().filter(|sample| sample.displacement > STEADY);
    let drag: Vec<f64> = samples.map(|sample| sample.drag).collect();
    let count = drag.len() as f64;
    let mean = drag.iter().sum::<f64>() / count;
    let squares: f64 = drag.iter().map(|drag| (drag - mean).powi(2)).sum();
    (squares / count).sqrt() / mean
}
