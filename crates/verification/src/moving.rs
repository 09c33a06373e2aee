//! A8, second part: the whole set-up in uniform motion (Galilean invariance).

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use glam::DVec3;
use mechanics::Twist;
use solver::initial::set_body_in_motion;

const CASE: &str = include_str!("../validation/A8_repeatability/moving.toml");
/// Speed of the moving set-up [m/s]: 12 cells over the run.
const SPEED: f64 = 0.2;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "strip on clay, all moving at 0.2 m/s";
    if !runner.wants("A8", variant)? {
        return Ok(());
    }
    let rest = pressed(runner, "strip on clay at rest", 0.0)?;
    let moved = pressed(runner, variant, SPEED)?;
    let seconds = rest.wall_s + moved.wall_s;
    // From 0.03 to 0.06 widths of penetration.
    let force = |s: &Simulation| mean(&s.history.bodies[0], [1.8, 3.3], |b| b.time, |b| b.vertical);
    let ratio = force(&moved) / force(&rest);
    runner.put("A8", variant, seconds, &[("mean force over that at rest", ratio)])
}

/// The case, with clay and strip in uniform motion.
fn pressed(runner: &mut Runner, variant: &str, speed: f64) -> Result<Simulation, VerifyError> {
    let tow = format!("body.footing.forward={{ speed = '{speed} m/s', ramp = '0 s' }}");
    let mut simulation = runner.simulation(CASE, &[tow])?;
    simulation.set_in_motion(|model, state| {
        for (v, mass) in state.nodes.velocity[0].iter_mut().zip(&state.nodes.mass) {
            *v = if *mass > 0.0 { speed } else { 0.0 };
        }
        set_body_in_motion(model, state, 0, Twist { linear: DVec3::X * speed, angular: DVec3::ZERO });
    });
    runner.finish("A8", variant, &mut simulation)?;
    Ok(simulation)
}
