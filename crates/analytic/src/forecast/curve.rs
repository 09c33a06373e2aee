//! Predictions as a function of one parameter.

use super::{Candidate, ModelForecast, Parameter, Strength, Towing, applicability, evaluate};
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
/// For [`Parameter::Sinkage`] this is the force–sinkage curve. As in [`super::forecast`], plasticity models
/// use the recommended strength. Where a value is out of range for a model, its entry gives the reason.
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
        let asked = if candidates.is_empty() { &Candidate::ALL[..] } else { candidates };
        let needed: Vec<Candidate> =
            asked.iter().copied().chain(applicability::decisive(&case, asked)).collect();
        let mut models = evaluate(&needed, &plastic, &case);
        models.truncate(asked.len());
        Ok(CurvePoint { value: *value, models })
    };
    values.iter().map(point).collect()
}
