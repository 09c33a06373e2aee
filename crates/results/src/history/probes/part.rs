//! The probe of the parts of a body: the force of the soil on each.

use super::last_sample::LastSample;
use crate::history::ForceSample;
use case::Case;
use glam::DVec3;
use solver::model::Model;
use solver::state::State;

/// A part of a body that consists of several: the numbers of the body and of the part, and its reference
/// point in the body frame [m].
type Place = (usize, usize, DVec3);

/// The parts with a surface of all bodies that consist of several: name and place. The body itself is the
/// first of its parts.
pub fn places(case: &Case) -> Vec<(String, Place)> {
    let several = case.bodies.iter().enumerate().filter(|(_, body)| !body.parts.is_empty());
    let each = several.flat_map(|(n, body)| {
        let own = (body.name.clone(), body.shape.has_surface(), DVec3::ZERO);
        let parts = body.parts.iter().map(|part| (part.name.clone(), part.shape.has_surface(), part.offset));
        let numbered = std::iter::once(own).chain(parts).enumerate();
        numbered
            .filter(|(_, (_, touches, _))| *touches)
            .map(move |(part, (name, _, at))| (name, (n, part, at)))
    });
    each.collect()
}

/// A sample of a part, its forces averaged since the last sample.
pub(super) fn sample<R>(model: &Model, state: &State<R>, place: Place, last: &LastSample) -> ForceSample {
    let (body, part, offset) = place;
    let now = state.bodies[body].parts[part];
    let then = last.parts.get(body).and_then(|parts| parts.get(part)).copied().unwrap_or_default();
    let interval = state.time - last.time;
    let rate = if interval > 0.0 { 1.0 / interval } else { 0.0 };
    let symmetry = model.symmetry();
    let force = symmetry.of_whole((now.normal - then.normal) * rate + (now.friction - then.friction) * rate);
    let about_body = symmetry.moment_of_whole((now.moment - then.moment) * rate);
    let moment = about_body - (state.pose(body).rotation * offset).cross(force);
    ForceSample {
        time: state.time,
        force_x: force.x,
        force_y: force.y,
        force_z: force.z,
        moment_x: moment.x,
        moment_y: moment.y,
        moment_z: moment.z,
        distance: 0.0,
    }
}
