//! How a degree of freedom moves.

use super::context::checked;
use crate::case::problem::Problems;
use crate::case::resolved::Motion;
use crate::case::typed::{self, Section};
use crate::case::validate;

/// Whether the section lets this degree of freedom move freely.
pub(super) fn is_free(section: &Section, key: &str) -> bool {
    section.motion(key).is_some_and(|m| m.word.as_deref() == Some("free") || m.load.is_some())
}

/// One degree of freedom; while it is free, a load replaces `support` [N], the force that carries the body until then.
pub(super) fn freedom(section: &Section, key: &str, support: f64, problems: &mut Problems) -> Option<Motion> {
    let (typed, path) = (section.motion(key)?, section.at(key));
    let motion = read(&typed, support, &path, problems)?;
    checked(motion, problems, |motion, problems| validate::body::motion(&path, motion, problems))
}

fn read(motion: &typed::Motion, support: f64, path: &str, problems: &mut Problems) -> Option<Motion> {
    let (start, ramp) = (motion.start, motion.ramp);
    match motion.word.as_deref() {
        Some("free") => return Some(Motion::Free { load: 0.0, support, start, ramp }),
        Some(_) => return Some(Motion::Fixed),
        None => {}
    }
    match (motion.speed, motion.load) {
        (Some(speed), None) => {
            Some(Motion::Prescribed { speed, start, ramp, end: motion.end.unwrap_or(f64::INFINITY) })
        }
        (None, Some(load)) if motion.end.is_none() => Some(Motion::Free { load, support, start, ramp }),
        (None, Some(_)) => {
            problems.add(path, "a load has no `end`", "remove `end`, which belongs to a speed");
            None
        }
        (Some(_), Some(_)) => {
            let message = format!("{path}: a speed and a load at once");
            problems.add(path, message, "give the speed or the load; the other one is a result of the run");
            None
        }
        (None, None) => {
            let message = format!("{path}: neither a speed nor a load");
            problems.add(path, message, "add `speed` or `load`, or write \"free\" or \"fixed\"");
            None
        }
    }
}
