//! B4: a strip footing on sand without cohesion.

use super::bench::{Bench, VerifyError, mean};
use super::line::at_zero;
use super::row::Row;
use crate::output::record::BodySample;
use analytic::bearing::{
    davis_friction_angle, surcharge_factor, weight_factor_exact_smooth, weight_factor_martin_rough,
};

const CASE: &str = include_str!("../../../../validation/B4_strip_footing_on_sand/case.toml");
const EXACT: &str = "Martin (2005), method of characteristics";
const DAVIS: &str = "Martin (2005) at Davis' φ* and at φ";
/// Width of the footing in the case file [m].
const WIDTH: f64 = 1.0;

/// What it is about.
pub(super) const ABOUT: &str = "A strip footing on dry sand without cohesion or surcharge, half of it modelled: \
    q_u = ½ γ B N_γ. With ψ = φ the factor must be Martin's; with ψ = 0 it must lie between that at Davis' φ* \
    (tan φ* = sin φ) and that at φ. Penetration w and heave are a surcharge that grows in proportion to w: with ψ = 0 the pressure is \
    read at w = 0 on the straight line that fits it over w = 0.005 to 0.02 B, at 0.02 B/s. With ψ = φ it rings too much for a line: \
    the mean over w = 0.004 to 0.007 B at 0.005 B/s is taken, less γ w N_q; the heave stays in.";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    let angles: &[u32] = if bench.wish.fast { &[30] } else { &[20, 25, 30, 35] };
    for &angle in angles {
        for is_rough in [false, true] {
            for is_associated in [false, true] {
                if !(bench.wish.fast && (is_rough || is_associated)) {
                    push(bench, angle, is_rough, is_associated)?;
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

fn push(bench: &mut Bench, angle: u32, is_rough: bool, is_associated: bool) -> Result<(), VerifyError> {
    let word = if is_rough { "rough" } else { "smooth" };
    let dilation = if is_associated { angle } else { 0 };
    let variant = format!("{word}, φ = {angle}°, ψ = {dilation}°, B/h = 16");
    let (factor, seconds) = factor(bench, &variant, angle, is_rough, is_associated, 16)?;
    let phi = f64::from(angle).to_radians();
    let row = Row::note("B4", variant, "bearing capacity factor N_γ", factor).took(seconds);
    let limit = exact(phi, is_rough);
    bench.rows.push(if is_associated {
        row.within(limit, 0.1, EXACT)
    } else {
        let operative = davis_friction_angle(phi, 0.0).unwrap_or(f64::NAN);
        row.between(exact(operative, is_rough), limit, 0.1, DAVIS)
    });
    Ok(())
}

/// The factor of the smooth strip, φ = 30°, ψ = 0, with so many cells across.
pub(super) fn smooth_on(bench: &mut Bench, cells: u32) -> Result<f64, VerifyError> {
    Ok(factor(bench, &format!("smooth, φ = 30°, ψ = 0°, B/h = {cells}"), 30, false, false, cells)?.0)
}

/// N_γ, and the seconds it took.
fn factor(
    bench: &mut Bench,
    variant: &str,
    angle: u32,
    is_rough: bool,
    is_associated: bool,
    cells: u32,
) -> Result<(f64, f64), VerifyError> {
    let (speed, duration, range) =
        if is_associated { (0.005, 1.8, [0.004, 0.007]) } else { (0.02, 1.15, [0.005, 0.02]) };
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={} deg", if is_associated { angle } else { 0 }),
        format!("grid.cell={} m", WIDTH / f64::from(cells)),
        format!("body.footing.friction={}", if is_rough { "rough" } else { "0" }),
        format!("body.footing.heave={{ speed = '-{speed} m/s', ramp = '0.2 s' }}"),
        format!("run.duration={duration} s"),
    ];
    let simulation = bench.run("B4", variant, CASE, &overrides)?;
    let slab = simulation.case.domain.high.y - simulation.case.domain.low.y;
    let unit = 0.5 * simulation.case.soil.unit_weight * WIDTH * WIDTH * slab;
    let samples = &simulation.history.bodies[0];
    if is_associated {
        let surcharge = surcharge_factor(f64::from(angle).to_radians()).unwrap_or(f64::NAN);
        let value = |s: &BodySample| s.vertical / unit - 2.0 * s.sinkage / WIDTH * surcharge;
        let value = mean(samples, range.map(|w| w * WIDTH), |s| s.sinkage, value);
        return Ok((value, simulation.wall_s));
    }
    let points = samples.iter().map(|s| [s.sinkage / WIDTH, s.vertical / unit]);
    let read: Vec<[f64; 2]> = points.filter(|[w, _]| (range[0]..=range[1]).contains(w)).collect();
    Ok((at_zero(&read), simulation.wall_s))
}
