//! D3: the disc that is free to sink and to turn, towed over sand: the main job.

use super::bench::Bench;
use super::error::VerifyError;
use super::row::Row;
use crate::history::reference::Reference;
use crate::history::steady::{Steady, steady, window};
use crate::simulation::Simulation;

const CASE: &str = include_str!("../../../../cases/towed_disc.toml");
const TRIAL: &str = "the numerics study's trial at d/h = 20";
/// Diameter of its disc [m].
const DIAMETER: f64 = 0.2;

/// What it is about.
pub(super) const ABOUT: &str = "The case that `coulter new` writes: a disc of 40 N, free to sink and to turn, towed over \
    dry sand. The soil's torque about the axle must vanish in the mean (nothing drives or brakes the disc); drag, sinkage \
    and turn ratio stand beside what the trial of the method gave, which is no truth. Means over the last 30 % of the tow.";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    if bench.wish.fast {
        return Ok(());
    }
    let variant = "cases/towed_disc.toml";
    let (steady, simulation) = tow(bench, variant, &[])?;
    let body = &simulation.case.bodies[0];
    let weight = body.mass * simulation.case.gravity;
    let lever = weight * Reference::all(&simulation.case)[0].radius.unwrap_or(f64::NAN);
    let figure = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let note = |quantity, value| Row::note("D3", variant, quantity, value).took(simulation.wall_s);
    let torque = figure(steady.axle_torque) / lever;
    bench.rows.extend([
        note("axle torque over W d/2", torque).at_most(0.01, "equilibrium of a disc that turns freely"),
        note("drag F_H [N]", figure(steady.drag)).beside(15.0, 17.0, TRIAL),
        note("vertical force F_V over the weight", figure(steady.vertical) / weight),
        note("sinkage [mm]", 1e3 * figure(steady.sinkage)).beside(10.2, 10.5, TRIAL),
        note("turn ratio ω r / v", figure(steady.turn_ratio)).beside(0.64, 0.69, TRIAL),
        note("drag noise over the mean", figure(steady.drag_noise)).beside(0.04, 0.044, TRIAL),
    ]);
    Ok(())
}

/// Tows the disc with overrides: means over the last part of the tow, and the simulation at its end.
fn tow(bench: &mut Bench, variant: &str, overrides: &[String]) -> Result<(Steady, Simulation), VerifyError> {
    let simulation = bench.run("D3", variant, CASE, overrides)?;
    let reference = &Reference::all(&simulation.case)[0];
    let samples = &simulation.history.bodies[0];
    let window = window(samples, reference, simulation.case.output.steady_fraction);
    Ok((steady(samples, reference, window), simulation))
}

/// The same tow on a mesh of so many cells over the diameter: drag [N].
pub(super) fn drag_on(bench: &mut Bench, cells: u32) -> Result<f64, VerifyError> {
    let cell = format!("grid.cell={} m", DIAMETER / f64::from(cells));
    Ok(tow(bench, &format!("d/h = {cells}"), &[cell])?.0.drag.unwrap_or(f64::NAN))
}
