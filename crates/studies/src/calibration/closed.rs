//! The closed-form model of a case as what is calibrated.

use super::data::MeasuredCurve;
use super::likelihood::{Response, Seen};
use super::space::Space;
use crate::measured::Record;
use crate::sources::{Along, ClosedForm, ClosedForms, place};
use coulter::case::{CaseError, load_for_forecast};
use coulter::forecast::{Variable, find};
use std::path::{Path, PathBuf};

/// Closed-form curves of a case with values of the unknowns.
#[derive(Clone, Debug)]
pub struct ClosedResponse {
    case: PathBuf,
    overrides: Vec<String>,
    space: Space,
    /// For each measurement the model at the middle of the priors, and the keys that hold for it alone.
    models: Vec<(ClosedForm, Vec<String>)>,
    curves: Vec<MeasuredCurve>,
    /// Each unknown as a variable of the models, with the size of its unit, where every one is: the case need
    /// not be read again then.
    variables: Option<Vec<(Variable, f64)>>,
}

/// Why a case cannot be calibrated by closed forms.
#[derive(Debug, thiserror::Error)]
pub enum NoClosedForm {
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The models do not apply; says why.
    #[error("{0}")]
    Model(String),
}

/// Difference of two ways to the same curve that is rounding.
const SAME: f64 = 1e-9;

impl ClosedResponse {
    /// The models for each measurement, at the middle of the priors.
    ///
    /// # Errors
    /// [`NoClosedForm`] where the case is wrong or has none.
    pub fn forms(
        case: &Path,
        overrides: &[String],
        space: &Space,
        (records, model): (&[Record], Option<&str>),
    ) -> Result<Vec<(ClosedForms, Vec<String>)>, NoClosedForm> {
        let middle =
            space.overrides(&space.values(&vec![0.0; space.dimension()])).map_err(NoClosedForm::Model)?;
        let of = |record: &Record| {
            let all = [overrides, &middle, &record.settings].concat();
            let (case, _) = load_for_forecast(case, &all)?;
            Ok((ClosedForms::of(&case, model).map_err(NoClosedForm::Model)?, record.settings.clone()))
        };
        records.iter().map(of).collect()
    }

    /// For each measurement the model that applies at most of its points.
    ///
    /// # Errors
    /// [`NoClosedForm::Model`] where none does.
    pub fn models(
        forms: Vec<(ClosedForms, Vec<String>)>,
        records: &[Record],
        curves: &[MeasuredCurve],
    ) -> Result<Vec<(ClosedForm, Vec<String>)>, NoClosedForm> {
        let of = |(number, (forms, settings)): (usize, (ClosedForms, Vec<String>))| {
            let own = || curves.iter().filter(|curve| curve.record == number);
            let at: Vec<f64> = own().flat_map(|curve| curve.at.iter().copied()).collect();
            let abscissa = own().find_map(|curve| curve.abscissa);
            let named = |why: String| {
                let whole = abscissa
                    .map_or(records[number].name.clone(), |along| place(&records[number], along, &at));
                NoClosedForm::Model(format!("{whole}: {why}"))
            };
            let along = abscissa.map_or(Along::Steady, Along::of);
            Ok((forms.chosen(along, &at).map_err(named)?, settings))
        };
        forms.into_iter().enumerate().map(of).collect()
    }

    /// The response of the models of all measurements.
    #[must_use]
    pub fn new(
        case: &Path,
        overrides: &[String],
        space: &Space,
        (models, curves): (Vec<(ClosedForm, Vec<String>)>, Vec<MeasuredCurve>),
    ) -> Self {
        let mut response = Self {
            case: case.to_path_buf(),
            overrides: overrides.to_vec(),
            space: space.clone(),
            models,
            curves,
            variables: None,
        };
        response.variables = response.short_cut();
        response
    }

    /// Name of the model.
    #[must_use]
    pub fn name(&self) -> String {
        self.models.first().map_or_else(String::new, |(model, _)| model.candidate.name().to_owned())
    }

    /// The unknowns as variables of the models, if that gives the same curves as reading the case again.
    fn short_cut(&self) -> Option<Vec<(Variable, f64)>> {
        if !self.space.links.is_empty() {
            return None;
        }
        let (first, _) = self.models.first()?;
        let variable = |unknown: &super::space::Unknown| {
            let found = find(&unknown.name, &first.input.bodies).filter(|v| v.belongs(&first.input))?;
            Some((found, size(&unknown.unit)?))
        };
        let variables: Vec<(Variable, f64)> =
            self.space.unknowns.iter().map(variable).collect::<Option<_>>()?;
        let quick = Self { variables: Some(variables.clone()), ..self.clone() };
        let is_same = |coordinate: f64| {
            let values = self.space.values(&vec![coordinate; self.space.dimension()]);
            match (self.at(&values), quick.at(&values)) {
                (Ok(slow), Ok(quick)) => slow
                    .values
                    .iter()
                    .zip(&quick.values)
                    .all(|(a, b)| (a - b).abs() <= SAME * (1.0 + a.abs())),
                (Err(_), Err(_)) => true,
                _ => false,
            }
        };
        [-1.0, 0.0, 0.7].into_iter().all(is_same).then_some(variables)
    }

    /// The model of a measurement with values of the unknowns.
    fn model(&self, record: usize, values: &[f64]) -> Result<ClosedForm, String> {
        let (base, settings) = self.models.get(record).ok_or("no such measurement")?;
        if let Some(variables) = &self.variables {
            let mut model = base.clone();
            for ((variable, size), value) in variables.iter().zip(values) {
                model.input.towing = variable.set(&model.input, value * size);
            }
            model.input.towing.check().map_err(|error| error.to_string())?;
            return Ok(model);
        }
        let all = [&self.overrides[..], &self.space.overrides(values)?, settings].concat();
        let (case, _) = load_for_forecast(&self.case, &all).map_err(|error| first_problem(&error))?;
        base.for_case(&case)
    }

    /// The values of all curves [SI], curve by curve.
    ///
    /// # Errors
    /// Why the model has none.
    pub fn curves_at(&self, values: &[f64]) -> Result<Vec<Vec<f64>>, String> {
        let mut model: Option<(usize, ClosedForm)> = None;
        let mut found = Vec::new();
        for curve in &self.curves {
            let known = model.take().filter(|(record, _)| *record == curve.record);
            let (record, current) = match known {
                Some(known) => known,
                None => (curve.record, self.model(curve.record, values)?),
            };
            let along = curve.abscissa.map_or(Along::Steady, Along::of);
            found.push(current.values(curve.quantity, along, &curve.at)?);
            model = Some((record, current));
        }
        Ok(found)
    }
}

/// What is wrong with a case, in one line.
pub(super) fn first_problem(error: &CaseError) -> String {
    error.problems.first().map_or_else(|| error.to_string(), |problem| problem.message.clone())
}

/// How many SI units a unit is.
fn size(unit: &str) -> Option<f64> {
    if unit.is_empty() {
        return Some(1.0);
    }
    coulter::case::quantity::parse_any(&format!("1 {unit}")).ok().map(|(size, _)| size)
}

impl Response for ClosedResponse {
    fn at(&self, values: &[f64]) -> Result<Seen, String> {
        let found = self.curves_at(values)?;
        let mut seen = Seen::default();
        for (curve, values) in self.curves.iter().zip(found) {
            for (point, value) in values.iter().enumerate() {
                let value = curve.seen(point, *value).ok_or("the model has a value that is not positive")?;
                seen.values.push(value);
            }
        }
        Ok(seen)
    }
}
