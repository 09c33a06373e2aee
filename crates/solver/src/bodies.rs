//! Motion of the bodies in a step, round the mechanism.

use crate::model::Model;
use crate::state::State;
use glam::DVec3;
use mechanics::{Conditions, Mechanism, Step};

/// Velocities of the bodies in the step, without contact: prescribed, or accelerated by loads, gravity and
/// joints.
pub(crate) fn predict<R>(model: &Model, mechanism: &Mechanism, state: &State<R>, step: &mut Step) {
    let conditions =
        Conditions { time: state.time, dt: model.time_step(), gravity: model.gravity * model.down };
    mechanism.predict(&state.mechanism, &conditions, step);
}

/// Moves the bodies with the velocities after contact.
pub(crate) fn advance<R>(mechanism: &Mechanism, state: &mut State<R>, step: &mut Step) {
    mechanism.advance(&mut state.mechanism, step);
    for (body, moved) in state.bodies.iter_mut().zip(&state.mechanism.bodies) {
        let axle = moved.pose.rotation * DVec3::Y;
        body.rotation += moved.twist.angular.dot(axle) * step.dt();
    }
}

/// Whether a body has moved so far since the last contact search that another is due.
pub(crate) fn have_moved<R>(model: &Model, state: &State<R>) -> bool {
    let (limit, aspect) = (model.method.remap_displacement * model.grid.finest(), model.grid.aspect());
    let mut each = model.bodies.iter().zip(&state.bodies).zip(&state.mechanism.bodies);
    each.any(|((fixed, body), now)| {
        let displacement = ((now.pose.position - body.searched_at.position) / aspect).abs().max_element();
        // The farthest point of the surface moves by this times the rotation.
        let (low, high) = fixed.shape.bounds();
        let reach = low.abs().max(high).length();
        let rotation = fixed.attitude(&now.pose) * fixed.attitude(&body.searched_at).inverse();
        let angle = 2.0 * rotation.xyz().length().min(1.0).asin();
        displacement > limit || angle * reach > limit
    })
}
