//! B5: a smooth vertical wall pushed into a bank of sand.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../../../validation/B5_passive_wall/case.toml");
/// Height of the bank in the case file [m].
const HEIGHT: f64 = 1.0;
/// Displacements between which the thrust is averaged [m], for a short push and for a long one.
const FROM_TO: [[f64; 2]; 2] = [[0.05 * HEIGHT, 0.1 * HEIGHT], [0.25 * HEIGHT, 0.3 * HEIGHT]];

/// Angles of friction and dilation [°], cells over the height; first the short pushes, then the long ones.
const SHORT: [[u32; 3]; 7] =
    [[30, 0, 8], [30, 0, 16], [35, 0, 16], [40, 0, 16], [30, 30, 16], [35, 35, 16], [40, 40, 16]];
const LONG: [[u32; 3]; 4] = [[30, 0, 16], [30, 30, 16], [35, 35, 16], [40, 40, 16]];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let short = SHORT.into_iter().map(|angles_and_cells| (angles_and_cells, FROM_TO[0]));
    let long = LONG.into_iter().map(|angles_and_cells| (angles_and_cells, FROM_TO[1]));
    for (angles_and_cells, from_to) in short.chain(long) {
        if !runner.wants("B5", &name(angles_and_cells, from_to))? {
            continue;
        }
        let thrust = thrust(runner, angles_and_cells, from_to)?;
        let figures =
            [("K_p, heave included", thrust.heaved), ("K_p over the undisturbed height", thrust.plain)];
        runner.put("B5", &thrust.variant, thrust.seconds, &figures)?;
    }
    Ok(())
}

fn name([angle, dilation, cells]: [u32; 3], [_, to]: [f64; 2]) -> String {
    let suffix = if to > FROM_TO[0][1] { ", pushed 0.3 H" } else { "" };
    format!("φ = {angle}°, ψ = {dilation}°, H/h = {cells}{suffix}")
}

/// K_p with φ = ψ = 30° and the heave included, on a mesh of this many cells over the height.
pub(crate) fn associated_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    Ok(thrust(runner, [30, 30, cells], FROM_TO[0])?.heaved)
}

/// Horizontal thrust over that with K_p = 1.
struct Thrust {
    variant: String,
    /// Over the undisturbed height.
    plain: f64,
    /// Over the weight of the wedge, heave included.
    heaved: f64,
    /// Wall-clock time [s].
    seconds: f64,
}

/// Pushes the wall into sand of these angles of friction and dilation [°], with this many cells over the height.
/// The thrust is averaged between the displacements `from` and `to` [m].
fn thrust(
    runner: &mut Runner,
    angles_and_cells: [u32; 3],
    [from, to]: [f64; 2],
) -> Result<Thrust, VerifyError> {
    let variant = name(angles_and_cells, [from, to]);
    let [angle, dilation, cells] = angles_and_cells;
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={dilation} deg"),
        format!("grid.cell={} m", HEIGHT / f64::from(cells)),
        format!("run.tow_distance={to} m"),
    ];
    let mut simulation = runner.simulation(CASE, &overrides)?;
    let half = 0.5 * f64::from(angle).to_radians();
    let rise = (std::f64::consts::FRAC_PI_4 - half).tan();
    let (mut plain, mut heaved, mut time) = (0.0, 0.0, 0.0);
    while !simulation.is_done() {
        let before = simulation.state.time;
        simulation.advance()?;
        let Some(now) = simulation.history.bodies[0].last().copied() else { continue };
        if now.displacement >= from && now.displacement <= to {
            let interval = simulation.state.time - before;
            let slab = simulation.case.domain.high.y - simulation.case.domain.low.y;
            let unit = 0.5 * simulation.case.soil.unit_weight * slab;
            plain += interval * now.drag / (unit * HEIGHT * HEIGHT);
            heaved += interval * now.drag / (unit * 2.0 * wedge(&simulation, now.displacement, rise) * rise);
            time += interval;
        }
    }
    runner.report_progress(&format!(
        "B5: {variant}, {} steps in {:.1} s",
        simulation.state.step, simulation.wall_s
    ));
    runner.record("B5", &variant, &simulation);
    Ok(Thrust { variant, plain: plain / time, heaved: heaved / time, seconds: simulation.wall_s })
}

/// Cross-section that the soil above a plane would have at its initial density [m²]: its mass over that density and the
/// slab's width. The plane rises from the toe of the wall with this slope.
fn wedge(simulation: &Simulation, displacement: f64, slope: f64) -> f64 {
    let (grid, mass) = (&simulation.model.grid, &simulation.state.soil.mass);
    let toe = grid.faces[2][0];
    let mut sum = 0.0;
    for i in (0..grid.cells()[0]).filter(|i| grid.faces[0][i + 1] > displacement) {
        let low = grid.faces[0][i].max(displacement);
        let plane = toe + slope * (0.5 * (low + grid.faces[0][i + 1]) - displacement);
        for k in 0..grid.cells()[2] {
            let above = (grid.faces[2][k + 1] - plane) / grid.width(2, k);
            sum += mass[grid.index(i, 0, k)] * above.clamp(0.0, 1.0);
        }
    }
    sum / (simulation.model.material().density * grid.width(1, 0))
}
