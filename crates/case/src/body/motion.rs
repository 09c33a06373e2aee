//! How a degree of freedom moves.

use super::MOTIONS;
use crate::key::allowed::{IN_THE_RUN, SLIP};
use crate::key::usual::SPEED as USUAL_SPEED;
use crate::key::words::{FIRST_LINE, ORIGINS};
use crate::key::{checked, in_range};
use input::key::DefaultValue::{Derived, Quantity, Word};
use input::key::{DefaultValue, Key, Kind, key};
use input::motion_table::{self, TabledMotion};
use input::problem::Problems;
use input::quantity::{FORCE, LENGTH, SPEED, TIME, plain};
use input::typed::{self, Section};
use mechanics::{Course, Motion};
use std::path::Path;

const CAUSE: DefaultValue = Derived("one of speed, load, displacement, table");

/// Keys of a motion that is written as a table, `{ speed = "0.2 m/s", ramp = "0.1 s" }`; those of a rotation
/// measure a rate of turning and a torque.
pub(crate) const KEYS: &[Key] = &[
    key(
        "speed",
        Kind::Quantity(SPEED),
        CAUSE,
        "Speed after the ramp; for `spin` a rate of turning.",
    )
    .usually(USUAL_SPEED),
    key(
        "load",
        Kind::Quantity(FORCE),
        CAUSE,
        "Load on a free motion; for `spin` a torque.",
    ),
    key(
        "displacement",
        Kind::Quantity(LENGTH),
        CAUSE,
        "Displacement from rest to rest within the ramp; for `spin` an angle.",
    ),
    key(
        "table",
        Kind::Text,
        CAUSE,
        "Table, relative to the folder of the case file, of displacements or speeds over time (docs/reference/tables.md); its header names them \
         with their units: `time [s],displacement [mm]` or `time [s],speed [mm/s]`. Between its lines a displacement is a smooth curve \
         without overshoot, a speed is linear.",
    ),
    key(
        "from",
        Kind::Choice(&ORIGINS),
        Word("zero"),
        "Which time of a table is `start`: its zero, or its `first line`, of a log that counts from elsewhere.",
    ),
    key(
        "slip",
        Kind::Number,
        Derived("this, speed or load"),
        "Slip of a rolling body, instead of the rate of turning; for `spin` only: −1 locked, 0 rolling, above 0 driven. Its times are those of `forward`.",
    )
    .within(SLIP),
    key("start", Kind::Quantity(TIME), Quantity("0 s"), "When the ramp begins.").within(IN_THE_RUN),
    key(
        "ramp",
        Kind::Quantity(TIME),
        Quantity("0.1 s"),
        "How long it takes until speed, load or displacement are reached.",
    )
    .within(IN_THE_RUN),
    key("end", Kind::Quantity(TIME), Derived("never"), "When a ramp back to rest begins; of a speed only.")
        .within(IN_THE_RUN),
];

/// How a degree of freedom was typed; one that is not given is `free_unless_given` or has its default.
pub(crate) fn typed(section: &Section, key: &str, free_unless_given: bool) -> Option<typed::Motion> {
    let motion = section.motion(key)?;
    let is_free = free_unless_given && !section.has(key);
    Some(if is_free { typed::Motion { word: Some("free".to_owned()), ..motion } } else { motion })
}

/// Whether a degree of freedom is free.
pub(crate) fn is_free(motion: Option<&typed::Motion>) -> bool {
    motion.is_some_and(|m| m.word.as_deref() == Some("free") || m.load.is_some())
}

/// A degree of freedom of a body's section; while it is free, a load replaces `support` [N], the force that
/// carries the body until then.
pub(crate) fn freedom(
    section: &Section,
    number: usize,
    typed: Option<&typed::Motion>,
    support: f64,
    problems: &mut Problems,
) -> Option<Motion> {
    let path = section.at(MOTIONS[number]);
    let motion = read(typed?, support, &path, &section.folder, number, problems)?;
    checked(motion, problems, |motion, problems| check(&path, motion, problems))
}

/// How a body rolls.
pub(crate) struct Rolling<'a> {
    /// Motions of the body forward and sideways.
    pub(crate) ways: [Option<&'a Motion>; 2],
    /// Radius on which the body rolls [m], if it can.
    pub(crate) radius: Option<f64>,
    /// Yaw of the body [rad].
    pub(crate) yaw: f64,
}

/// Rotation about the axle, of a body that rolls so.
pub(crate) fn spin(
    section: &Section,
    typed: Option<&typed::Motion>,
    rolling: &Rolling,
    problems: &mut Problems,
) -> Option<Motion> {
    let Some(slip) = typed?.slip else { return freedom(section, 5, typed, 0.0, problems) };
    let Rolling { ways: [forward, lateral], radius, yaw } = *rolling;
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
    let Some(&Motion::Prescribed { before, speed, start, ramp, end }) = forward else {
        let cure = "write  forward = { speed = \"0.2 m/s\" }, or give the spin a speed";
        return refuse("a slip needs the speed of `forward`", cure);
    };
    let Some(radius) = radius else {
        return refuse("only a body that can roll has a slip", "give the spin a speed");
    };
    if yaw != 0.0 && lateral != Some(&Motion::Fixed) {
        let message = "the slip of a body with a yaw is not defined where it also moves sideways";
        return refuse(message, "give the spin a speed");
    }
    // Of a driven wheel the slip refers to the speed of its rim.
    let turn_ratio = if slip > 0.0 { 1.0 / (1.0 - slip) } else { 1.0 + slip };
    let rolling_speed = speed * yaw.cos();
    let speed = turn_ratio * rolling_speed / radius;
    let spin = Motion::Prescribed { before, speed, start, ramp, end };
    checked(spin, problems, |spin, problems| check(&path, spin, problems))
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
    folder: &Path,
    number: usize,
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

/// Which motions of a body become free in a stage.
pub(super) fn freed(body: &Section, stages: &[Section]) -> [bool; 6] {
    let name = body.path.trim_start_matches("body.");
    let own = |stage: &Section| {
        stage.inner.iter().filter(|inner| of_body(inner) == name).cloned().collect::<Vec<_>>()
    };
    let all: Vec<Section> = stages.iter().flat_map(own).collect();
    MOTIONS.map(|key| all.iter().any(|section| is_free(section.motion(key).as_ref())))
}

/// The name of the body in `stage.tow.disc`.
pub(crate) fn of_body(section: &Section) -> &str {
    section.path.rsplit('.').next().unwrap_or_default()
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

/// Reports what is wrong with the motion at a path.
pub(crate) fn check(path: &str, motion: &Motion, problems: &mut Problems) {
    let mut check = |name: &str, number| in_range(KEYS, path, name, &[number], problems);
    match *motion {
        Motion::Fixed => {}
        Motion::Free { load, support, start, ramp } => {
            check("load", load);
            check("start", start);
            check("ramp", ramp);
            if !support.is_finite() {
                let message = format!("the body is supported by {} N until it is released", plain(support));
                problems.add(path, message, "it must be a finite force");
            }
        }
        Motion::Course(ref course) => {
            if !course.numbers().all(f64::is_finite) {
                problems.add(path, "the displacement over time is not finite", "give it finite numbers");
            }
        }
        Motion::Prescribed { before, speed, start, ramp, end } => {
            check("speed", before);
            check("speed", speed);
            check("start", start);
            check("ramp", ramp);
            if end.is_nan() || end < start + ramp {
                let message = "the motion ends before its ramp does";
                problems.add(format!("{path}.end"), message, "set `end` to start + ramp or later");
            }
        }
    }
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
