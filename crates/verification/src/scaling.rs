//! A7: the same case at several scales, with the same dimensionless groups.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::history::BodySample;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../validation/A7_scaling/case.toml");
/// The numbers of the case file: key, values, unit, and the power of the scale that they are proportional to.
const LENGTHS: [(&str, [f64; 2]); 2] = [("domain.x", [-0.3, 0.4]), ("domain.z", [-0.2, 0.15])];
const NUMBERS: [(&str, f64, &str, f64); 5] = [
    ("grid.cell", 0.0125, "m", 1.0),
    ("body.wheel.diameter", 0.2, "m", 1.0),
    ("body.wheel.sinkage", 0.01, "m", 1.0),
    ("body.wheel.weight", 320.0, "N", 2.0),
    ("soil.young_modulus", 5e6, "Pa", 1.0),
];
const TIMES: [(&str, f64); 2] = [("run.duration", 0.2), ("output.history_interval", 0.002)];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let one = scaled(runner, 1.0)?;
    for scale in [4.0, 1.7] {
        let other = scaled(runner, scale)?;
        for fraction in [0.5, 1.0] {
            let variant = format!("{scale} times as large, {} ms", 1e3 * fraction * TIMES[0].1);
            let error = difference(&one, &other, scale, fraction);
            let figures = [("deviation of F/(γ d² b) from the original", error)];
            runner.put("A7", &variant, other.wall_s, &figures)?;
        }
    }
    Ok(())
}

fn scaled(runner: &mut Runner, scale: f64) -> Result<Simulation, VerifyError> {
    let root = scale.sqrt();
    let mut overrides: Vec<String> = NUMBERS
        .iter()
        .map(|(key, value, unit, power)| format!("{key}={:e} {unit}", value * scale.powf(*power)))
        .collect();
    for (key, [low, high]) in LENGTHS {
        overrides.push(format!("{key}=['{:e} m', '{:e} m']", low * scale, high * scale));
    }
    overrides.extend(TIMES.iter().map(|(key, value)| format!("{key}={:e} s", value * root)));
    let (speed, start, ramp, down) = (0.2 * root, 0.05 * root, 0.05 * root, 0.02 * root);
    overrides.push(format!(
        "body.wheel.forward={{ speed = '{speed:e} m/s', start = '{start:e} s', ramp = '{ramp:e} s' }}"
    ));
    overrides.push(format!("body.wheel.heave={{ load = '0 N', start = '0 s', ramp = '{down:e} s' }}"));
    runner.run("A7", &format!("{scale} times as large"), CASE, &overrides)
}

/// Largest difference of the dimensionless forces in the first `fraction` of the time.
fn difference(one: &Simulation, other: &Simulation, scale: f64, fraction: f64) -> f64 {
    let (a, b) = (&one.history.bodies[0], &other.history.bodies[0]);
    if a.len() != b.len() {
        return f64::NAN;
    }
    let unit = one.case.soil.unit_weight * 0.2 * 0.2;
    let count = (fraction * (a.len() - 1) as f64) as usize;
    let error = |a: &BodySample, b: &BodySample, force: fn(&BodySample) -> f64| {
        (force(a) - force(b) / scale.powi(2)).abs() / unit
    };
    let each = a.iter().zip(b).take(count + 1);
    each.fold(0.0, |most: f64, (a, b)| {
        let worse = error(a, b, |s| s.drag).max(error(a, b, |s| s.vertical));
        if worse.is_nan() { f64::NAN } else { most.max(worse) }
    })
}
