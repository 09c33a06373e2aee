//! Predictions as a function of one parameter.

use super::{Candidate, ModelForecast, Parameter, Strength, Towing, evaluate_all, predict};
use crate::error::ModelResult;

/// The predictions at one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    /// The value, in the parameter's unit.
    pub value: f64,
    /// One entry per requested model, in that order.
    pub models: Vec<ModelForecast>,
}

/// The predictions of `candidates` (all, if empty) for each of `values` of `parameter`, in its SI unit.
///
/// For [`Parameter::Sinkage`] this is the force–sinkage curve. As in [`super::forecast`], plasticity models use the recommended
/// strength. Where a value is out of range for a model, its entry gives the reason.
///
/// # Errors
/// If Davis' angle does not exist for a value (angles out of range).
pub fn curve(
    base: &Towing,
    parameter: Parameter,
    values: &[f64],
    candidates: &[Candidate],
) -> ModelResult<Vec<CurvePoint>> {
    let point = |value: &f64| {
        let case = base.with(parameter, *value);
        let plastic = Strength::recommended(&case).applied(&case)?;
        let models = if candidates.is_empty() {
            evaluate_all(&plastic, &case)
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
