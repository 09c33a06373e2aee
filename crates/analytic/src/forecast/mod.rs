//! The forecast: all closed-form models for one body that is towed or pressed down.

mod applicability;
mod blade;
mod body;
mod candidate;
mod curve;
mod groups;
mod other_models;
mod predict;
mod prediction;
mod pressed;
mod pushed;
mod recommendation;
mod scatter;
mod strength;
mod towing;

pub use body::{Block, Body, FacetedBody, Front, Outline, Penetrometer, Pipe, Plate, reference_force};
pub use candidate::Candidate;
pub use curve::{CurvePoint, curve};
pub use groups::Groups;
pub use predict::predict;
pub use prediction::{ModelForecast, Prediction};
pub use recommendation::best;
pub use scatter::{Range, Scatter};
pub use strength::Strength;
pub use towing::{Load, Parameter, Towing};

use crate::disc::{SideFaces, side_faces};
use crate::error::ModelResult;

/// Predictions of the closed-form models for one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Forecast {
    /// Dimensionless groups of the case and of the recommended prediction.
    pub groups: Groups,
    /// All models, the plasticity models at the recommended strength.
    pub models: Vec<ModelForecast>,
    /// The friction angle of the plasticity models in `models`.
    pub strength: Strength,
    /// All models, the plasticity models at the other strength; empty for associated flow, where nothing
    /// differs.
    pub models_other_strength: Vec<ModelForecast>,
    /// Davis' operative friction angle [rad].
    pub operative_friction_angle: f64,
    /// Scatter between the applicable models.
    pub scatter: Option<Scatter>,
    /// Friction on the flat faces of a disc, which the models neglect.
    pub side_faces: Option<SideFaces>,
    /// The recommended model, if it has a prediction.
    pub recommended: Option<Candidate>,
    /// The recommendation with its reasons, for the user.
    pub recommendation: String,
}

/// Evaluates every model for `towing`.
///
/// # Errors
/// If the case is out of range of all models. Where a single model does not apply, its entry gives the
/// reason.
pub fn forecast(towing: &Towing) -> ModelResult<Forecast> {
    towing.check()?;
    let strength = Strength::recommended(towing);
    let all = &Candidate::ALL;
    let models = evaluate(all, &strength.applied(towing)?, towing);
    let is_associated = (towing.soil.dilation_angle - towing.soil.friction_angle).abs() < 1e-12;
    let models_other_strength =
        if is_associated { Vec::new() } else { evaluate(all, &strength.other().applied(towing)?, towing) };
    let recommended = recommendation::recommended(towing, &models);
    let best = recommendation::best(towing, &models);
    let best = models.iter().find(|model| best.map_or(model.applicable, |best| model.model == best));
    let groups = Groups::of(towing, best);
    let faces = best.and_then(|model| model.prediction).and_then(|found| {
        let turn_ratio = towing.drive.turn_ratio(found.slip.unwrap_or(0.0));
        side_faces(&towing.soil, towing.body.disc()?, found.sinkage?, turn_ratio, 0.5).ok()
    });
    Ok(Forecast {
        groups,
        scatter: Scatter::of(&models),
        side_faces: faces,
        recommended,
        recommendation: recommendation::recommend(towing, &models, &models_other_strength),
        operative_friction_angle: towing.soil.operative()?.friction_angle,
        models,
        strength,
        models_other_strength,
    })
}

/// Some models, judged at the case itself: a prediction outside the limits of its model is marked, as in
/// [`forecast`].
///
/// # Errors
/// If the case is out of range of all models. Where a single model does not apply, its entry gives the
/// reason.
pub fn judge(towing: &Towing, candidates: &[Candidate]) -> ModelResult<Vec<ModelForecast>> {
    towing.check()?;
    let needed: Vec<Candidate> =
        candidates.iter().copied().chain(applicability::decisive(towing, candidates)).collect();
    let mut models = evaluate(&needed, &Strength::recommended(towing).applied(towing)?, towing);
    models.truncate(candidates.len());
    Ok(models)
}

/// The model recommended at the case itself, or else the first that applies there without being recommended;
/// `None` where none applies.
///
/// # Errors
/// If the case is out of range of all models.
pub fn best_at(towing: &Towing) -> ModelResult<Option<Candidate>> {
    for candidate in recommendation::order(towing) {
        if judge(towing, &[*candidate])?[0].applicable {
            return Ok(Some(*candidate));
        }
    }
    Ok(None)
}

/// Models: those of plasticity for `plastic`, the empirical ones, fitted to measured friction angles, for
/// `measured`.
fn evaluate(candidates: &[Candidate], plastic: &Towing, measured: &Towing) -> Vec<ModelForecast> {
    let table = predict::level_table(plastic);
    let one = |candidate: &Candidate| {
        let case = if candidate.is_plastic() { plastic } else { measured };
        ModelForecast::of(*candidate, predict(*candidate, case, table.as_ref()))
    };
    let mut models: Vec<ModelForecast> = candidates.iter().map(one).collect();
    applicability::mark_inapplicable(&mut models, measured);
    let caveat = recommendation::bearing_only_note(plastic, &models);
    if let (Some(caveat), Some(governing)) =
        (caveat, models.iter_mut().find(|m| m.model == Candidate::Governing))
    {
        governing.note = caveat;
    }
    models
}
