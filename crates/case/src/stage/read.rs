//! The stages of a run: what moves how in each of them, and where prescribed motions take the bodies.

use super::keys::{FIELDS, KEYS};
use super::{Change, Stage, StageQuantity, Until, steady};
use crate::body::{Body, MOTIONS, Rolling, Staged, freedom, of_body, spin};
use crate::context::Context;
use crate::path::travel;
use glam::DVec3;
use input::key::required;
use input::names::nearest;
use input::problem::Problems;
use input::typed::Section;
use mechanics::Motion;

/// How long a motion takes to come to a halt that is written as a word [s].
const HALT: f64 = 0.02;

/// The stages, in the order of the file.
pub(crate) fn stages(
    sections: &[Section],
    bodies: &[Body],
    context: &Context,
    problems: &mut Problems,
) -> Option<Vec<Stage>> {
    let mut now: Vec<[Motion; 6]> = bodies.iter().map(Body::motions).collect();
    let mut all = Vec::new();
    for (number, section) in sections.iter().enumerate() {
        let mut changes = Vec::new();
        for inner in &section.inner {
            let body = number_of(of_body(inner), &inner.path, bodies, problems);
            let Some(body) = body else { continue };
            // Only at the start does a support stand for what carries the body: later it is known from the
            // run.
            let mass = if number == 0 { submerged_mass(&bodies[body], context) } else { 0.0 };
            let held = context.support(mass);
            changes.extend(body_changes(inner, body, &bodies[body], &mut now[body], held, problems));
        }
        let duration = required(FIELDS, "duration", section, problems);
        let until = section.until("until").and_then(|typed| {
            let path = format!("{}.body", section.at("until"));
            let body = number_of(&typed.body, &path, bodies, problems)?;
            let (_, quantity) = *StageQuantity::ALL.iter().find(|(key, _)| *key == typed.key)?;
            Some(Until { body, quantity, value: typed.value })
        });
        let name = section.path.trim_start_matches("stage.").to_owned();
        let steady = section.flag("steady").unwrap_or(false);
        all.push(duration.map(|duration| Stage { name, duration, until, steady, changes }));
    }
    all.into_iter().collect()
}

/// Mass of a body with its parts less that of the water that it displaces [kg].
fn submerged_mass(body: &Body, context: &Context) -> f64 {
    let displaced = context.water.map_or(0.0, |water| body.displaced(&water, context.slab.is_some()).0);
    body.whole_mass() - displaced
}

/// The number of a body that moves for itself.
fn number_of(name: &str, path: &str, bodies: &[Body], problems: &mut Problems) -> Option<usize> {
    let found = bodies.iter().position(|body| body.name == name);
    if found.is_some() {
        return found;
    }
    if let Some(whole) = bodies.iter().find(|body| body.parts.iter().any(|part| part.name == name)) {
        let message = format!("`{name}` is welded to `{}` and moves with it", whole.name);
        problems.add(path, message, format!("name `{}` instead", whole.name));
        return None;
    }
    let names = || bodies.iter().map(|body| &*body.name);
    let cure = nearest(name, names().chain(KEYS.iter().map(|key| key.name))).map_or_else(
        || {
            format!(
                "a stage has `duration`, `until`, `steady` and the names of bodies: {}",
                names().collect::<Vec<_>>().join(", ")
            )
        },
        |near| format!("did you mean `{near}`?"),
    );
    problems.add(path, format!("there is no body \"{name}\""), cure);
    None
}

