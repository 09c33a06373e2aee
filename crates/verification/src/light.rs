//! A12: free bodies that are much lighter than the soil they displace.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::history::BodySample;
use std::f64::consts::PI;

const CASE: &str = include_str!("../validation/A12_light_body/case.toml");
/// Weight of the sand that the body displaces when it is buried [N] per metre: 16 kN/m³, radius 0.1 m.
const DISPLACED: f64 = 16e3 * PI * 0.1 * 0.1;
/// Acceleration of gravity [m/s²].
const GRAVITY: f64 = 9.81;
/// Height of fall [m].
const FALL: f64 = 0.1;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for lighter in [1_u32, 10, 100, 1000] {
        let weight = format!("body.cylinder.weight={} N", DISPLACED / f64::from(lighter));
        let dropped = [
            weight.clone(),
            format!("body.cylinder.sinkage={} m", -FALL),
            "body.cylinder.forward=fixed".to_owned(),
            "body.cylinder.heave={ load = '0 N', ramp = '0 s' }".to_owned(),
        ];
        drop_or_tow(
            runner,
            &format!("{lighter} times lighter, dropped"),
            &dropped,
            (2.0 * GRAVITY * FALL).sqrt(),
        )?;
        drop_or_tow(runner, &format!("{lighter} times lighter, towed"), &[weight], 0.0)?;
    }
    Ok(())
}

/// `fastest` is the largest vertical speed that a passive soil allows [m/s]; 0 where it is not known.
fn drop_or_tow(
    runner: &mut Runner,
    variant: &str,
    overrides: &[String],
    fastest: f64,
) -> Result<(), VerifyError> {
    if !runner.wants("A12", variant)? {
        return Ok(());
    }
    let simulation = runner.run("A12", variant, CASE, overrides)?;
    let samples = &simulation.history.bodies[0];
    let most = |value: fn(&BodySample) -> f64| {
        let worse = |most: f64, v: f64| if v > most || v.is_nan() { v } else { most };
        samples.iter().map(value).fold(f64::NEG_INFINITY, worse)
    };
    let closure = simulation.history.energy.last().map_or(f64::NAN, |e| e.closure().abs());
    let last = samples.last().copied().unwrap_or_default();
    let mut figures = vec![("unexplained energy over external work", closure)];
    if fastest > 0.0 {
        figures.extend([
            ("largest speed over that of the fall", most(|s| s.heave_speed.abs()) / fastest),
            ("largest rebound speed over that of the fall", most(|s| s.heave_speed) / fastest),
        ]);
    }
    figures.push(("sinkage at the end [mm]", 1e3 * last.sinkage));
    runner.put("A12", variant, simulation.wall_s, &figures)
}
