//! The front door: every closed form that applies to one towed body, side by side.

mod advice;
mod apart;
mod blade;
mod body;
mod candidate;
mod curve;
mod groups;
mod predict;
mod rivals;
mod towing;

pub use body::{Block, Body, Front, Round};
pub use candidate::Candidate;
pub use curve::{CurvePoint, curve};
pub use groups::{Groups, Range, Spread};
pub use predict::{ModelForecast, Prediction, predict};
pub use towing::{Load, Parameter, Towing};

use crate::disc::{SideFaces, side_faces};
use crate::error::Answer;

/// What the closed forms say about one towed body.
#[derive(Clone, Debug, PartialEq)]
pub struct Forecast {
    /// Dimensionless groups of the case and of its model to believe.
    pub groups: Groups,
    /// Every model, evaluated at Davis' operative friction angle where the soil is non-associated.
    pub models: Vec<ModelForecast>,
    /// The same at the full friction angle; empty where the flow is associated and nothing would differ.
    pub models_full_friction: Vec<ModelForecast>,
    /// Friction angle that `models` used [rad].
    pub operative_friction_angle: f64,
    /// Spread over the applicable models.
    pub spread: Option<Spread>,
    /// Friction on the flat faces of a disc, which no model includes.
    pub side_faces: Option<SideFaces>,
    /// The model to believe; none where it has no answer.
    pub recommended: Option<Candidate>,
    /// Which model to believe, and why, in plain words.
    pub recommendation: String,
}

/// Evaluates every model for `towing`.
///
/// # Errors
/// If the case itself is out of range; a model that does not apply says so in its own entry.
pub fn forecast(towing: &Towing) -> Answer<Forecast> {
    towing.check()?;
    let operative = Towing { soil: towing.soil.operative()?, ..towing.clone() };
    let models = every_model(&operative, towing);
    let associated = (towing.soil.dilation_angle - towing.soil.friction_angle).abs() < 1e-12;
    let models_full_friction = if associated { Vec::new() } else { every_model(towing, towing) };
    let recommended = advice::recommended(towing, &models);
    let best = models.iter().find(|model| Some(model.model) == recommended);
    let best = best.or_else(|| models.iter().find(|model| model.applicable));
    let groups = Groups::of(towing, best);
    let faces = best.and_then(|model| model.prediction).and_then(|found| {
        let turn = towing.drive.turning_ratio(found.slip.unwrap_or(0.0));
        side_faces(&towing.soil, towing.body.disc()?, found.sinkage?, turn, 0.5).ok()
    });
    Ok(Forecast {
        groups,
        spread: Spread::of(&models),
        side_faces: faces,
        recommended,
        recommendation: advice::recommend(towing, &models),
        operative_friction_angle: operative.soil.friction_angle,
        models,
        models_full_friction,
    })
}

/// Plasticity models see `plastic`'s soil; the empirical ones, whose friction angle is measured, see `measured`'s.
fn every_model(plastic: &Towing, measured: &Towing) -> Vec<ModelForecast> {
    let table = predict::level_table(plastic);
    let one = |candidate: Candidate| {
        let case = if candidate.is_plastic() { plastic } else { measured };
        ModelForecast::of(candidate, predict(candidate, case, table.as_ref()))
    };
    let mut models: Vec<ModelForecast> = Candidate::ALL.into_iter().map(one).collect();
    apart::set_apart(&mut models, measured);
    let alone = advice::sideways_alone(plastic, &models);
    if let (Some(why), Some(weaker)) = (alone, models.iter_mut().find(|m| m.model == Candidate::Weaker)) {
        weaker.note = why;
    }
    models
}
