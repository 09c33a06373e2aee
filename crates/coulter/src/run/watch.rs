//! Checks of a run that is going on: what cannot be mended any more stops it, with place, time and cause.

use crate::history::{EnergySample, History};
use crate::simulation::Simulation;
use crate::trust::boundary::most_pressed_lid_cell;
use crate::trust::energy::body_force;
use crate::trust::limits;
use glam::DVec3;
use solver::error::{Breakdown, Place};
use solver::precision::Precision;

/// Samples in a row that must be beyond hope before a run is stopped: one may be an impact.
const PATIENCE: usize = 10;
/// Samples among which the largest force on the bodies is looked for.
const RECENT: usize = 200;
/// Unexplained energy over the scale of the balance beyond which nothing that is still to come can make it good.
const HOPELESS_BALANCE: f64 = 0.5;

/// What stops a run now, if anything does.
///
/// # Errors
/// [`Breakdown::Untrustworthy`] when the energy balance or the soil at the lid is beyond its limit for good.
pub fn watch<R: Precision>(simulation: &Simulation<R>) -> Result<(), Breakdown> {
    let Simulation { model, state, history, .. } = simulation;
    let broken = |what: String, cure: &str, place: DVec3| {
        let (time, step, place) = (state.time, state.step, Place::at(place));
        Err(Breakdown::Untrustworthy { what, cure: cure.to_owned(), time, step, place })
    };
    let middle = state.bodies.first().map_or(DVec3::NAN, |body| body.position);
    if let Some(share) = hopeless_balance(&history.energy, simulation.setting().energy_floor) {
        let what = format!("{:.0} % of the energy is unexplained", 100.0 * share);
        return broken(what, limits::ENERGY_BALANCE.advice, middle);
    }
    if let Some(share) = pressed_lid(history) {
        let limit = limits::LID.doubtful;
        let what = format!(
            "soil presses against the lid with {share:.1} % of the force on the bodies (limit {limit} %)"
        );
        return broken(what, limits::LID.advice, most_pressed_lid_cell(model, state));
    }
    Ok(())
}

/// The last samples, if there are enough of them.
fn latest<T>(samples: &[T]) -> Option<&[T]> {
    samples.len().checked_sub(PATIENCE).map(|from| &samples[from..])
}

/// Least share of unexplained energy over the last samples, if it is hopeless in all of them.
fn hopeless_balance(energy: &[EnergySample], floor: f64) -> Option<f64> {
    let off = |e: &EnergySample| if e.scale() > floor { (e.unexplained() / e.scale()).abs() } else { 0.0 };
    let least = latest(energy)?.iter().map(off).fold(f64::INFINITY, f64::min);
    (least > HOPELESS_BALANCE).then_some(least)
}

/// Least share of the lid's force over the largest force on the bodies of late [%], if it is broken in all of the last
/// samples.
fn pressed_lid(history: &History) -> Option<f64> {
    let count = history.boundaries.len();
    let force = latest(&history.boundaries)?.iter().map(|b| b.lid_force).fold(f64::INFINITY, f64::min);
    if force <= 0.0 {
        return None;
    }
    let most = (count.saturating_sub(RECENT)..count).map(|n| body_force(history, n)).fold(0.0, f64::max);
    let share = 100.0 * force / most;
    (most > 0.0 && share > limits::LID.doubtful).then_some(share)
}
