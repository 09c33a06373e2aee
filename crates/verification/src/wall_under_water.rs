//! W2: the wall of B5 in saturated soil, undrained, drained and between.

use crate::error::VerifyError;
use crate::runner::Runner;

const CASE: &str = include_str!("../validation/W2_wall_under_water/case.toml");
/// Height of the bank in the case file [m].
const HEIGHT: f64 = 1.0;
/// Speed of the wall in the case file [m/s].
const SPEED: f64 = 0.05;
/// Displacements over the height between which the undrained thrust is averaged, and the others.
const EARLY: [f64; 2] = [0.01, 0.02];
const LATE: [f64; 2] = [0.05, 0.1];

/// Undrained: friction angle [°], K₀ and cells over the height.
const UNDRAINED: [(u32, f64, u32); 5] =
    [(30, 1.0, 8), (30, 1.0, 16), (30, 1.0, 32), (30, 0.5, 16), (35, 1.0, 16)];
/// Dilation angles [°] of the drained walls.
const DRAINED: [u32; 2] = [0, 30];
/// Permeability over speed of the partly drained walls.
const PARTLY: [f64; 3] = [0.2, 0.02, 0.002];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (angle, k0, cells) in UNDRAINED {
        let name = format!("φ = {angle}°, K₀ = {k0}, H/h = {cells}");
        if runner.wants("W2", &name)? {
            let overrides = [
                format!("soil.friction_angle={angle} deg"),
                format!("soil.k0={k0}"),
                format!("grid.cell={} m", HEIGHT / f64::from(cells)),
                format!("run.tow_distance={} m", EARLY[1] * HEIGHT),
            ];
            let (force, seconds) = push(runner, &name, &overrides, EARLY)?;
            runner.put("W2", &name, seconds, &[("K, undrained", force)])?;
        }
    }
    for dilation in DRAINED {
        let name = format!("drained, ψ = {dilation}°");
        if runner.wants("W2", &name)? {
            let soil = format!("soil.dilation_angle={dilation} deg");
            let with = [soil.clone(), "water.permeability=100 m/s".to_owned()];
            let without = [
                soil,
                "water.pore_pressure=false".to_owned(),
                "water.accept_drained=true".to_owned(),
                VOLUME_STRAIN.to_owned(),
            ];
            let (force, seconds) = push(runner, &name, &with, LATE)?;
            let (reference, more) = push(runner, &format!("{name}, no pore pressure"), &without, LATE)?;
            let figure = ("force over that without pore pressure", force / reference);
            runner.put("W2", &name, seconds + more, &[figure])?;
        }
    }
    for ratio in PARTLY {
        let name = format!("ψ = 10°, k/v = {ratio}");
        if runner.wants("W2", &name)? {
            let (force, seconds) = push(runner, &name, &at(SPEED, ratio), LATE)?;
            let slow = format!("{name}, half the speed");
            let (half, more) = push(runner, &slow, &at(0.5 * SPEED, ratio), LATE)?;
            let figures = [
                ("force at half the speed and permeability over the force", half / force),
                ("force over ½ γ′ H²", force),
            ];
            runner.put("W2", &name, seconds + more, &figures)?;
        }
    }
    Ok(())
}

/// What a run without pore pressure asks for; it changes nothing.
const VOLUME_STRAIN: &str = "water.volume_strain=0";

/// Dilating soil at a speed [m/s], with a permeability of so many times that.
fn at(speed: f64, ratio: f64) -> [String; 3] {
    [
        "soil.dilation_angle=10 deg".to_owned(),
        format!("water.permeability={} m/s", ratio * speed),
        format!("body.wall.forward.speed={speed} m/s"),
    ]
}

/// Pushes the wall; returns its mean thrust between two displacements over the height, over ½ γ′ H², and the
/// wall-clock time [s].
fn push(
    runner: &mut Runner,
    name: &str,
    overrides: &[String],
    [from, to]: [f64; 2],
) -> Result<(f64, f64), VerifyError> {
    let mut simulation = runner.simulation(CASE, overrides)?;
    while !simulation.is_done() {
        simulation.advance()?;
    }
    let unit = 0.5 * simulation.case.soil.unit_weight * HEIGHT * HEIGHT;
    let samples = &simulation.history.bodies[0];
    let within = samples.iter().filter(|now| (from..=to).contains(&(now.displacement / HEIGHT)));
    let (sum, count) = within.fold((0.0, 0.0), |(sum, count), now| (sum + now.drag, count + 1.0));
    runner.record("W2", name, &simulation);
    Ok((sum / count / unit, simulation.wall_s))
}
