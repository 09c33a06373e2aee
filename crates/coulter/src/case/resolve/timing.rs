//! How long to run, and how often to write.

use crate::case::path::travel;
use crate::case::problem::Problems;
use crate::case::ranges::{self, POSITIVE, POSITIVE_FRACTION};
use crate::case::resolved::{Body, Motion, Output};
use crate::case::typed::Section;

/// Largest number of lines of a history.
const MAX_LINES: f64 = 1e7;

/// The duration [s].
pub(super) fn duration(section: &Section, bodies: &[Body], problems: &mut Problems) -> Option<f64> {
    let duration = ranges::given(section, "duration", &POSITIVE, problems);
    let distance = ranges::given(section, "tow_distance", &POSITIVE, problems);
    if section.has("duration") && section.has("tow_distance") {
        let message = "run.duration and run.tow_distance both determine the end of the run";
        problems.add(section.location_of("tow_distance"), message, "keep one of them");
        return None;
    }
    if !section.has("duration") && !section.has("tow_distance") {
        ranges::missing(section, "duration", problems);
    }
    match distance {
        None => duration,
        Some(distance) => tow_time(section, distance, bodies, problems),
    }
}

/// When the last towed body has travelled `distance` [m].
fn tow_time(section: &Section, distance: f64, bodies: &[Body], problems: &mut Problems) -> Option<f64> {
    let times: Vec<f64> = bodies.iter().filter_map(|b| arrival_time(&b.translation[0], distance)).collect();
    let latest = times.iter().copied().fold(0.0, f64::max);
    if !times.is_empty() && latest.is_finite() {
        return Some(latest);
    }
    let message = if times.is_empty() {
        "run.tow_distance needs a body that is towed at a speed other than 0"
    } else {
        "a body stops before it has been towed that far"
    };
    let cure = "give a body  forward = { speed = \"0.2 m/s\" },  or use run.duration";
    problems.add(section.location_of("tow_distance"), message, cure);
    None
}

/// When a towed body has travelled `distance`, forwards or backwards [s]; infinite for never, `None` if it is not towed.
fn arrival_time(freedom: &Motion, distance: f64) -> Option<f64> {
    let Motion::Prescribed { speed, start, ramp, .. } = *freedom else { return None };
    if speed == 0.0 {
        return None;
    }
    // A ramp covers half of what the full speed would.
    let mut time = start + 0.5 * ramp + distance / speed.abs();
    if time < start + ramp {
        let (mut early, mut late) = (start, start + ramp);
        for _ in 0..60 {
            time = 0.5 * (early + late);
            if travel(freedom, time).abs() < distance { early = time } else { late = time }
        }
    }
    let arrives = travel(freedom, time).abs() >= distance * (1.0 - 1e-9);
    Some(if arrives { time } else { f64::INFINITY })
}

/// What to write.
pub(super) fn output(section: &Section, duration: f64, problems: &mut Problems) -> Option<Output> {
    let history = ranges::or(section, "history_interval", duration / 500.0, &POSITIVE, problems);
    let field = ranges::or(section, "field_interval", duration / 20.0, &POSITIVE, problems);
    let checkpoint = ranges::or(section, "checkpoint_interval", 600.0, &POSITIVE, problems);
    let steady_fraction = ranges::or(section, "steady_fraction", 0.3, &POSITIVE_FRACTION, problems);
    let (history_interval, field_interval) = (history?, field?);
    for (key, interval) in [("history_interval", history_interval), ("field_interval", field_interval)] {
        let count = duration / interval;
        if count > MAX_LINES {
            let message = format!("output.{key} means {count:.1e} outputs in {duration} s");
            problems.add(section.location_of(key), message, "make the interval longer");
            return None;
        }
    }
    Some(Output {
        history_interval,
        field_interval,
        checkpoint_interval: checkpoint?,
        steady_fraction: steady_fraction?,
    })
}
