//! The results of every model as one number of the case is varied.

use super::outlook::Outlook;
use super::range::Range;
use analytic::forecast::{Candidate, CurvePoint, Parameter, Prediction, best, curve};
use analytic::{Load, Towing};

/// One model's curve; not-a-number where the model has no answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name of the model.
    pub name: &'static str,
    /// Whether the model applies, by point.
    pub applicable: Vec<bool>,
    /// Drag [N].
    pub drag: Vec<f64>,
    /// Vertical force [N].
    pub vertical: Vec<f64>,
    /// Sinkage [m].
    pub sinkage: Vec<f64>,
    /// The slip, [`analytic::slip`].
    pub slip: Vec<f64>,
}

/// Every model's curve against one variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// Name and unit of the variable, as in `forecast::Variable`.
    pub label: String,
    /// Values of the variable, in the unit of the label.
    pub values: Vec<f64>,
    /// Name of the dimensionless abscissa.
    pub group_label: &'static str,
    /// The dimensionless abscissa, by point.
    pub group: Vec<f64>,
    /// Force γ t d² that makes forces dimensionless [N], by point; not-a-number in weightless soil.
    pub force_scale: Vec<f64>,
    /// Reference length that makes lengths dimensionless [m], by point.
    pub length_scale: Vec<f64>,
    /// Whether the body sinks under its weight, so that sinkage is a result.
    pub sinks: bool,
    /// Name of the model that is the best at most points; empty if there is none.
    pub recommended: &'static str,
    /// Values that are not possible and were left out, each with the reason.
    pub left_out: Vec<String>,
    /// Whether the axes are logarithmic.
    pub logarithmic: bool,
    /// One curve for each model that has an answer anywhere.
    pub series: Vec<Series>,
}

/// Evaluates every model along the range, but for values that are not possible.
///
/// # Errors
/// The reasons where no value is possible.
pub fn curves(outlook: &Outlook, range: &Range, logarithmic: bool) -> Result<Curves, String> {
    let (input, variable) = (&outlook.input, &range.variable);
    let wrong = |value: &f64| variable.set(input, *value).check().err();
    let left_out: Vec<String> =
        range.values.iter().filter_map(|value| Some(wrong(value)?.to_string())).collect();
    let possible: Vec<f64> = range.values.iter().copied().filter(|value| wrong(value).is_none()).collect();
    if possible.is_empty() {
        return Err(left_out.first().cloned().unwrap_or_default());
    }
    let values: Vec<f64> = possible.iter().map(|v| variable.model_value(input, *v)).collect();
    let points = curve(&input.towing, variable.parameter, &values, &[]).map_err(|e| e.to_string())?;
    let cases: Vec<Towing> = possible.iter().map(|v| variable.set(input, *v)).collect();
    let (group_label, group) = group(variable.parameter, &cases, variable.label);
    Ok(Curves {
        label: format!("{} [{}]", variable.label, variable.unit),
        values: possible.iter().map(|v| v / variable.size).collect(),
        group: group.unwrap_or_else(|| possible.iter().map(|v| v / variable.size).collect()),
        group_label,
        force_scale: cases.iter().map(|c| c.force_scale().unwrap_or(f64::NAN)).collect(),
        length_scale: cases.iter().map(|c| c.reference_lengths()[0]).collect(),
        sinks: cases.iter().all(|c| matches!(c.load, Load::Weight(_))),
        recommended: most_often_best(&cases, &points),
        left_out,
        logarithmic,
        series: Candidate::ALL.into_iter().filter_map(|model| series(model, &points)).collect(),
    })
}

/// Name of the model that is the best at most points.
fn most_often_best(cases: &[Towing], points: &[CurvePoint]) -> &'static str {
    let bests: Vec<Candidate> =
        cases.iter().zip(points).filter_map(|(case, point)| best(case, &point.models)).collect();
    let count = |model: &Candidate| bests.iter().filter(|other| *other == model).count();
    bests.iter().max_by_key(|model| count(model)).map_or("", |model| model.name())
}

/// The dimensionless form of the variable, where it has one.
fn group(parameter: Parameter, cases: &[Towing], label: &'static str) -> (&'static str, Option<Vec<f64>>) {
    let of = |f: fn(&Towing) -> Option<f64>| cases.iter().map(f).collect::<Option<Vec<f64>>>();
    let weight = |c: &Towing| match c.load {
        Load::Weight(weight) => Some(weight / c.force_scale()?),
        Load::Sinkage(_) => None,
    };
    let (name, values) = match parameter {
        Parameter::Sinkage => (
            "Z = z/d",
            of(|c| match c.load {
                Load::Sinkage(z) => Some(z / c.reference_lengths()[0]),
                Load::Weight(_) => None,
            }),
        ),
        Parameter::Weight | Parameter::UnitWeight => ("W̄ = W/(γ t d²)", of(weight)),
        Parameter::Thickness | Parameter::Diameter => {
            ("t̄ = t/d", of(|c| Some(c.reference_lengths()).map(|[d, t]| t / d)))
        }
        Parameter::Cohesion => {
            ("c/(γ d)", of(|c| Some(c.soil.cohesion / (c.soil.unit_weight * c.reference_lengths()[0]))))
        }
        _ => (label, None),
    };
    if values.is_some() { (name, values) } else { (label, None) }
}

fn series(model: Candidate, points: &[CurvePoint]) -> Option<Series> {
    let entries: Vec<_> =
        points.iter().map(|p| p.models.iter().find(|m| m.model == model)).collect::<Option<_>>()?;
    let column = |f: fn(&Prediction) -> Option<f64>| {
        entries.iter().map(|m| m.prediction.as_ref().and_then(f).unwrap_or(f64::NAN)).collect::<Vec<_>>()
    };
    let drag = column(|p| Some(p.drag));
    drag.iter().any(|x| x.is_finite()).then(|| Series {
        name: model.name(),
        applicable: entries.iter().map(|m| m.applicable).collect(),
        drag,
        vertical: column(|p| Some(p.vertical)),
        sinkage: column(|p| p.sinkage),
        slip: column(|p| p.slip),
    })
}
