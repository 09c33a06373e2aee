//! What can be compared: results folders of runs, forecasts, case files (by their closed form), and measured
//! curves.

use super::steady::SteadyMean;
use crate::files;
use crate::measured::{ColumnChoice, Quantity, Record, read};
use crate::sources::{Along, ClosedForm, ClosedForms, LeftOut, read_run, rising, says_nothing};
use coulter::case::{self, CaseError};
use coulter::formats;
use coulter::history::reference::Reference;
use coulter::output::{FileError, Inside, Summary};
use serde_json::Value;
use std::path::Path;

/// Kind of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemKind {
    /// A run of the solver.
    Run,
    /// A closed form of a case.
    ClosedForm,
    /// The document of a forecast.
    Forecast,
    /// A measurement.
    Measured,
}

impl ItemKind {
    /// Name of the kind.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Run => "run",
            Self::ClosedForm => "closed form",
            Self::Forecast => "forecast",
            Self::Measured => "measured",
        }
    }
}

/// One of the things compared.
#[derive(Clone, Debug)]
pub struct Item {
    /// Name of the item: the path as typed, and the model of a closed form.
    pub name: String,
    /// Kind of the item.
    pub kind: ItemKind,
    /// Curves of the item; empty of a forecast and a closed form.
    pub record: Record,
    /// Steady means that the item states itself.
    pub means: Vec<(Quantity, SteadyMean)>,
    /// The closed forms, of a case file.
    pub forms: Option<ClosedForms>,
    /// The closed form that is compared; `None` until [`Item::settle`].
    pub model: Option<ClosedForm>,
    /// Reference quantities that make results of the item dimensionless, of a run and of a case.
    pub reference: Option<Reference>,
}

/// Why an argument cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum Unreadable {
    /// A case or a CSV file is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// Says what is wrong, and what to do instead.
    #[error("{0}")]
    Other(String),
}

/// Largest document of a forecast that is read [bytes].
const MAX_BYTES: u64 = 64 << 20;
/// Name of the document in the folder of a forecast.
const FORECAST: &str = "forecast.json";

/// Reads what an argument names; `body` is the body of a run with several, and `choices` say what the columns
/// of measurements are.
///
/// # Errors
/// [`Unreadable`] says what is wrong with it.
pub fn read_item(path: &Path, body: Option<&str>, choices: &[ColumnChoice]) -> Result<Item, Unreadable> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    if path.is_dir() {
        let document = Inside::of(path, FORECAST);
        return if document.exists() {
            forecast(&document.path(), files::read_inside(&document, MAX_BYTES))
        } else {
            run(path, body)
        };
    }
    match extension.as_str() {
        "toml" => closed_form(path),
        "json" => forecast(path, files::read(path, MAX_BYTES)),
        "csv" | "txt" | "tsv" | "dat" => measured(path, choices),
        _ if !path.exists() => Err(Unreadable::Other(format!(
            "{}: there is no such file or folder; name results of a run, a forecast, a case file or a measured CSV file",
            path.display()
        ))),
        _ => Err(Unreadable::Other(format!(
            "{}: neither a results folder nor a .toml, .json or .csv file; rename it if it is one of them",
            path.display()
        ))),
    }
}

fn item(path: &Path, kind: ItemKind, record: Record) -> Item {
    Item {
        name: path.display().to_string(),
        kind,
        record,
        means: Vec::new(),
        forms: None,
        model: None,
        reference: None,
    }
}

fn measured(path: &Path, choices: &[ColumnChoice]) -> Result<Item, Unreadable> {
    Ok(item(path, ItemKind::Measured, read(path, choices)?))
}

fn run(path: &Path, body: Option<&str>) -> Result<Item, Unreadable> {
    let source = read_run(path, body).map_err(Unreadable::Other)?;
    let quantities = source.record.channels.iter().map(|channel| channel.quantity);
    let mean = |quantity: Quantity| {
        let (mean, half) = source.steady_mean(quantity)?;
        Some((quantity, SteadyMean { mean, half }))
    };
    let means = quantities.filter_map(mean).collect();
    let is_it = |reference: &&Reference| match body {
        Some(name) => reference.name == name,
        None => reference.has_surface(),
    };
    let reference = source.run.bodies.iter().find(is_it).cloned();
    let mut record = source.record.clone();
    record.remarks.extend(grade(path));
    Ok(Item { means, reference, ..item(path, ItemKind::Run, record) })
}

/// What is to be said of the grade of a run that is not good.
fn grade(folder: &Path) -> Option<String> {
    let trust = Summary::read(folder).ok()?.trust;
    let worst = trust.concerns().first().map(|check| check.line())?;
    Some(format!("the run is graded {}: {worst}", trust.verdict.name()))
}

fn closed_form(path: &Path) -> Result<Item, Unreadable> {
    let (case, _) = case::load_for_forecast(path, &[])?;
    let forms = ClosedForms::of(&case, None)
        .map_err(|why| Unreadable::Other(format!("{}: {why}", path.display())))?;
    let reference = Reference::all(&case).into_iter().find(Reference::has_surface);
    Ok(Item { forms: Some(forms), reference, ..item(path, ItemKind::ClosedForm, Record::default()) })
}

