//! The probe of a body: where it is, how it moves, and the forces of the soil on it.

use super::last_sample::LastSample;
use crate::history::BodySample;
use case::tow::TowDirection;
use glam::DVec3;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// A sample of body number `n` with this tow, its forces averaged since the last sample.
pub(super) fn sample<R: Precision>(
    model: &Model,
    state: &State<R>,
    (n, tow): (usize, TowDirection),
    last: &LastSample,
) -> BodySample {
    let (fixed, body) = (&model.bodies[n], &state.bodies[n]);
    let (pose, twist) = (state.pose(n), state.twist(n));
    let axle = pose.rotation * DVec3::Y;
    let (now, then) = (body.contact_impulse, last.impulses[n]);
    let interval = state.time - last.time;
    let rate = if interval > 0.0 { 1.0 / interval } else { 0.0 };
    let normal = (now.normal - then.normal) * rate;
    let friction = (now.friction - then.friction) * rate;
    let in_water = tow.turned(fixed.fluid.drag(twist.at(pose.rotation * fixed.fluid.centre)));
    let moved = tow.turned(pose.position - fixed.start.position);
    let symmetry = model.symmetry();
    let force = tow.turned(symmetry.of_whole(symmetry.of_whole(normal) + friction));
    let normal = tow.turned(symmetry.of_whole(normal));
    let pore = tow.turned(symmetry.of_whole((now.pore - then.pore) * rate));
    let moment = symmetry.moment_of_whole((now.moment - then.moment) * rate);
    // The axis of tilt points where the body rolls.
    let ahead = state.tilt_axis(n);
    BodySample {
        time: state.time,
        displacement: moved.x,
        sinkage: model.surface - fixed.bounds(pose).0.z,
        drag: 0.0 - force.x,
        lateral: force.y,
        vertical: force.z,
        drag_normal: 0.0 - normal.x,
        vertical_normal: normal.z,
        axle_torque: moment.dot(axle),
        rotation: body.rotation,
        spin: twist.angular.dot(axle),
        speed: tow.turned(twist.linear).x,
        rolling_speed: twist.linear.dot(ahead),
        heave_speed: twist.linear.z,
        lateral_displacement: moved.y,
        yaw: ahead.y.atan2(ahead.x),
        tilt: axle.z.clamp(-1.0, 1.0).asin(),
        moment_x: moment.x,
        moment_y: moment.y,
        moment_z: moment.z,
        water_drag: 0.0 - in_water.x,
        pore_drag: 0.0 - pore.x,
        pore_vertical: pore.z,
        leaked_volume: body.leaked_volume / model.modelled_fraction(),
        embedded_volume: body.embedded_volume / model.modelled_fraction(),
    }
}
