//! The probes: what they read from a state becomes a sample of the history.
//!
//! Probes see case, model and state and change neither. Forces are impulses since the last sample over the
//! time since then, so that nothing that happens between two samples is lost.

mod body;
mod boundary;
mod energy;
mod ground_left;
mod joint;
mod last_sample;
mod part;
mod rim;
mod voids;

use super::{EnergySample, History};
pub use boundary::most_pressed_lid_cell;
use case::Case;
use case::tow::TowDirection;
pub use ground_left::record_ground_left;
pub use last_sample::LastSample;
pub use part::places;
use solver::halo::Halo;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// Enters a state into the history, with the tow of each body; `last` is what the probes remember of the
/// sample before, and of this one then.
pub fn sample<R: Precision>(
    (case, model, tows): (&Case, &Model, &[TowDirection]),
    state: &State<R>,
    halo: &Halo,
    last: &mut LastSample,
    history: &mut History,
) {
    for (n, (samples, tow)) in history.bodies.iter_mut().zip(tows).enumerate() {
        samples.push(body::sample(model, state, (n, *tow), last));
    }
    for (samples, (_, place)) in history.parts.iter_mut().zip(places(case)) {
        samples.push(part::sample(model, state, place, last));
    }
    for (n, (samples, joint)) in history.joints.iter_mut().zip(&case.joints).enumerate() {
        samples.push(joint::sample(model, joint, state, n, last));
    }
    for (n, (rim, tow)) in history.rims.iter_mut().zip(tows).enumerate() {
        rim.push(state.time, rim::sums(model, &state.bodies[n], *tow));
    }
    let void = voids::sample(case, model, state, halo);
    history.energy.push(EnergySample { void, ..energy::sample(model, state, halo) });
    history.boundaries.push(boundary::sample(case, model, state, halo));
    *last = LastSample::of(state);
}