fn forecast(path: &Path, content: Result<Vec<u8>, FileError>) -> Result<Item, Unreadable> {
    let refuse = |why: &str| {
        Unreadable::Other(format!(
            "{}: {why}; name the forecast.json that `coulter forecast -o DIR` wrote",
            path.display()
        ))
    };
    let bytes = content.map_err(|error| refuse(&error.to_string()))?;
    let document: Value =
        serde_json::from_slice(&bytes).map_err(|error| refuse(&format!("not JSON: {error}")))?;
    formats::check(document["format"].as_u64(), formats::DOCUMENT, "forecasts", "make the forecast again")
        .map_err(|why| Unreadable::Other(format!("{}: {why}", path.display())))?;
    let recommended = document["recommended"].as_str().ok_or_else(|| refuse("it recommends no model"))?;
    let models = document["models"].as_array().ok_or_else(|| refuse("it has no models"))?;
    let model = models
        .iter()
        .find(|model| model["name"] == recommended)
        .ok_or_else(|| refuse("its model is missing"))?;
    let keys = [
        (Quantity::Drag, "drag_N"),
        (Quantity::Vertical, "vertical_N"),
        (Quantity::Sinkage, "sinkage_m"),
        (Quantity::Lateral, "lateral_N"),
    ];
    let mean = |(quantity, key): (Quantity, &str)| {
        let range = &model["interval"][key];
        let half = range["high"].as_f64().zip(range["low"].as_f64()).map(|(high, low)| 0.5 * (high - low));
        model[key].as_f64().map(|mean| (quantity, SteadyMean { mean, half }))
    };
    let means: Vec<_> = keys.into_iter().filter_map(mean).collect();
    let mut found = item(path, ItemKind::Forecast, Record::default());
    found.name = format!("{} ({recommended})", path.display());
    Ok(Item { means, ..found })
}

/// Points of a curve, and those of its reference that it does not have.
type Told = (Vec<[f64; 2]>, Vec<LeftOut>);

impl Item {
    /// Chooses the closed form of a case file: the one that applies at most of the abscissae of the
    /// reference.
    ///
    /// # Errors
    /// Why none does.
    pub fn settle(&mut self, abscissa: Quantity, at: &[f64]) -> Result<(), String> {
        let Some(forms) = self.forms.take() else { return Ok(()) };
        let along = Along::of(abscissa);
        let speaking: Vec<f64> =
            at.iter().copied().filter(|x| abscissa != Quantity::Sinkage || *x > 0.0).collect();
        let model = forms.chosen(along, &speaking).map_err(|why| format!("{}: {why}", self.name))?;
        if along == Along::Steady {
            let steady = [Quantity::Drag, Quantity::Vertical, Quantity::Sinkage, Quantity::Lateral];
            let mean = |quantity: Quantity| {
                let value = model.values(quantity, along, &[]).ok()?.first().copied()?;
                Some((quantity, SteadyMean { mean: value, half: None }))
            };
            self.means = steady.into_iter().filter_map(mean).collect();
        }
        self.name = format!("{} ({})", self.name, model.candidate.name());
        self.model = Some(model);
        Ok(())
    }

    /// Curve of a quantity along an abscissa, rising; of a model at the points of the reference where it
    /// applies, with the others.
    #[must_use]
    pub fn curve(&self, quantity: Quantity, abscissa: Quantity, reference: (&Record, &[[f64; 2]])) -> Told {
        if let Some(model) = &self.model {
            return modelled(model, quantity, abscissa, reference);
        }
        let (Some(x), Some(y)) = (self.record.values(abscissa), self.record.values(quantity)) else {
            return Told::default();
        };
        let points = rising(x, y);
        (if points.len() >= 2 { points } else { Vec::new() }, Vec::new())
    }

    /// The steady mean that the item states itself.
    #[must_use]
    pub fn stated(&self, quantity: Quantity) -> Option<SteadyMean> {
        self.means.iter().find(|(known, _)| *known == quantity).map(|(_, mean)| *mean)
    }
}

/// The curve of a model at the points of a reference.
fn modelled(
    model: &ClosedForm,
    quantity: Quantity,
    abscissa: Quantity,
    (record, points): (&Record, &[[f64; 2]]),
) -> Told {
    let along = Along::of(abscissa);
    if along == Along::Steady {
        return Told::default();
    }
    let at: Vec<f64> = points.iter().map(|point| point[0]).collect();
    let is_pressed = model.input.towing.pressed;
    let mut curve = Vec::new();
    let mut silent = Vec::new();
    let x = record.values(abscissa).unwrap_or_default();
    for ([at, value], refused) in points.iter().zip(model.refusals(along, &at)) {
        let nothing = says_nothing(is_pressed, (abscissa, *at), (quantity, *value)).map(str::to_owned);
        match nothing.or(refused).map_or_else(|| model.values(quantity, along, &[*at]), Err) {
            Ok(found) => curve.extend(found.first().map(|value| [*at, *value])),
            Err(why) => {
                let row = x.iter().position(|known| known == at).unwrap_or(usize::MAX);
                silent.push((row, *at, why));
            }
        }
    }
    (curve, LeftOut::of(record, (abscissa, quantity), &silent))
}
