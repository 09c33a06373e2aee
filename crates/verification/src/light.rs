//! A12: free bodies that are much lighter than the soil they displace.

use crate::error::VerifyError;
use crate::row::Row;
use crate::runner::Runner;
use coulter::history::BodySample;
use std::f64::consts::PI;

const CASE: &str = include_str!("../../../validation/A12_light_body/case.toml");
const SOURCE: &str = "conservation; limit of the design";
const PASSIVE: &str = "sand is passive: it returns no more energy than it received";
/// Weight of the sand that the body displaces when it is buried [N]: 16 kN/m³, radius 0.1 m, slab 12.5 mm.
const DISPLACED: f64 = 16e3 * PI * 0.1 * 0.1 * 0.0125;
/// Acceleration of gravity [m/s²].
const GRAVITY: f64 = 9.81;
/// Height of fall [m].
const FALL: f64 = 0.1;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A free cylinder in plane strain that is 1, 10, 100 and 1000 times lighter than the sand that it displaces, \
    dropped from half its diameter, and towed half buried while it is free to rise and to turn. Unstable coupling of body and soil \
    would feed energy into it: no speed may exceed that of the fall, and the energy balance must close. A towed body that \
    weighs almost nothing rises; how far is given for information.";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let lighter: &[u32] = if runner.options.fast { &[1000] } else { &[1, 10, 100, 1000] };
    for &lighter in lighter {
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
    let simulation = runner.run("A12", variant, CASE, overrides)?;
    let samples = &simulation.history.bodies[0];
    let most = |value: fn(&BodySample) -> f64| {
        let worse = |most: f64, v: f64| if v > most || v.is_nan() { v } else { most };
        samples.iter().map(value).fold(f64::NEG_INFINITY, worse)
    };
    let closure = simulation.history.energy.last().map_or(f64::NAN, |e| e.closure().abs());
    let last = samples.last().copied().unwrap_or_default();
    let info = |quantity, value| Row::info("A12", variant, quantity, value).took(simulation.wall_s);
    runner.rows.push(info("unexplained energy over external work", closure).at_most(0.01, SOURCE));
    if fastest > 0.0 {
        let ratio = most(|s| s.heave_speed.abs()) / fastest;
        runner.rows.push(info("largest speed over that of the fall", ratio).between(0.0, 1.0, 1e-3, PASSIVE));
        runner
            .rows
            .push(info("largest rebound speed over that of the fall", most(|s| s.heave_speed) / fastest));
    }
    runner.rows.push(info("sinkage at the end [mm]", 1e3 * last.sinkage));
    Ok(())
}
