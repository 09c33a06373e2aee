//! How a degree of freedom moves.

use super::context::checked;
use crate::case::problem::Problems;
use crate::case::resolved::Motion;
use crate::case::typed::{self, Section};
use crate::case::validate;

/// How a degree of freedom was typed; one that is not given is `free_unless_given` or has its default.
pub(super) fn typed(section: &Section, key: &str, free_unless_given: bool) -> Option<typed::Motion> {
    let motion = section.motion(key)?;
    let is_free = free_unless_given && !section.has(key);
    Some(if is_free { typed::Motion { word: Some("free".to_owned()), ..motion } } else { motion })
}

/// Whether a degree of freedom is free.
pub(super) fn is_free(motion: Option<&typed::Motion>) -> bool {
    motion.is_some_and(|m| m.word.as_deref() == Some("free") || m.load.is_some())
}

/// The degree of freedom at a path; while it is free, a load replaces `support` [N], the force that carries the body until then.
pub(super) fn freedom(
    path: String,
    typed: Option<&typed::Motion>,
    support: f64,
    problems: &mut Problems,
) -> Option<Motion> {
    let motion = read(typed?, support, &path, problems)?;
    checked(motion, problems, |motion, problems| validate::body::motion(&path, motion, problems))
}

/// Rotation about the axle, of a body that moves forward and sideways so, rolls on a radius [m] and has this yaw [rad].
pub(super) fn spin(
    (path, typed): (String, Option<&typed::Motion>),
    [forward, lateral]: [Option<Motion>; 2],
    (radius, yaw): (Option<f64>, f64),
    problems: &mut Problems,
) -> Option<Motion> {
    let Some(slip) = typed?.slip else { return freedom(path, typed, 0.0, problems) };
    let typed = typed?;
    let mut refuse = |message: &str, cure: &str| {
        problems.add(&path, message, cure);
        None
    };
    if typed.speed.is_some() || typed.load.is_some() {
        return refuse("a slip and a speed or a load at once", "give one of them");
    }
    if typed.is_timed {
        return refuse("the times of a slip are those of `forward`", "remove `start`, `ramp` and `end`");
    }
    let Some(Motion::Prescribed { speed, start, ramp, end }) = forward else {
        let cure = "write  forward = { speed = \"0.2 m/s\" }, or give the spin a speed";
        return refuse("a slip needs the speed of `forward`", cure);
    };
    let Some(radius) = radius else {
        return refuse("only a body that can roll has a slip", "give the spin a speed");
    };
    if yaw != 0.0 && lateral != Some(Motion::Fixed) {
        let message = "the slip of a body with a yaw is not defined where it also moves sideways";
        return refuse(message, "give the spin a speed");
    }
    // Of a driven wheel the slip refers to the speed of its rim.
    let turn_ratio = if slip > 0.0 { 1.0 / (1.0 - slip) } else { 1.0 + slip };
    let rolling_speed = speed * yaw.cos();
    let spin = Motion::Prescribed { speed: turn_ratio * rolling_speed / radius, start, ramp, end };
    checked(spin, problems, |spin, problems| validate::body::motion(&path, spin, problems))
}

fn read(motion: &typed::Motion, support: f64, path: &str, problems: &mut Problems) -> Option<Motion> {
    let (start, ramp) = (motion.start, motion.ramp);
    match motion.word.as_deref() {
        Some("free") => return Some(Motion::Free { load: 0.0, support, start, ramp }),
        Some(_) => return Some(Motion::Fixed),
        None => {}
    }
    if motion.slip.is_some() {
        problems.add(path, "`slip` belongs to `spin`", "give this motion a speed or a load");
        return None;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::parse;

    const WHEEL: &str = include_str!("../../../../../cases/cmu_wheel.toml");

    fn with(set: &str) -> Result<Motion, String> {
        let case = parse(WHEEL, "case.toml", &[set.to_owned()]);
        case.map(|case| case.bodies[0].spin()).map_err(|problems| format!("{problems:?}"))
    }

    #[test]
    fn a_slip_is_a_rate_of_turning() {
        for (slip, turn_ratio) in [(-1.0, 0.0), (-0.5, 0.5), (0.0, 1.0), (0.5, 2.0)] {
            let spin = with(&format!("body.wheel.spin.slip={slip}")).unwrap();
            let Motion::Prescribed { speed, start, ramp, .. } = spin else { panic!("{spin:?}") };
            assert!((speed - turn_ratio * 0.12 / 0.058).abs() < 1e-12, "{slip}: {speed}");
            assert_eq!([start, ramp], [0.15, 0.05]);
        }
    }

    #[test]
    fn a_slip_stands_alone_and_in_the_spin() {
        for (set, message) in [
            ("body.wheel.spin.slip=1", "below 1"),
            ("body.wheel.spin.speed=1 rad/s", "a slip and a speed or a load at once"),
            ("body.wheel.spin.start=1 s", "the times of a slip are those of `forward`"),
            ("body.wheel.forward=free", "a slip needs the speed of `forward`"),
            ("body.wheel.lateral={ slip = 0 }", "`slip` belongs to `spin`"),
        ] {
            let refusal = with(set).unwrap_err();
            assert!(refusal.contains(message), "{set}: {refusal}");
        }
    }
}
