//! Checks during a run: an error that cannot be recovered from stops it, with position, time and cause.

use crate::simulation::Simulation;
use case::overlap;
use glam::DVec3;
use results::history::probes::most_pressed_lid_cell;
use results::history::{EnergySample, History};
use results::trust::energy::body_force;
use results::trust::{Setting, limits};
use solver::error::{Breakdown, Location};
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// Consecutive samples beyond the limit before a run is stopped: a single one may be an impact.
const PATIENCE: usize = 10;
/// Recent samples among which the largest force on the bodies is taken.
const RECENT: usize = 200;
/// Relative error of the energy balance that the rest of the run cannot make good.
const FATAL_BALANCE_ERROR: f64 = 0.5;

/// Stops a run that can no longer become valid.
///
/// # Errors
/// [`Breakdown::Untrustworthy`] when the energy balance or the soil at the lid is beyond its limit for
/// several samples.
pub fn watch<R: Precision>(simulation: &Simulation<R>) -> Result<(), Breakdown> {
    let Simulation { model, state, history, .. } = simulation;
    let broken = |what: String, cure: &str, at: DVec3| {
        let (time, step, location) = (state.time, state.step, Location::at(at));
        Err(Breakdown::Untrustworthy { what, cure: cure.to_owned(), time, step, location })
    };
    let middle = state.mechanism.bodies.first().map_or(DVec3::NAN, |body| body.pose.position);
    if let Some(error) = fatal_balance_error(&history.energy, simulation.setting()) {
        let what = format!("{:.0} % of the energy is unexplained", 100.0 * error);
        return broken(what, limits::ENERGY_BALANCE.advice, middle);
    }
    if let Some((one, other, at)) = meeting_bodies(model, state) {
        let what = format!("the bodies `{one}` and `{other}` have run into each other");
        let cure = "let them touch, by a joint of kind \"contact\", or keep them apart by their motions";
        return broken(what, cure, at);
    }
    if let Some(per_cent) = pressed_lid(history, simulation.setting().least_force()) {
        let limit = limits::LID.doubtful;
        let what = format!(
            "soil presses against the lid with {per_cent:.1} % of the force on the bodies (limit {limit} %)"
        );
        return broken(what, limits::LID.advice, most_pressed_lid_cell(model, state, simulation.halo()));
    }
    Ok(())
}

/// Overlap of two bodies that ends a run, in cell widths (chosen: less, soil would not notice).
const MEETING: f64 = 0.25;

/// Two bodies that have run into each other: their names, and where the first is [m].
fn meeting_bodies<R: Precision>(model: &Model, state: &State<R>) -> Option<(String, String, DVec3)> {
    let placed = |n: usize| (model.bodies[n].shape.as_ref(), state.pose(n));
    let touching: Vec<usize> =
        (0..model.bodies.len()).filter(|n| model.bodies[*n].shape.has_surface()).collect();
    touching.iter().enumerate().find_map(|(k, &n)| {
        let other = touching[..k]
            .iter()
            .find(|&&m| overlap::depth(placed(n), placed(m)) > MEETING * model.grid.finest());
        other.map(|&m| (model.bodies[m].name.clone(), model.bodies[n].name.clone(), state.pose(n).position))
    })
}

/// The last samples, if there are enough of them.
fn latest<T>(samples: &[T]) -> Option<&[T]> {
    samples.len().checked_sub(PATIENCE).map(|from| &samples[from..])
}

/// Least relative error of the energy balance over the last samples, if it is fatal in all of them.
fn fatal_balance_error(energy: &[EnergySample], setting: &Setting) -> Option<f64> {
    let least =
        latest(energy)?.iter().map(|sample| setting.closure(sample).abs()).fold(f64::INFINITY, f64::min);
    (least > FATAL_BALANCE_ERROR).then_some(least)
}

/// Least force on the lid over the largest recent force on the bodies [%], if it is beyond the limit in all
/// of the last samples; `least` is a force that means anything [N].
fn pressed_lid(history: &History, least: f64) -> Option<f64> {
    let count = history.boundaries.len();
    let force = latest(&history.boundaries)?.iter().map(|b| b.lid_force).fold(f64::INFINITY, f64::min);
    if force <= 0.0 {
        return None;
    }
    let most = (count.saturating_sub(RECENT)..count).map(|n| body_force(history, n)).fold(0.0, f64::max);
    let per_cent = 100.0 * force / most;
    (most > least && per_cent > limits::LID.doubtful).then_some(per_cent)
}
