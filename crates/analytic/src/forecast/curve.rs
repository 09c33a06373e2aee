//! A model's answer against any parameter.

use super::{Candidate, ModelForecast, Parameter, Towing, every_model, predict};
use crate::error::Answer;

/// The models' answers at one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    /// The value, in the parameter's unit.
    pub value: f64,
    /// One entry per model asked for, in that order.
    pub models: Vec<ModelForecast>,
}

/// The answers of `candidates` (all, if empty) as `parameter` takes each of `values`.
///
/// Against [`Parameter::Sinkage`] it is the force–sinkage curve. As in [`super::forecast`], plasticity models use Davis'
/// angle. A value out of a model's range is refused in that model's entry.
///
/// # Errors
/// If the operative soil of a value cannot be formed (angles out of range).
pub fn curve(
    base: &Towing,
    parameter: Parameter,
    values: &[f64],
    candidates: &[Candidate],
) -> Answer<Vec<CurvePoint>> {
    let point = |value: &f64| {
        let case = base.with(parameter, *value);
        let plastic = Towing { soil: case.soil.operative()?, ..case.clone() };
        let models = if candidates.is_empty() {
            every_model(&plastic, &case)
        } else {
            let table = predict::level_table(&plastic);
            let one = |candidate: &Candidate| {
                let towing = if candidate.is_plastic() { &plastic } else { &case };
                ModelForecast::of(*candidate, predict::predict(*candidate, towing, table.as_ref()))
            };
            candidates.iter().map(one).collect()
        };
        Ok(CurvePoint { value: *value, models })
    };
    values.iter().map(point).collect()
}
