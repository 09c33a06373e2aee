//! How long to run.

use crate::body::Body;
use crate::key::allowed::POSITIVE;
use crate::path::travel;
use crate::stage::Stage;
use input::key::{Key, KeyOf, Kind, Place, declared, in_ranges, numbers, required};
use input::problem::Problems;
use input::quantity::{LENGTH, TIME};
use input::typed::Section;
use mechanics::Motion;

/// Keys of a run, and where the values of a duration [s] lie.
const FIELDS: &[KeyOf<f64>] = &[
    KeyOf::new("duration", Kind::Quantity(TIME), Place::Derived(|duration: &mut f64| Some(duration)))
        .derived("this or tow_distance")
        .within(POSITIVE)
        .means("How long to run."),
    KeyOf::new("tow_distance", Kind::Quantity(LENGTH), Place::Elsewhere)
        .derived("this or duration")
        .within(POSITIVE)
        .means("Run until every towed body has travelled this far."),
];

/// Keys of the run, without the places of their values.
pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

/// Reports a duration [s] that is out of range.
pub(crate) fn check(duration: f64, problems: &mut Problems) {
    in_ranges("run", &numbers(FIELDS, &duration), problems);
}

/// The duration [s].
pub(crate) fn duration(
    section: &Section,
    bodies: &[Body],
    typed: &[Section],
    stages: Option<&[Stage]>,
    problems: &mut Problems,
) -> Option<f64> {
    if !typed.is_empty() {
        for key in ["duration", "tow_distance"].into_iter().filter(|key| section.has(key)) {
            let message = "the stages determine the end of the run";
            problems.add(section.at(key), message, format!("remove `{key}`, or the stages"));
        }
        return stages.map(|stages| stages.iter().map(|stage| stage.duration).sum());
    }
    if section.has("duration") && section.has("tow_distance") {
        let message = "run.duration and run.tow_distance both determine the end of the run";
        problems.add(section.at("tow_distance"), message, "keep one of them");
        return None;
    }
    if section.has("tow_distance") {
        return tow_time(section, section.number("tow_distance")?, bodies, problems);
    }
    required(FIELDS, "duration", section, problems)
}

/// When the last towed body has travelled `distance` [m].
fn tow_time(section: &Section, distance: f64, bodies: &[Body], problems: &mut Problems) -> Option<f64> {
    let times: Vec<f64> =
        bodies.iter().filter_map(|b| arrival_time(&b.guided().translation[0], distance)).collect();
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
    problems.add(section.at("tow_distance"), message, cure);
    None
}

/// When a towed body has travelled `distance`, forwards or backwards [s]; infinite for never, `None` if it is
/// not towed.
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