/// The motions of one body that change in a stage; `now` holds those in force.
fn body_changes(
    section: &Section,
    number: usize,
    body: &Body,
    now: &mut [Motion; 6],
    held: DVec3,
    problems: &mut Problems,
) -> Vec<Change> {
    let mut changes = Vec::new();
    for (n, key) in MOTIONS.iter().enumerate().filter(|(_, key)| section.has(key)) {
        let typed = section.motion(key);
        if typed.as_ref().is_some_and(|typed| typed.end.is_some()) {
            let message = "the motions of a stage end with it";
            problems.add(section.at(key), message, "remove `end`; the next stage says what follows");
            continue;
        }
        let support = if n < 3 { held[n] } else { 0.0 };
        let read = if n == 5 {
            let radius = body.wheel_diameter().map(|diameter| 0.5 * diameter);
            let ways = [Some(&now[0]), Some(&now[1])];
            spin(section, typed.as_ref(), &Rolling { ways, radius, yaw: body.attitude.yaw }, problems)
        } else {
            freedom(section, n, typed.as_ref(), support, problems)
        };
        let Some(read) = read else { continue };
        let halts = read == Motion::Fixed && now[n] != Motion::Fixed;
        let to = match halts {
            true => {
                Motion::Prescribed { before: 0.0, speed: 0.0, start: 0.0, ramp: HALT, end: f64::INFINITY }
            }
            false => read,
        };
        now[n] = to.clone();
        changes.push(Change { body: number, motion: n, to });
    }
    changes
}

/// Tells the bodies where the stages take them; `surface` is the height of the undisturbed ground [m].
pub(crate) fn guide(stages: &[Stage], bodies: &mut [Body], surface: f64) {
    let Some(steady) = steady(stages) else { return };
    let sinkage: Vec<f64> = bodies.iter().map(|body| surface - body.position.z - body.bounds().0.z).collect();
    let is_named = |n: usize| stages.iter().any(|stage| stage.changes.iter().any(|change| change.body == n));
    for n in (0..bodies.len()).filter(|n| is_named(*n)) {
        let staged = staged(stages, n, &bodies[n], steady, &sinkage);
        bodies[n].staged = Some(staged);
    }
}

/// How one body moves in a run of several stages.
fn staged(stages: &[Stage], number: usize, body: &Body, steady: usize, sinkage: &[f64]) -> Staged {
    let mut now = body.motions();
    let mut motions = now.clone();
    let mut since = [0.0; 3];
    let mut was_free = now.each_ref().map(Motion::is_free);
    let (mut at, mut bounds) = ([0.0_f64; 3], [[0.0_f64; 2]; 3]);
    let (mut begin, mut depth_is_known) = (0.0, true);
    for (k, stage) in stages.iter().enumerate() {
        for change in stage.changes.iter().filter(|change| change.body == number) {
            now[change.motion] = change.to.clone();
            was_free[change.motion] |= change.to.is_free();
            if let Some(since) = since.get_mut(change.motion) {
                *since = begin;
            }
        }
        for axis in 0..3 {
            let way = |time: f64| travel(&now[axis], time - since[axis]);
            let mut moved = way(begin + stage.duration) - way(begin);
            if let Some(distance) = until_along(stage, axis, sinkage, at[axis])
                && distance.abs() < moved.abs()
            {
                moved = distance;
            }
            let ends_by_force = stage.until.is_some_and(|until| until.quantity.axis().is_none());
            if axis == 2 && k <= steady && moved != 0.0 && ends_by_force {
                depth_is_known = false;
            }
            at[axis] += moved;
            bounds[axis] = [bounds[axis][0].min(at[axis]), bounds[axis][1].max(at[axis])];
        }
        begin += stage.duration;
        if k == steady {
            motions = now.clone();
        }
    }
    for (n, motion) in motions.iter_mut().enumerate().filter(|(n, motion)| was_free[*n] && !motion.is_free())
    {
        // What it was free to do before is not known: nor is where it stands now.
        if n < 3 {
            *motion = Motion::FREE;
        }
    }
    Staged { motions, bounds, depth_is_known }
}

/// The displacement along an axis that ends a stage, since its beginning; `at` is that until then [m].
fn until_along(stage: &Stage, axis: usize, sinkage: &[f64], at: f64) -> Option<f64> {
    let Until { body, quantity, value } = stage.until?;
    let (along, sign) = quantity.axis()?;
    if along != axis {
        return None;
    }
    Some(match quantity {
        StageQuantity::Sinkage => sign * (value - sinkage[body]) - at,
        _ => sign * value,
    })
}
