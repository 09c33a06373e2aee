//! B4: a strip footing on sand without cohesion.

use crate::error::VerifyError;
use crate::line::at_zero;
use crate::runner::Runner;

const CASE: &str = include_str!("../../../validation/B4_strip_footing_on_sand/case.toml");
/// Width of the footing in the case file [m].
const WIDTH: f64 = 1.0;
/// Unit weight of the sand in the case file [N/m³].
const UNIT_WEIGHT: f64 = 16e3;

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
    let reading = if is_associated {
        Reading::associated(angle, runner.expectation("B4", variant, FACTOR)?.value()?)
    } else {
        Reading::INCOMPRESSIBLE
    };
    let dilation = if is_associated { angle } else { 0 };
    let (factor, seconds) = factor(runner, variant, [angle, dilation, 16], is_rough, &reading)?;
    runner.put("B4", variant, seconds, &[(FACTOR, factor)])
}

/// N_γ of the smooth strip, φ = 30°, ψ = 0, with this many cells across.
pub(crate) fn smooth_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let variant = format!("smooth, φ = 30°, ψ = 0°, B/h = {cells}");
    Ok(factor(runner, &variant, [30, 0, cells], false, &Reading::INCOMPRESSIBLE)?.0)
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
    /// Sand that keeps its volume while it flows.
    const INCOMPRESSIBLE: Self = Self { young_modulus: 80e6, speed: 0.02, range: [0.005, 0.02] };

    /// Sand with ψ = φ [°] and the exact factor N_γ.
    fn associated(angle: u32, exact: f64) -> Self {
        let young_modulus = 800e6;
        let speed = if angle < 30 { 0.0008 } else { 0.0016 };
        // Scale of the elastic settlement under the exact load, over the width.
        let elastic = exact * UNIT_WEIGHT * WIDTH / young_modulus;
        Self { young_modulus, speed, range: [3.0 * elastic, 6.0 * elastic] }
    }

    /// Duration of the push [s]: half the ramp of 0.2 s longer than at full speed, with a margin of 2 %.
    fn duration(&self) -> f64 {
        0.1 + 1.02 * self.range[1] * WIDTH / self.speed
    }
}

/// N_γ for angles of friction and dilation [°] and this many cells across, and its wall-clock time [s].
fn factor(
    runner: &mut Runner,
    variant: &str,
    [angle, dilation, cells]: [u32; 3],
    is_rough: bool,
    reading: &Reading,
) -> Result<(f64, f64), VerifyError> {
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={dilation} deg"),
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
