//! The stages of a run: which is on, when it ends, and how the bodies move in the next.

use case::resolved::{Case, StageQuantity, Until};
use case::tow::TowDirection;
use glam::DVec3;
use input::quantity::plain;
use mechanics::Motion;
use results::history::{BodySample, History, StageStart};
use solver::error::{Breakdown, Location};
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// Begins the first stage, if there is one: its motions replace those of the bodies at the start.
pub(crate) fn begin_first(case: &Case, model: &mut Model, history: &mut History) -> bool {
    let Some(first) = case.stages.first() else { return false };
    for change in &first.changes {
        model.bodies[change.body].motion[change.motion] = change.to.clone();
    }
    history.stages.push(StageStart { time: 0.0, motions: motions(model) });
    true
}

/// Gives the bodies of a run that is resumed the motions of the stage that is on.
pub(crate) fn restore(history: &History, model: &mut Model) {
    if let Some(now) = history.stages.last() {
        model.bodies.iter_mut().zip(&now.motions).for_each(|(body, motions)| body.motion = motions.clone());
    }
}

fn motions(model: &Model) -> Vec<[Motion; 6]> {
    model.bodies.iter().map(|body| body.motion.clone()).collect()
}

/// Whether the longest time of the stage that is on is over, at a time [s] and for steps of `dt` [s].
pub(crate) fn time_is_over(case: &Case, history: &History, time: f64, dt: f64) -> bool {
    history.stages.len().checked_sub(1).is_some_and(|on| {
        let end = history.stages[on].time + case.stages[on].duration;
        history.stages_ended.is_none() && time >= end - 0.5 * dt
    })
}

/// Ends the stage that is on, if the last sample says so, and begins the next; returns whether one has begun.
///
/// # Errors
/// [`Breakdown::Untrustworthy`] where its time is over, but not what it waits for.
pub(crate) fn proceed<R: Precision>(
    case: &Case,
    model: &mut Model,
    state: &State<R>,
    history: &mut History,
) -> Result<bool, Breakdown> {
    let Some(on) = history.stages.len().checked_sub(1).filter(|_| history.stages_ended.is_none()) else {
        return Ok(false);
    };
    let is_late = time_is_over(case, history, state.time, model.time_step());
    let reached = case.stages[on].until.map(|until| reached(case, until, history, history.stages[on].time));
    let is_over = match reached {
        None => is_late,
        Some((is_reached, _)) => is_reached,
    };
    if let (Some((false, value)), true) = (reached, is_late) {
        return Err(too_late(case, on, value, state));
    }
    if !is_over {
        return Ok(false);
    }
    let Some(next) = case.stages.get(on + 1) else {
        history.stages_ended = Some(state.time);
        return Ok(false);
    };
    for change in &next.changes {
        let body = change.body;
        let speed = state.mechanism.bodies[body].rates()[change.motion];
        let load = match &model.bodies[body].motion[change.motion] {
            free @ Motion::Free { .. } => free.load(state.time),
            _ => support(case, history, body, change.motion),
        };
        let to = change.to.taking_over(state.time, speed, load);
        model.bodies[body].motion[change.motion] = to;
    }
    history.stages.push(StageStart { time: state.time, motions: motions(model) });
    Ok(true)
}

/// Difference from a value [m, N or N m] that counts as round-off, of a value beyond 1 relative to it.
const ROUND_OFF: f64 = 1e-9;

/// Whether what ends a stage that began at a time [s] is reached, and its value now.
fn reached(case: &Case, until: Until, history: &History, began: f64) -> (bool, f64) {
    let samples = &history.bodies[until.body];
    let first = samples.iter().rfind(|sample| sample.time <= began).copied().unwrap_or_default();
    let now = samples.last().copied().unwrap_or_default();
    let value = |sample: &BodySample| match until.quantity {
        StageQuantity::Sinkage => sample.sinkage,
        StageQuantity::Displacement => {
            // Along x also of a tow backwards.
            let tow = TowDirection::of(case, &case.bodies[until.body]);
            let sign = if tow.is_along_x() { tow.components()[0] } else { 1.0 };
            sign * (sample.displacement - first.displacement)
        }
        StageQuantity::VerticalForce => sample.vertical,
        StageQuantity::Drag => sample.drag,
        StageQuantity::AxleTorque => sample.axle_torque,
    };
    let missing = [value(&first) - until.value, value(&now) - until.value];
    // Where the stage begins at the value, it is reached.
    let is_there = missing.iter().any(|missing| missing.abs() <= ROUND_OFF * until.value.abs().max(1.0));
    (is_there || missing[0] * missing[1] < 0.0, value(&now))
}

fn too_late<R: Precision>(case: &Case, on: usize, value: f64, state: &State<R>) -> Breakdown {
    let stage = &case.stages[on];
    let what = stage.until.map_or_else(String::new, |until| {
        let [name, unit] = until.quantity.words();
        format!("{name} of {} {unit}: it is {} {unit}", plain(until.value), plain(value))
    });
    let at = stage.until.map_or(Location::UNKNOWN, |until| Location::at(state.pose(until.body).position));
    Breakdown::Untrustworthy {
        what: format!(
            "within its {} s the stage `{}` has not reached a {what}",
            plain(stage.duration),
            stage.name
        ),
        cure: "give it a longer `duration`, or another end".to_owned(),
        time: state.time,
        step: state.step,
        location: at,
    }
}

/// The force or torque [N or N m] that has held a degree of freedom of a body against soil and weight.
fn support(case: &Case, history: &History, body: usize, motion: usize) -> f64 {
    let now = history.bodies[body].last().copied().unwrap_or_default();
    let weight = case.weight(&case.bodies[body]) * case.slope.down() + DVec3::ZERO;
    let tow = TowDirection::of(case, &case.bodies[body]);
    let resists = tow.in_space(DVec3::new(now.drag + now.water_drag, -now.lateral, 0.0));
    match motion {
        0 => resists.x - weight.x,
        1 => resists.y - weight.y,
        2 => -weight.z - now.vertical,
        3 => -now.moment_z,
        4 => -now.moment_x,
        _ => -now.axle_torque,
    }
}

/// The times during which averages are taken [s]; `None` for a run of one stage.
pub(crate) fn steady_times(case: &Case, history: &History) -> Option<[f64; 2]> {
    history.stage_times(case.steady_stage()?)
}
