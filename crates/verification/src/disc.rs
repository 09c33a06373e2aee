//! D3: the disc that is free to sink and to turn, towed over sand: the main use of the solver.

use crate::error::VerifyError;
use crate::row::Row;
use crate::runner::Runner;
use coulter::history::reference::Reference;
use coulter::history::steady::{Steady, steady, window};
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../../../cases/towed_disc.toml");
const TRIAL: &str = "the numerics study's trial at d/h = 20";
/// Diameter of the disc [m].
const DIAMETER: f64 = 0.2;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "The case that `coulter new` writes: a disc of 40 N, free to sink and to turn, towed over \
    dry sand. The mean torque of the soil about the axle must vanish (nothing drives or brakes the disc); drag, sinkage \
    and turn ratio are compared with the trial of the method, which is not a reference solution. Means over the last 30 % of the tow.";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    if runner.options.fast {
        return Ok(());
    }
    let variant = "cases/towed_disc.toml";
    let (steady, simulation) = tow(runner, variant, &[])?;
    let body = &simulation.case.bodies[0];
    let weight = body.mass * simulation.case.gravity;
    let lever = weight * Reference::all(&simulation.case)[0].radius.unwrap_or(f64::NAN);
    let figure = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let info = |quantity, value| Row::info("D3", variant, quantity, value).took(simulation.wall_s);
    let torque = figure(steady.axle_torque) / lever;
    runner.rows.extend([
        info("axle torque over W d/2", torque).at_most(0.01, "equilibrium of a disc that turns freely"),
        info("drag F_H [N]", figure(steady.drag)).compared_with(15.0, 17.0, TRIAL),
        info("vertical force F_V over the weight", figure(steady.vertical) / weight),
        info("sinkage [mm]", 1e3 * figure(steady.sinkage)).compared_with(10.2, 10.5, TRIAL),
        info("turn ratio ω r / v", figure(steady.turn_ratio)).compared_with(0.64, 0.69, TRIAL),
        info("drag noise over the mean", figure(steady.drag_noise)).compared_with(0.04, 0.044, TRIAL),
    ]);
    Ok(())
}

/// Tows the disc with overrides: means over the steady window, and the simulation at its end.
fn tow(
    runner: &mut Runner,
    variant: &str,
    overrides: &[String],
) -> Result<(Steady, Simulation), VerifyError> {
    let simulation = runner.run("D3", variant, CASE, overrides)?;
    let reference = &Reference::all(&simulation.case)[0];
    let samples = &simulation.history.bodies[0];
    let window = window(samples, reference, simulation.case.output.steady_fraction);
    Ok((steady(samples, reference, window), simulation))
}

/// The same tow on a mesh of this many cells over the diameter: drag [N].
pub(crate) fn drag_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let cell = format!("grid.cell={} m", DIAMETER / f64::from(cells));
    Ok(tow(runner, &format!("d/h = {cells}"), &[cell])?.0.drag.unwrap_or(f64::NAN))
}
