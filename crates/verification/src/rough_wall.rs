//! B6: a rough vertical wall pushed into sand.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::row::Row;
use crate::runner::Runner;
use analytic::bearing::davis_friction_angle;
use analytic::earth_pressure::{Face, sokolovskii};
use std::f64::consts::FRAC_PI_2;

const CASE: &str = include_str!("../../../validation/B6_rough_passive_wall/case.toml");
const EXACT: &str = "Sokolovskii (1965), computed by the crate `analytic`";
/// Depth of the wall in the case file [m].
const HEIGHT: f64 = 1.0;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A vertical wall with friction tan δ is pushed into deep sand; its toe is inside the soil, \
    because the slip surface dips below it. K_n = 2 P_n / (γ H²) = K_p cos δ, where P_n is the component of the thrust normal to the wall. \
    With ψ = φ it must be Sokolovskii's, with ψ = 0 lie between his values at Davis' φ* and at φ. Evaluated over a displacement of \
    0.02 to 0.05 H, over the undisturbed height.";

/// Friction angle [°], and ratio of the wall friction angle to it.
const WALLS: [(u32, f64); 2] = [(30, 0.5), (35, 2.0 / 3.0)];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let walls = if runner.options.fast { &WALLS[..1] } else { &WALLS[..] };
    for &(angle, ratio) in walls {
        for is_associated in [false, true] {
            if !(runner.options.fast && is_associated) {
                push(runner, angle, ratio, is_associated)?;
            }
        }
    }
    Ok(())
}

/// Normal coefficient of a vertical wall; angles in radians.
fn exact(friction_angle: f64, wall_friction: f64) -> f64 {
    let wall_friction = wall_friction.min(friction_angle);
    let face = Face { friction_angle, wall_friction, surface: FRAC_PI_2, backfill: 0.0 };
    sokolovskii(&face).map_or(f64::NAN, |field| field.coefficient)
}

fn push(runner: &mut Runner, angle: u32, ratio: f64, is_associated: bool) -> Result<(), VerifyError> {
    let phi = f64::from(angle).to_radians();
    let delta = ratio * phi;
    let dilation = if is_associated { angle } else { 0 };
    let variant = format!("φ = {angle}°, δ = {:.1}°, ψ = {dilation}°, H/h = 16", delta.to_degrees());
    let (coefficient, seconds) = coefficient(runner, &variant, angle, delta, dilation, 16)?;
    let row = Row::info("B6", variant, "K_n = K_p cos δ", coefficient).took(seconds);
    let limit = exact(phi, delta);
    runner.rows.push(if is_associated {
        row.within(limit, 0.08, EXACT)
    } else {
        let operative = davis_friction_angle(phi, 0.0).unwrap_or(f64::NAN);
        row.between(exact(operative, delta), limit, 0.08, EXACT)
    });
    Ok(())
}

/// K_n of the first wall with ψ = φ on a mesh of this many cells over its depth.
pub(crate) fn first_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let (angle, ratio) = WALLS[0];
    let delta = ratio * f64::from(angle).to_radians();
    Ok(coefficient(runner, &format!("φ = ψ = {angle}°, H/h = {cells}"), angle, delta, angle, cells)?.0)
}

/// K_n, and its wall-clock time [s].
fn coefficient(
    runner: &mut Runner,
    variant: &str,
    angle: u32,
    delta: f64,
    dilation: u32,
    cells: u32,
) -> Result<(f64, f64), VerifyError> {
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={dilation} deg"),
        format!("body.wall.friction={}", delta.tan()),
        format!("grid.cell={} m", HEIGHT / f64::from(cells)),
    ];
    let simulation = runner.run("B6", variant, CASE, &overrides)?;
    let slab = simulation.case.domain.high.y - simulation.case.domain.low.y;
    let unit = 0.5 * simulation.case.soil.unit_weight * HEIGHT * HEIGHT * slab;
    let range = [0.02 * HEIGHT, 0.05 * HEIGHT];
    let value = mean(&simulation.history.bodies[0], range, |s| s.displacement, |s| s.drag_normal / unit);
    Ok((value, simulation.wall_s))
}
