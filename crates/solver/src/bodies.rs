//! Motion of the bodies in a step: predicted without contact, then carried out with what contact made of it.

use crate::model::Model;
use crate::state::{Body, Received};
use glam::DVec3;

/// What happened to a body in one step.
#[derive(Clone, Copy, Debug, Default)]
pub struct BodyStep {
    /// Velocity at the end of the last step [m/s].
    pub(crate) velocity_before: DVec3,
    /// Spin then [rad/s].
    pub(crate) spin_before: f64,
    /// Velocity under loads and drives alone, without contact [m/s].
    pub(crate) velocity_free: DVec3,
    /// Spin then [rad/s].
    pub(crate) spin_free: f64,
    /// What the modelled share of it received from the soil.
    pub(crate) received: Received,
}

/// Velocities of the bodies at the end of a step without contact: as prescribed, or as the loads make them.
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
        let turn = fixed.spin;
        body.spin = if turn.is_free() {
            body.spin + turn.load(middle) * dt / fixed.axle_inertia
        } else {
            turn.speed(middle)
        };
        (step.velocity_free, step.spin_free) = (body.velocity, body.spin);
    }
}

/// Moves the bodies with their velocities at the end of a step.
pub(crate) fn advance(bodies: &mut [Body], dt: f64) {
    for body in bodies {
        body.position += body.velocity * dt;
        body.angle += body.spin * dt;
    }
}

/// Whether a body has moved so far since the last contact search that its contact points must be found anew.
pub(crate) fn have_moved(model: &Model, bodies: &[Body]) -> bool {
    let limit = model.method.remap_displacement * model.grid.finest();
    model.bodies.iter().zip(bodies).any(|(fixed, body)| {
        let (position, angle) = body.located;
        // How far the farthest point of the surface has turned, unless turning makes no difference.
        let reach = if fixed.shape.is_revolved() { 0.0 } else { fixed.shape.bounds().1.length() };
        (body.position - position).abs().max_element() > limit || (body.angle - angle).abs() * reach > limit
    })
}
