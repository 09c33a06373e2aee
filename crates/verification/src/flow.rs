//! B8: deep flow of undrained soil round a cylinder and a sphere, and round a cylinder that is turned.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use std::f64::consts::PI;

const CYLINDER_CASE: &str = include_str!("../validation/B8_deep_flow/case.toml");
const SPHERE_CASE: &str = include_str!("../validation/B8_deep_flow/sphere.toml");
const TURNED_CASE: &str = include_str!("../validation/B8_deep_flow/turned.toml");
/// Diameter in the case files [m].
const DIAMETER: f64 = 1.0;
/// Undrained strength in the case files [Pa].
const STRENGTH: f64 = 1e3;

const FACTOR: &str = "resistance factor N";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (radius, is_rough) in [(4, false), (4, true), (8, false), (8, true)] {
        let variant = format!("{} cylinder, R/h = {radius}", word(is_rough));
        if runner.wants("B8", &variant)? {
            let (factor, seconds) = cylinder(runner, &variant, 2 * radius, is_rough, 8.0)?;
            runner.put("B8", &variant, seconds, &[(FACTOR, factor)])?;
        }
    }
    let variant = "smooth cylinder, R/h = 8, overburden 20 s_u";
    if runner.wants("B8", variant)? {
        let (factor, seconds) = cylinder(runner, variant, 16, false, 20.0)?;
        runner.put("B8", variant, seconds, &[(FACTOR, factor)])?;
    }
    for is_rough in [false, true] {
        let variant = format!("{} sphere, R/h = 8", word(is_rough));
        if runner.wants("B8", &variant)? {
            let (factor, seconds) = sphere(runner, &variant, 16, is_rough)?;
            runner.put("B8", &variant, seconds, &[(FACTOR, factor)])?;
        }
    }
    for (cells, size) in [(10, "10 mm"), (15, "6.5 mm")] {
        let variant = format!("rough cylinder, turned, D/h = {cells}");
        if runner.wants("B8", &variant)? {
            let simulation = runner.run("B8", &variant, TURNED_CASE, &[format!("grid.cell={size}")])?;
            let torque = mean(&simulation.history.bodies[0], TURNED, |s| s.time, |s| -s.moment_z);
            runner.put("B8", &variant, simulation.wall_s, &[("torque [N m]", torque)])?;
        }
    }
    Ok(())
}

/// Factor of the smooth cylinder with this many cells across.
pub(crate) fn smooth_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    Ok(cylinder(runner, &format!("smooth cylinder, D/h = {cells}"), cells, false, 8.0)?.0)
}

fn word(is_rough: bool) -> &'static str {
    if is_rough { "rough" } else { "smooth" }
}

/// Displacements between which the force is averaged [m].
const RANGE: [f64; 2] = [0.1 * DIAMETER, 0.15 * DIAMETER];

/// Times between which the torque of the turned cylinder is averaged [s].
const TURNED: [f64; 2] = [0.04, 0.1];

/// Factor of the cylinder with this many cells across under an overburden [s_u], and its wall-clock time [s].
fn cylinder(
    runner: &mut Runner,
    variant: &str,
    cells: u32,
    is_rough: bool,
    overburden: f64,
) -> Result<(f64, f64), VerifyError> {
    let mut overrides = vec![
        format!("grid.cell={} m", DIAMETER / f64::from(cells)),
        format!("ground.overburden={} Pa", overburden * STRENGTH),
    ];
    if is_rough {
        overrides.push("body.bar.friction=rough".to_owned());
    }
    let simulation = runner.run("B8", variant, CYLINDER_CASE, &overrides)?;
    let force = mean(&simulation.history.bodies[0], RANGE, |s| s.displacement, |s| s.drag);
    Ok((force / (DIAMETER * STRENGTH), simulation.wall_s))
}

/// Factor of the sphere with this many cells across, and its wall-clock time [s].
fn sphere(runner: &mut Runner, variant: &str, cells: u32, is_rough: bool) -> Result<(f64, f64), VerifyError> {
    let mut overrides = vec![format!("grid.cell={} m", DIAMETER / f64::from(cells))];
    if is_rough {
        overrides.push("body.sphere.friction=rough".to_owned());
    }
    let simulation = runner.run("B8", variant, SPHERE_CASE, &overrides)?;
    let samples = &simulation.history.bodies[0];
    let start = samples.first().map_or(f64::NAN, |s| s.sinkage);
    let force = mean(samples, RANGE, |s| s.sinkage - start, |s| s.vertical);
    Ok((force / (0.25 * PI * DIAMETER * DIAMETER * STRENGTH), simulation.wall_s))
}
