//! The probe of a joint: the force through it.

use super::last_sample::LastSample;
use crate::history::ForceSample;
use case::resolved::{Joint, JointKind};
use mechanics::{Pose, Wrench};
use solver::model::Model;
use solver::state::State;

/// A sample of joint number `n`, its forces averaged since the last sample.
pub(super) fn sample<R>(
    model: &Model,
    joint: &Joint,
    state: &State<R>,
    n: usize,
    last: &LastSample,
) -> ForceSample {
    let interval = state.time - last.time;
    let rate = if interval > 0.0 { 1.0 / interval } else { 0.0 };
    let then = last.joints.get(n).copied().unwrap_or(Wrench::ZERO);
    let force = rate * (state.mechanism.joints[n].on_second - then);
    let now = state.pose(joint.second);
    let at = now.point(model.bodies[joint.second].start.point_in_body(joint.position));
    let from = match joint.kind {
        JointKind::Spring { from, .. } => from,
        _ => joint.position,
    };
    let [start, first] =
        joint.first.map_or([Pose::IDENTITY; 2], |first| [model.bodies[first].start, *state.pose(first)]);
    let moment = force.moment_about(at - now.position);
    ForceSample {
        time: state.time,
        force_x: force.force.x,
        force_y: force.force.y,
        force_z: force.force.z,
        moment_x: moment.x,
        moment_y: moment.y,
        moment_z: moment.z,
        distance: at.distance(first.point(start.point_in_body(from))),
    }
}
