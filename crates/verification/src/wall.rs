//! B5: a smooth vertical wall pushed into a bank of sand.

use crate::error::VerifyError;
use crate::row::Row;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../../../validation/B5_passive_wall/case.toml");
const SOURCE: &str = "Rankine (1857): exact, tan²(45° + φ/2)";
/// Height of the bank in the case file [m].
const HEIGHT: f64 = 1.0;
/// Displacements between which the thrust is averaged [m], for a short push and for a long one.
const FROM_TO: [[f64; 2]; 2] = [[0.05 * HEIGHT, 0.1 * HEIGHT], [0.25 * HEIGHT, 0.3 * HEIGHT]];

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A smooth vertical wall is pushed into a bank of dry sand on a smooth floor, which makes \
    the soil fail in the passive Rankine state: E_p = ½ K_p γ H². Evaluated as the mean horizontal thrust over a \
    displacement of 0.05 to 0.1 H (and of 0.25 to 0.3 H), once over ½ γ H² with the undisturbed height, once with the heave included: over the \
    current weight of the Rankine wedge, γ H² = 2 G tan(45° − φ/2), where G is the weight of the soil \
    above the plane that rises from the toe of the wall at 45° − φ/2 (dilated soil is lighter).";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variants: &[[u32; 3]] = if runner.options.fast {
        &[[30, 0, 8], [30, 30, 16]]
    } else {
        &[[30, 0, 8], [30, 0, 16], [35, 0, 16], [40, 0, 16], [30, 30, 16], [35, 35, 16], [40, 40, 16]]
    };
    for &variant in variants {
        push(runner, variant, FROM_TO[0])?;
    }
    let long: &[[u32; 3]] =
        if runner.options.fast { &[] } else { &[[30, 0, 16], [30, 30, 16], [35, 35, 16], [40, 40, 16]] };
    for &variant in long {
        push(runner, variant, FROM_TO[1])?;
    }
    Ok(())
}

/// Pushes the wall into sand and judges the thrust on it.
fn push(runner: &mut Runner, angles_and_cells: [u32; 3], from_to: [f64; 2]) -> Result<(), VerifyError> {
    let [angle, dilation, _] = angles_and_cells;
    let is_long = from_to[1] > FROM_TO[0][1];
    let thrust = thrust(runner, angles_and_cells, from_to)?;
    let exact = (std::f64::consts::FRAC_PI_4 + 0.5 * f64::from(angle).to_radians()).tan().powi(2);
    let info =
        |quantity, value| Row::info("B5", thrust.variant.as_str(), quantity, value).took(thrust.seconds);
    let plain = info("K_p over the undisturbed height", thrust.plain);
    runner.rows.push(info("K_p, heave included", thrust.heaved).within(exact, 0.02, SOURCE));
    // Soil that dilates, or is pushed far, heaves so much that its undisturbed height is meaningless.
    runner.rows.push(if dilation == 0 && !is_long { plain.within(exact, 0.02, SOURCE) } else { plain });
    Ok(())
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
    [angle, dilation, cells]: [u32; 3],
    [from, to]: [f64; 2],
) -> Result<Thrust, VerifyError> {
    let suffix = if to > FROM_TO[0][1] { ", pushed 0.3 H" } else { "" };
    let variant = format!("φ = {angle}°, ψ = {dilation}°, H/h = {cells}{suffix}");
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
