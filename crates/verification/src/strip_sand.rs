//! B4: a strip footing on sand without cohesion.

use crate::error::VerifyError;
use crate::line::at_zero;
use crate::row::Row;
use crate::runner::Runner;
use analytic::bearing::{davis_friction_angle, weight_factor_exact_smooth, weight_factor_martin_rough};

const CASE: &str = include_str!("../../../validation/B4_strip_footing_on_sand/case.toml");
const EXACT: &str = "Martin (2005), method of characteristics";
const DAVIS: &str = "Martin (2005) at Davis' φ* and at φ";
/// Width of the footing in the case file [m].
const WIDTH: f64 = 1.0;
/// Unit weight of the sand in the case file [N/m³].
const UNIT_WEIGHT: f64 = 16e3;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A strip footing on dry sand without cohesion or surcharge, half of it modelled: \
    q_u = ½ γ B N_γ. With ψ = φ the factor must be Martin's; with ψ = 0 it must lie between that at Davis' φ* \
    (tan φ* = sin φ) and that at φ. Penetration w and heave act as a surcharge proportional to w: the pressure is \
    extrapolated to w = 0 along a fitted straight line. With ψ = 0 it is fitted over w = 0.005 to 0.02 B, at 0.02 B/s. Sand with ψ = φ \
    dissipates nothing and heaves several times as much: there E is ten times as high, so that it fails before it heaves, the line \
    is fitted over w = 3 to 6 N_γ γ B²/E, beyond the elastic rise, and the speed is so low (0.0008 B/s, 0.0016 B/s from φ = 30° on) \
    that the stress of a wave, ρ c v, does not exceed the weight of a cell or two, γ h.";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let angles: &[u32] = if runner.options.fast { &[30] } else { &[20, 25, 30, 35] };
    for &angle in angles {
        for is_rough in [false, true] {
            for is_associated in [false, true] {
                if !(runner.options.fast && (is_rough || is_associated)) {
                    push(runner, angle, is_rough, is_associated)?;
                }
            }
        }
    }
    Ok(())
}

/// Exact factor of a smooth or rough strip at a friction angle [rad].
fn exact(angle: f64, is_rough: bool) -> f64 {
    let factor = if is_rough { weight_factor_martin_rough(angle) } else { weight_factor_exact_smooth(angle) };
    factor.unwrap_or(f64::NAN)
}

fn push(runner: &mut Runner, angle: u32, is_rough: bool, is_associated: bool) -> Result<(), VerifyError> {
    let word = if is_rough { "rough" } else { "smooth" };
    let dilation = if is_associated { angle } else { 0 };
    let variant = format!("{word}, φ = {angle}°, ψ = {dilation}°, B/h = 16");
    let (factor, seconds) = factor(runner, &variant, angle, is_rough, is_associated, 16)?;
    let phi = f64::from(angle).to_radians();
    let row = Row::info("B4", variant, "bearing capacity factor N_γ", factor).took(seconds);
    let limit = exact(phi, is_rough);
    runner.rows.push(if is_associated {
        row.within(limit, 0.1, EXACT)
    } else {
        let operative = davis_friction_angle(phi, 0.0).unwrap_or(f64::NAN);
        row.between(exact(operative, is_rough), limit, 0.1, DAVIS)
    });
    Ok(())
}

/// N_γ of the smooth strip, φ = 30°, ψ = 0, with this many cells across.
pub(crate) fn smooth_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    Ok(factor(runner, &format!("smooth, φ = 30°, ψ = 0°, B/h = {cells}"), 30, false, false, cells)?.0)
}

/// How the footing is pushed, and over which range the force is evaluated.
struct Reading {
    young_modulus: f64,
    /// Speed [m/s].
    speed: f64,
    /// Penetrations over the width between which the line is fitted.
    range: [f64; 2],
}

impl Reading {
    fn of(angle: u32, is_rough: bool, is_associated: bool) -> Self {
        if !is_associated {
            return Self { young_modulus: 80e6, speed: 0.02, range: [0.005, 0.02] };
        }
        let young_modulus = 800e6;
        let speed = if angle < 30 { 0.0008 } else { 0.0016 };
        // Scale of the elastic settlement under the exact load, over the width.
        let elastic = exact(f64::from(angle).to_radians(), is_rough) * UNIT_WEIGHT * WIDTH / young_modulus;
        Self { young_modulus, speed, range: [3.0 * elastic, 6.0 * elastic] }
    }

    /// Duration of the push [s]: half the ramp of 0.2 s longer than at full speed, with a margin of 2 %.
    fn duration(&self) -> f64 {
        0.1 + 1.02 * self.range[1] * WIDTH / self.speed
    }
}

/// N_γ, and its wall-clock time [s].
fn factor(
    runner: &mut Runner,
    variant: &str,
    angle: u32,
    is_rough: bool,
    is_associated: bool,
    cells: u32,
) -> Result<(f64, f64), VerifyError> {
    let reading = Reading::of(angle, is_rough, is_associated);
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={} deg", if is_associated { angle } else { 0 }),
        format!("grid.cell={} m", WIDTH / f64::from(cells)),
        format!("body.footing.friction={}", if is_rough { "rough" } else { "0" }),
        format!("body.footing.heave={{ speed = '-{} m/s', ramp = '0.2 s' }}", reading.speed),
        format!("run.duration={} s", reading.duration()),
        format!("soil.young_modulus={} Pa", reading.young_modulus),
    ];
    let simulation = runner.run("B4", variant, CASE, &overrides)?;
    let slab = simulation.case.domain.high.y - simulation.case.domain.low.y;
    let unit = 0.5 * simulation.case.soil.unit_weight * WIDTH * WIDTH * slab;
    let samples = &simulation.history.bodies[0];
    let points = samples.iter().map(|s| [s.sinkage / WIDTH, s.vertical / unit]);
    let read: Vec<[f64; 2]> =
        points.filter(|[w, _]| (reading.range[0]..=reading.range[1]).contains(w)).collect();
    Ok((at_zero(&read), simulation.wall_s))
}
