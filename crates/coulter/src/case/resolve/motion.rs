//! How a degree of freedom moves.

use crate::case::problem::Problems;
use crate::case::ranges;
use crate::case::resolved::Motion;
use crate::case::typed::{self, Section, Typed};

/// Default time over which a load is applied or a speed reached [s].
const RAMP: f64 = 0.1;

/// Whether the section lets this degree of freedom move freely.
pub(super) fn is_free(section: &Section, key: &str) -> bool {
    section.motion(key).is_some_and(|m| m.value.word.as_deref() == Some("free") || m.value.load.is_some())
}

/// One degree of freedom; while it is free, a load replaces `support` [N], the force that carries the body until then.
pub(super) fn freedom(section: &Section, key: &str, support: f64, problems: &mut Problems) -> Option<Motion> {
    if !section.has(key) {
        return Some(Motion::Fixed);
    }
    let typed = section.motion(key)?;
    let motion = &typed.value;
    match motion.word.as_deref() {
        Some("free") => return Some(Motion::Free { load: 0.0, support, start: 0.0, ramp: RAMP }),
        Some(_) => return Some(Motion::Fixed),
        None => {}
    }
    let (start, ramp, end) = times(motion, problems)?;
    match (&motion.speed, &motion.load) {
        (Some(speed), None) => {
            Some(Motion::Prescribed { speed: speed.value, start, ramp, end: end.unwrap_or(f64::INFINITY) })
        }
        (None, Some(load)) if end.is_none() => Some(Motion::Free { load: load.value, support, start, ramp }),
        (None, Some(_)) => {
            problems.add(&typed.location, "a load has no `end`", "remove `end`, which belongs to a speed");
            None
        }
        (Some(_), Some(_)) => {
            let message = format!("{}: a speed and a load at once", ranges::dotted(section, key));
            problems.add(
                &typed.location,
                message,
                "give the speed or the load; the other one is a result of the run",
            );
            None
        }
        (None, None) => {
            let message = format!("{}: neither a speed nor a load", ranges::dotted(section, key));
            problems.add(&typed.location, message, "add `speed` or `load`, or write \"free\" or \"fixed\"");
            None
        }
    }
}

/// Start, ramp and end [s].
fn times(motion: &typed::Motion, problems: &mut Problems) -> Option<(f64, f64, Option<f64>)> {
    for time in [&motion.start, &motion.ramp, &motion.end].into_iter().flatten() {
        if time.value < 0.0 {
            problems.add(&time.location, "a time before the start of the run", "times must be 0 or more");
            return None;
        }
    }
    let value = |typed: &Option<Typed<f64>>| typed.as_ref().map(|t| t.value);
    let (start, ramp) = (value(&motion.start).unwrap_or(0.0), value(&motion.ramp).unwrap_or(RAMP));
    if let Some(end) = motion.end.as_ref().filter(|end| end.value < start + ramp) {
        problems.add(
            &end.location,
            "the motion ends before its ramp does",
            "set `end` to start + ramp or later",
        );
        return None;
    }
    Some((start, ramp, value(&motion.end)))
}
