//! B4: a strip footing on sand without cohesion.

use crate::bearing::Footing;
use crate::error::VerifyError;
use crate::runner::Runner;
use analytic::bearing::{weight_factor_exact_smooth, weight_factor_martin_rough};

const CASE: &str = include_str!("../validation/B4_strip_footing_on_sand/case.toml");
/// Width of the footing in the case file [m].
const WIDTH: f64 = 1.0;
/// Unit weight of the sand in the case file [N/m³].
const UNIT_WEIGHT: f64 = 16e3;
/// Young's modulus of the sand in the case file [Pa].
const YOUNG_MODULUS: f64 = 800e6;

const FACTOR: &str = "bearing capacity factor N_γ";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for angle in [20, 25, 30, 35] {
        for is_rough in [false, true] {
            for is_associated in [false, true] {
                let word = if is_rough { "rough" } else { "smooth" };
                let dilation = if is_associated { angle } else { 0 };
                let variant = format!("{word}, φ = {angle}°, ψ = {dilation}°, B/h = 16");
                if runner.wants("B4", &variant)? {
                    push(runner, &variant, angle, is_rough, is_associated)?;
                }
            }
        }
    }
    Ok(())
}

fn push(
    runner: &mut Runner,
    variant: &str,
    angle: u32,
    is_rough: bool,
    is_associated: bool,
) -> Result<(), VerifyError> {
    let dilation = if is_associated { angle } else { 0 };
    let (factor, seconds) = factor(runner, variant, [angle, dilation, 16], is_rough)?;
    runner.put("B4", variant, seconds, &[(FACTOR, factor)])
}

/// N_γ of the smooth strip, φ = 30°, ψ = 0, with this many cells across.
pub(crate) fn smooth_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let variant = format!("smooth, φ = 30°, ψ = 0°, B/h = {cells}");
    Ok(factor(runner, &variant, [30, 0, cells], false)?.0)
}

/// Martin's factor N_γ at φ [°].
fn exact(angle: u32, is_rough: bool) -> Result<f64, VerifyError> {
    let form = if is_rough { weight_factor_martin_rough } else { weight_factor_exact_smooth };
    Ok(form(f64::from(angle).to_radians())?)
}

/// N_γ for angles of friction and dilation [°] and this many cells across, and its wall-clock time [s].
fn factor(
    runner: &mut Runner,
    variant: &str,
    [angle, dilation, cells]: [u32; 3],
    is_rough: bool,
) -> Result<(f64, f64), VerifyError> {
    let footing = Footing {
        angles: [angle, dilation].map(|degrees| f64::from(degrees).to_radians()),
        compliance: UNIT_WEIGHT * WIDTH / YOUNG_MODULUS,
        expected: exact(angle, is_rough)?,
    };
    let speed = if angle < 30 { 0.0008 } else { 0.0016 };
    // Half the ramp of 0.2 s longer than at full speed, with a margin of 2 %.
    let duration = 0.1 + 1.02 * footing.stretch()[1] * WIDTH / speed;
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={dilation} deg"),
        format!("grid.cell={} m", WIDTH / f64::from(cells)),
        format!("body.footing.friction={}", if is_rough { "rough" } else { "0" }),
        format!("body.footing.heave={{ speed = '-{speed} m/s', ramp = '0.2 s' }}"),
        format!("run.duration={duration} s"),
    ];
    let simulation = runner.run("B4", variant, CASE, &overrides)?;
    let unit = 0.5 * simulation.case.soil.unit_weight * WIDTH * WIDTH;
    let points = simulation.history.bodies[0].iter().map(|s| [s.sinkage / WIDTH, s.vertical / unit]);
    Ok((footing.weight_factor(points)?, simulation.wall_s))
}
