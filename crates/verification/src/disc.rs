//! D3: the disc that is free to sink and to turn, towed over sand: the main use of the solver.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::history::quantities::Steady;
use coulter::history::reference::Reference;
use coulter::history::steady::SteadyWindow;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../cases/light_disc.toml");
/// Diameter of the disc [m].
const DIAMETER: f64 = 0.2;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "cases/light_disc.toml";
    if !runner.wants("D3", variant)? {
        return Ok(());
    }
    let (steady, simulation) = tow(runner, variant, &[])?;
    let body = &simulation.case.bodies[0];
    let weight = body.mass * simulation.case.gravity;
    let lever = weight * Reference::all(&simulation.case)[0].radius.unwrap_or(f64::NAN);
    let figure = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let figures = [
        ("axle torque over W d/2", figure(steady.axle_torque) / lever),
        ("drag F_H [N]", figure(steady.drag)),
        ("vertical force F_V over the weight", figure(steady.vertical) / weight),
        ("sinkage [mm]", 1e3 * figure(steady.sinkage)),
        ("turn ratio ω r / v", figure(steady.turn_ratio)),
        ("drag noise over the mean", figure(steady.drag_noise)),
    ];
    runner.put("D3", variant, simulation.wall_s, &figures)
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
    let window = SteadyWindow::of(samples, reference, simulation.case.output.steady_fraction);
    Ok((window.steady, simulation))
}

/// The tow on a mesh of this many cells over the diameter: drag [N].
pub(crate) fn drag_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let cell = format!("grid.cell={} m", DIAMETER / f64::from(cells));
    Ok(tow(runner, &format!("d/h = {cells}"), &[cell])?.0.drag.unwrap_or(f64::NAN))
}
