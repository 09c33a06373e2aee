//! A6: the mechanics of rigid bodies, and Coulomb's friction.

use super::bench::Bench;
use super::error::VerifyError;
use super::row::Row;
use crate::history::BodySample;
use crate::simulation::Simulation;
use std::f64::consts::PI;

const SLIDING: &str = include_str!("../../../../validation/A6_rigid_mechanics/sliding.toml");
const FALLING: &str = include_str!("../../../../validation/A6_rigid_mechanics/falling.toml");
const BOUNCING: &str = include_str!("../../../../validation/A6_rigid_mechanics/bouncing.toml");
const ROLLING: &str = include_str!("../../../../validation/A6_rigid_mechanics/rolling.toml");
const COULOMB: &str = "Newton and Coulomb, exact";
const SAINT_VENANT: &str = "Saint-Venant (1883): a heavy body strikes a bar, exact";
const GRAVITY: f64 = 9.81;
const TOLERANCE: f64 = 1e-3;

/// What it is about.
pub(super) const ABOUT: &str = "Bodies on stiff, weightless, elastic soil that stands in for a rigid plane; a slope is a weight with a \
    part along x. A block of μ = 0.3 must slide down 30° with g (sin θ − μ cos θ) and stay on 10°; a wheel must roll down 10° with \
    ⅔ g sin θ, or slip with g (sin θ − μ cos θ) where μ is 0.03 and less than ⅓ tan θ; a block must fall with g; and one as heavy as the \
    elastic column that it strikes must slow down and leave it as the waves in the column say. Accelerations are those between two times.";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    falling(bench)?;
    sliding(bench)?;
    if bench.wish.fast {
        return Ok(());
    }
    bouncing(bench)?;
    rolling(bench)
}

fn put(
    bench: &mut Bench,
    variant: &str,
    quantity: &str,
    of_exact: f64,
    simulation: &Simulation,
    source: &'static str,
) {
    let row = Row::note("A6", variant, quantity, of_exact).within(1.0, TOLERANCE, source);
    bench.rows.push(row.took(simulation.wall_s));
}

fn falling(bench: &mut Bench) -> Result<(), VerifyError> {
    let variant = "free fall";
    let simulation = bench.run("A6", variant, FALLING, &[])?;
    let samples = &simulation.history.bodies[0];
    let (first, last) = (at(samples, 0.0), at(samples, 0.4));
    let fallen = (last.sinkage - first.sinkage) / (0.5 * GRAVITY * last.time.powi(2));
    put(bench, variant, "height of fall over g t²/2", fallen, &simulation, COULOMB);
    Ok(())
}

fn sliding(bench: &mut Bench) -> Result<(), VerifyError> {
    let friction = 0.3;
    let weight = 100.0;
    for slope in [30.0_f64, 10.0] {
        let (sin, cos) = slope.to_radians().sin_cos();
        let loads = [
            format!("body.block.forward={{ load = '{} N', start = '20 ms', ramp = '20 ms' }}", weight * sin),
            format!("body.block.heave={{ load = '{} N', ramp = '20 ms' }}", -weight * cos),
            format!("body.block.mass={} kg", weight / GRAVITY),
        ];
        let variant = format!("block on {slope}°, μ = {friction}");
        let simulation = bench.run("A6", &variant, SLIDING, &loads)?;
        let pace = acceleration(&simulation, [0.1, 0.3]);
        let exact = GRAVITY * (sin - friction * cos);
        if exact > 0.0 {
            put(bench, &variant, "acceleration over the exact one", pace / exact, &simulation, COULOMB);
        } else {
            let row = Row::note("A6", variant, "acceleration over g sin θ", pace / (GRAVITY * sin));
            bench.rows.push(row.at_most(TOLERANCE, COULOMB).took(simulation.wall_s));
        }
    }
    Ok(())
}

fn rolling(bench: &mut Bench) -> Result<(), VerifyError> {
    let (sin, cos) = (PI / 18.0).sin_cos();
    for friction in [0.3, 0.03] {
        let variant = format!("wheel on 10°, μ = {friction}");
        let simulation = bench.run("A6", &variant, ROLLING, &[format!("body.wheel.friction={friction}")])?;
        let exact = if friction > sin / cos / 3.0 {
            2.0 / 3.0 * GRAVITY * sin
        } else {
            GRAVITY * (sin - friction * cos)
        };
        let pace = acceleration(&simulation, [0.45, 0.8]);
        put(bench, &variant, "acceleration over the exact one", pace / exact, &simulation, COULOMB);
        let samples = &simulation.history.bodies[0];
        let (a, b) = (at(samples, 0.45), at(samples, 0.8));
        // A solid wheel: I = m r²/2.
        let turn = (b.spin - a.spin) / (b.time - a.time) * 0.1;
        let exact = if friction > sin / cos / 3.0 { exact } else { 2.0 * friction * GRAVITY * cos };
        put(bench, &variant, "angular acceleration over the exact one", turn / exact, &simulation, COULOMB);
    }
    Ok(())
}

fn bouncing(bench: &mut Bench) -> Result<(), VerifyError> {
    const SPEED: f64 = 1e-3;
    let variant = "block strikes a column of 320 cells";
    let mut simulation = bench.simulation(BOUNCING, &[])?;
    simulation.set_in_motion(|state| state.bodies[0].velocity.z = -SPEED);
    bench.finish("A6", variant, &mut simulation)?;
    let samples = &simulation.history.bodies[0];
    // The time in which a wave runs down the column, which is 1 m high.
    let unit = 1.0 / simulation.model.wave_speed();
    let early = at(samples, 1.5 * unit);
    let slowed = -early.heave_speed / SPEED / (-early.time / unit).exp();
    put(bench, variant, "speed after 1.5 L/c over the exact one", slowed, &simulation, SAINT_VENANT);
    // Contact ends after 3.07 L/c; later the column's free end may catch up with the block.
    let rebound = at(samples, 3.2 * unit).heave_speed / SPEED;
    put(bench, variant, "rebound over the exact one", rebound / rebound_exact(), &simulation, SAINT_VENANT);
    Ok(())
}

/// Speed at which a body leaves a bar of its own mass, fixed at its other end, over that at which it struck it. With
/// x the time since the wave's return in units of L/c: the force e^(−x−2) + (2 − 2x) e^(−x) ends, the speed is then
/// 2x e^(−x) − e^(−x−2).
fn rebound_exact() -> f64 {
    let end = 1.0 + 0.5 * (-2.0_f64).exp();
    2.0 * end * (-end).exp() - (-end - 2.0).exp()
}

fn at(samples: &[BodySample], time: f64) -> BodySample {
    let off = |s: &&BodySample| (s.time - time).abs();
    samples.iter().min_by(|a, b| off(a).total_cmp(&off(b))).copied().unwrap_or_default()
}

/// Mean acceleration along x between two times [m/s²].
fn acceleration(simulation: &Simulation, [from, to]: [f64; 2]) -> f64 {
    let samples = &simulation.history.bodies[0];
    let (a, b) = (at(samples, from), at(samples, to));
    (b.speed - a.speed) / (b.time - a.time)
}
