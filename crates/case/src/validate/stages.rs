//! Stages of a run that wait for what their motions never reach.

use crate::path::travel;
use crate::resolved::{Case, Motion, StageQuantity, Until};
use input::problem::Problems;
use input::quantity::plain;

/// Reports stages that wait for a depth or a displacement which their prescribed motion never reaches.
pub(super) fn ends(case: &Case, problems: &mut Problems) {
    for (number, stage) in case.stages.iter().enumerate() {
        let Some(expected) = expected_end(case, number) else { continue };
        let Expected { value, begins, range: [least, most], .. } = expected;
        if (least - expected.slack..=most + expected.slack).contains(&value) {
            continue;
        }
        let [name, unit] = stage.until.map_or(["value", ""], |until| until.quantity.words());
        let [value, begins] = [value, begins].map(plain);
        let farthest = plain(if expected.value > most { most } else { least });
        let message = format!(
            "the stage `{}` waits for a {name} of {value} {unit}, which the motion never reaches: it begins at {begins} {unit} and comes to \
             {farthest} {unit} within its {} s",
            stage.name,
            plain(stage.duration)
        );
        let cure =
            "give the stage another end, a longer `duration`, or the motion another direction or speed";
        problems.add(format!("stage.{}.until", stage.name), message, cure);
    }
}

/// What is known before the run of the end of a stage.
struct Expected {
    /// Value of the quantity that the stage waits for [m].
    value: f64,
    /// Value of that quantity as the stage begins [m].
    begins: f64,
    /// The least and the most that the quantity may become in the stage [m].
    range: [f64; 2],
    /// What is not known of that quantity [m].
    slack: f64,
}

/// What is known before the run of a stage that waits for a sinkage or a displacement; `None` where a motion
/// is free, or where the run itself decides from where it begins.
fn expected_end(case: &Case, number: usize) -> Option<Expected> {
    let Until { body, quantity, value } = case.stages[number].until?;
    let (axis, sign) = quantity.axis()?;
    let of = case.bodies.get(body)?;
    let depth = case.ground.surface() - of.position.z - of.bounds().0.z;
    if of.guide.is_some() {
        return None;
    }
    let (mut how, mut since, mut begin, mut at) = (of.motions()[axis].clone(), 0.0, 0.0, 0.0);
    for (n, stage) in case.stages[..=number].iter().enumerate() {
        if let Some(change) = stage.changes.iter().rfind(|c| c.body == body && c.motion == axis) {
            (how, since) = (change.to.clone(), begin);
        }
        if how.is_free() {
            return None;
        }
        let way = |time: f64| travel(&how, time - since);
        if n == number {
            let begins = if quantity == StageQuantity::Sinkage { depth + sign * at } else { 0.0 };
            let path = extremes(&how, [begin - since, begin + stage.duration - since]);
            let ends = path.map(|way_there| begins + sign * (way_there - way(begin)));
            // From one speed to the next a body goes some way farther, or less far.
            let slack = 1e-9 + ramp(&how) * case.largest_speed();
            let range = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            return Some(Expected { value, begins, range, slack });
        }
        let moved = way(begin + stage.duration) - way(begin);
        // How long an earlier stage lasts that ends otherwise is not known.
        if moved != 0.0 && stage.until.is_some() {
            return None;
        }
        at += moved;
        begin += stage.duration;
    }
    None
}

fn ramp(how: &Motion) -> f64 {
    if let Motion::Prescribed { ramp, .. } = how { *ramp } else { 0.0 }
}

/// Least and most displacement between two times [m].
fn extremes(how: &Motion, [from, to]: [f64; 2]) -> [f64; 2] {
    let ends = [travel(how, from), travel(how, to)];
    let inside = match how {
        Motion::Course(course) => course.moments(to).into_iter().filter(|time| *time > from).collect(),
        _ => Vec::new(),
    };
    let all = inside.into_iter().map(|time| travel(how, time)).chain(ends);
    all.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], way| [least.min(way), most.max(way)])
}
