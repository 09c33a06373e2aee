//! A6: the mechanics of rigid bodies, and Coulomb's friction.

use crate::error::VerifyError;
use crate::mechanisms;
use crate::runner::Runner;
use coulter::history::BodySample;
use coulter::simulation::Simulation;
use glam::DVec3;
use mechanics::Twist;
use solver::initial::set_body_in_motion;
use std::f64::consts::PI;

const SLIDING: &str = include_str!("../validation/A6_rigid_mechanics/sliding.toml");
const FALLING: &str = include_str!("../validation/A6_rigid_mechanics/falling.toml");
const BOUNCING: &str = include_str!("../validation/A6_rigid_mechanics/bouncing.toml");
const ROLLING: &str = include_str!("../validation/A6_rigid_mechanics/rolling.toml");
const GRAVITY: f64 = 9.81;
const ACCELERATION: &str = "acceleration over the exact value";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    falling(runner)?;
    sliding(runner)?;
    bouncing(runner)?;
    rolling(runner)?;
    mechanisms::run(runner)
}

fn falling(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "free fall";
    let simulation = runner.run("A6", variant, FALLING, &[])?;
    let samples = &simulation.history.bodies[0];
    let (first, last) = (at(samples, 0.0), at(samples, 0.4));
    let fallen = (last.sinkage - first.sinkage) / (0.5 * GRAVITY * last.time.powi(2));
    runner.put("A6", variant, simulation.wall_s, &[("height of fall over g t²/2", fallen)])
}

fn sliding(runner: &mut Runner) -> Result<(), VerifyError> {
    let friction = 0.3;
    let weight = 4000.0;
    for slope in [30.0_f64, 10.0] {
        let (sin, cos) = slope.to_radians().sin_cos();
        let loads = [
            format!("body.block.forward={{ load = '{} N', start = '20 ms', ramp = '20 ms' }}", weight * sin),
            format!("body.block.heave={{ load = '{} N', ramp = '20 ms' }}", -weight * cos),
            format!("body.block.mass={} kg", weight / GRAVITY),
        ];
        let variant = format!("block on {slope}°, μ = {friction}");
        let simulation = runner.run("A6", &variant, SLIDING, &loads)?;
        let obtained = acceleration(&simulation, [0.1, 0.3]);
        let exact = GRAVITY * (sin - friction * cos);
        let figure = if exact > 0.0 {
            (ACCELERATION, obtained / exact)
        } else {
            ("acceleration over g sin θ", obtained / (GRAVITY * sin))
        };
        runner.put("A6", &variant, simulation.wall_s, &[figure])?;
    }
    Ok(())
}

fn rolling(runner: &mut Runner) -> Result<(), VerifyError> {
    let (sin, cos) = (PI / 18.0).sin_cos();
    for friction in [0.3, 0.03] {
        let variant = format!("wheel on 10°, μ = {friction}");
        if !runner.wants("A6", &variant)? {
            continue;
        }
        let simulation = runner.run("A6", &variant, ROLLING, &[format!("body.wheel.friction={friction}")])?;
        let exact = if friction > sin / cos / 3.0 {
            2.0 / 3.0 * GRAVITY * sin
        } else {
            GRAVITY * (sin - friction * cos)
        };
        let obtained = acceleration(&simulation, [0.45, 0.8]);
        let acceleration = (ACCELERATION, obtained / exact);
        let samples = &simulation.history.bodies[0];
        let (a, b) = (at(samples, 0.45), at(samples, 0.8));
        // A solid wheel: I = m r²/2.
        let angular = (b.spin - a.spin) / (b.time - a.time) * 0.1;
        let exact = if friction > sin / cos / 3.0 { exact } else { 2.0 * friction * GRAVITY * cos };
        let angular = ("angular acceleration over the exact value", angular / exact);
        runner.put("A6", &variant, simulation.wall_s, &[acceleration, angular])?;
    }
    Ok(())
}

fn bouncing(runner: &mut Runner) -> Result<(), VerifyError> {
    const SPEED: f64 = 1e-3;
    let variant = "block strikes a column of 320 cells";
    if !runner.wants("A6", variant)? {
        return Ok(());
    }
    let mut simulation = runner.simulation(BOUNCING, &[])?;
    let falling = Twist { linear: -SPEED * DVec3::Z, angular: DVec3::ZERO };
    simulation.set_in_motion(|model, state| set_body_in_motion(model, state, 0, falling));
    runner.finish("A6", variant, &mut simulation)?;
    let samples = &simulation.history.bodies[0];
    // Travel time of a wave along the column, which is 1 m high.
    let unit = 1.0 / simulation.model.wave_speed();
    let early = at(samples, 1.5 * unit);
    let slowed = -early.heave_speed / SPEED / (-early.time / unit).exp();
    // Contact ends after 3.07 L/c; later the free end of the column may catch up with the block.
    let rebound = at(samples, 3.2 * unit).heave_speed / SPEED;
    let figures = [
        ("speed after 1.5 L/c over the exact value", slowed),
        ("rebound over the exact value", rebound / rebound_exact()),
    ];
    runner.put("A6", variant, simulation.wall_s, &figures)
}

/// Speed at which a body leaves a bar of its own mass, fixed at its other end, over that at which it struck
/// it. With x the time since the wave's return in units of L/c: the force e^(−x−2) + (2 − 2x) e^(−x) ends,
/// the speed is then 2x e^(−x) − e^(−x−2).
fn rebound_exact() -> f64 {
    let end = 1.0 + 0.5 * (-2.0_f64).exp();
    2.0 * end * (-end).exp() - (-end - 2.0).exp()
}

fn at(samples: &[BodySample], time: f64) -> BodySample {
    let distance = |s: &&BodySample| (s.time - time).abs();
    samples.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).copied().unwrap_or_default()
}

/// Mean acceleration along x between two times [m/s²].
fn acceleration(simulation: &Simulation, [from, to]: [f64; 2]) -> f64 {
    let samples = &simulation.history.bodies[0];
    let (a, b) = (at(samples, from), at(samples, to));
    (b.speed - a.speed) / (b.time - a.time)
}
