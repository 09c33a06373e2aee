//! How a degree of freedom moves.

use super::context::checked;
use crate::keys::words::FIRST_LINE;
use crate::resolved::{MOTIONS, Motion};
use crate::validate;
use input::motion_table::{self, TabledMotion};
use input::problem::Problems;
use input::typed::{self, Section};
use mechanics::Course;
use std::path::Path;

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

/// A degree of freedom of a body's section; while it is free, a load replaces `support` [N], the force that
/// carries the body until then.
pub(super) fn freedom(
    (section, number): (&Section, usize),
    typed: Option<&typed::Motion>,
    support: f64,
    problems: &mut Problems,
) -> Option<Motion> {
    let path = section.at(MOTIONS[number]);
    let motion = read(typed?, support, &path, (&section.folder, number), problems)?;
    checked(motion, problems, |motion, problems| validate::body::motion(&path, motion, problems))
}

/// Rotation about the axle, of a body that moves forward and sideways so, rolls on a radius [m] and has this
/// yaw [rad].
pub(super) fn spin(
    (section, typed): (&Section, Option<&typed::Motion>),
    [forward, lateral]: [&Option<Motion>; 2],
    (radius, yaw): (Option<f64>, f64),
    problems: &mut Problems,
) -> Option<Motion> {
    let Some(slip) = typed?.slip else { return freedom((section, 5), typed, 0.0, problems) };
    let (typed, path) = (typed?, section.at(MOTIONS[5]));
    let mut refuse = |message: &str, cure: &str| {
        problems.add(&path, message, cure);
        None
    };
    if causes(typed) > 1 {
        return refuse("a slip and another motion at once", "give one of them");
    }
    if typed.is_timed {
        return refuse("the times of a slip are those of `forward`", "remove `start`, `ramp` and `end`");
    }
    let Some(Motion::Prescribed { before, speed, start, ramp, end }) = *forward else {
        let cure = "write  forward = { speed = \"0.2 m/s\" }, or give the spin a speed";
        return refuse("a slip needs the speed of `forward`", cure);
    };
    let Some(radius) = radius else {
        return refuse("only a body that can roll has a slip", "give the spin a speed");
    };
    if yaw != 0.0 && *lateral != Some(Motion::Fixed) {
        let message = "the slip of a body with a yaw is not defined where it also moves sideways";
        return refuse(message, "give the spin a speed");
    }
    // Of a driven wheel the slip refers to the speed of its rim.
    let turn_ratio = if slip > 0.0 { 1.0 / (1.0 - slip) } else { 1.0 + slip };
    let rolling_speed = speed * yaw.cos();
    let speed = turn_ratio * rolling_speed / radius;
    let spin = Motion::Prescribed { before, speed, start, ramp, end };
    checked(spin, problems, |spin, problems| validate::body::motion(&path, spin, problems))
}

/// How many causes of a motion were typed.
fn causes(motion: &typed::Motion) -> usize {
    let numbers = [motion.speed, motion.load, motion.displacement, motion.slip];
    numbers.iter().flatten().count() + usize::from(motion.table.is_some())
}

fn read(
    motion: &typed::Motion,
    support: f64,
    path: &str,
    (folder, number): (&Path, usize),
    problems: &mut Problems,
) -> Option<Motion> {
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
    if causes(motion) > 1 {
        let message = format!("{path}: more than one of speed, load, displacement and table");
        problems.add(path, message, "give one of them; the others are results of the run");
        return None;
    }
    if motion.end.is_some() && motion.speed.is_none() {
        problems.add(path, "only a speed has an `end`", "remove `end`, which belongs to a speed");
        return None;
    }
    if motion.from.is_some() && motion.table.is_none() {
        problems.add(path, "only a table has a `from`", "remove `from`; `start` says when a motion begins");
        return None;
    }
    if let Some(displacement) = motion.displacement {
        return displaced(displacement, [start, ramp], path, problems).map(Motion::Course);
    }
    if let Some(file) = &motion.table {
        let begins_with_first = motion.from.as_deref() == Some(FIRST_LINE);
        return match motion_table::read(&folder.join(file), number, begins_with_first) {
            Ok(TabledMotion { course, remarks }) => {
                remarks.iter().for_each(|remark| problems.remark(format!("{path}: {file}: {remark}")));
                Some(Motion::Course(course.later(start)))
            }
            Err(problem) => {
                problems.add(format!("{path}.table"), format!("{file}: {}", problem.message), problem.cure);
                None
            }
        };
    }
    match (motion.speed, motion.load) {
        (Some(speed), None) => {
            let end = motion.end.unwrap_or(f64::INFINITY);
            Some(Motion::Prescribed { before: 0.0, speed, start, ramp, end })
        }
        (None, Some(load)) => Some(Motion::Free { load, support, start, ramp }),
        _ => {
            let message = format!("{path}: none of speed, load, displacement and table");
            problems.add(path, message, "add one of them, or write \"free\" or \"fixed\"");
            None
        }
    }
}

/// A displacement from rest to rest.
fn displaced(to: f64, [start, ramp]: [f64; 2], path: &str, problems: &mut Problems) -> Option<Course> {
    let course = Course::through(vec![start, start + ramp], vec![0.0, to]);
    if course.is_none() {
        let message = format!("{path}: a displacement within no time");
        problems.add(format!("{path}.ramp"), message, "give it a ramp: ramp = \"1 s\"");
    }
    course
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    const WHEEL: &str = include_str!("../../../../cases/cmu_wheel.toml");

    fn with(set: &str) -> Result<Motion, String> {
        let case = parse(WHEEL, "case.toml", &[set.to_owned()]);
        case.map(|case| case.bodies[0].spin().clone()).map_err(|problems| format!("{problems:?}"))
    }

    #[test]
    fn a_slip_is_a_rate_of_turning() {
        for (slip, turn_ratio) in [(-1.0, 0.0), (-0.5, 0.5), (0.0, 1.0), (0.5, 2.0)] {
            let spin = with(&format!("body.wheel.spin.slip={slip}")).unwrap().clone();
            let Motion::Prescribed { speed, start, ramp, .. } = spin else { panic!("{spin:?}") };
            assert!((speed - turn_ratio * 0.12 / 0.058).abs() < 1e-12, "{slip}: {speed}");
            assert_eq!([start, ramp], [0.15, 0.05]);
        }
    }

    #[test]
    fn a_slip_stands_alone_and_in_the_spin() {
        for (set, message) in [
            ("body.wheel.spin.slip=1", "below 1"),
            ("body.wheel.spin.speed=1 rad/s", "a slip and another motion at once"),
            ("body.wheel.spin.start=1 s", "the times of a slip are those of `forward`"),
            ("body.wheel.forward=free", "a slip needs the speed of `forward`"),
            ("body.wheel.lateral={ slip = 0 }", "`slip` belongs to `spin`"),
        ] {
            let refusal = with(set).unwrap_err();
            assert!(refusal.contains(message), "{set}: {refusal}");
        }
    }
}
