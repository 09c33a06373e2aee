//! Motion of the bodies in a step: velocities predicted without contact; positions updated with those after
//! contact.

use crate::model::Model;
use crate::state::{Body, ContactImpulse, Pose};
use glam::DVec3;

/// Body step record: velocities of a body in one step, and the contact impulse on it.
#[derive(Clone, Copy, Debug, Default)]
pub struct BodyStep {
    /// Velocity at the start of the step [m/s].
    pub(crate) velocity_before: DVec3,
    /// Spin at the start of the step [rad/s].
    pub(crate) spin_before: f64,
    /// Velocity under loads and drives alone, without contact [m/s].
    pub(crate) velocity_free: DVec3,
    /// Spin under loads and drives alone, without contact [rad/s].
    pub(crate) spin_free: f64,
    /// Contact impulse of the step, on the modelled fraction of the body.
    pub(crate) contact_impulse: ContactImpulse,
}

/// Velocities of the bodies at the end of a step without contact: prescribed, or accelerated by the loads.
pub(crate) fn predict(model: &Model, bodies: &mut [Body], steps: &mut [BodyStep], time: f64, dt: f64) {
    let middle = time + 0.5 * dt;
    for ((fixed, body), step) in model.bodies.iter().zip(bodies).zip(steps) {
        (step.velocity_before, step.spin_before) = (body.velocity, body.spin);
        for axis in 0..3 {
            let freedom = fixed.translation[axis];
            body.velocity[axis] = if freedom.is_free() {
                body.velocity[axis] + freedom.load(middle) * dt / fixed.mass
            } else {
                freedom.speed(middle)
            };
        }
        let freedom = fixed.spin;
        body.spin = if freedom.is_free() {
            body.spin + freedom.load(middle) * dt / fixed.axle_inertia
        } else {
            freedom.speed(middle)
        };
        (step.velocity_free, step.spin_free) = (body.velocity, body.spin);
    }
}

/// Moves the bodies at their velocities at the end of a step.
pub(crate) fn advance(bodies: &mut [Body], dt: f64) {
    for body in bodies {
        body.position += body.velocity * dt;
        body.angle += body.spin * dt;
    }
}

/// Whether a body has moved so far since the last contact search that another is due.
pub(crate) fn have_moved(model: &Model, bodies: &[Body]) -> bool {
    let limit = model.method.remap_displacement * model.grid.finest();
    model.bodies.iter().zip(bodies).any(|(fixed, body)| {
        let Pose { position, angle } = body.searched_at;
        // The farthest point of the surface moves by this times the rotation; contact points of revolved
        // shapes do not rotate.
        let reach = if fixed.shape.is_revolved() { 0.0 } else { fixed.shape.bounds().1.length() };
        (body.position - position).abs().max_element() > limit || (body.angle - angle).abs() * reach > limit
    })
}
