//! What can be compared: results folders of runs, forecasts, case files (by their closed form), and measured curves.

use super::steady::SteadyMean;
use crate::files::{self, FileError};
use crate::measured::{Quantity, Record, read};
use crate::sources::{Along, ClosedForm, read_run, rising};
use coulter::case::{self, CaseError};
use coulter::formats;
use coulter::output::Inside;
use serde_json::Value;
use std::path::Path;

/// What an item is.
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
    /// Its name.
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
    /// Its name: the path as typed, and the model of a closed form.
    pub name: String,
    /// What it is.
    pub kind: ItemKind,
    /// Its curves; empty of a forecast and a closed form.
    pub record: Record,
    /// Steady means that it states itself.
    pub means: Vec<(Quantity, SteadyMean)>,
    /// The model, of a case file.
    pub model: Option<ClosedForm>,
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

/// Reads what an argument names; `body` is the body of a run with several.
///
/// # Errors
/// [`Unreadable`] says what is wrong with it.
pub fn read_item(path: &Path, body: Option<&str>) -> Result<Item, Unreadable> {
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
        "csv" | "txt" => measured(path),
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
    Item { name: path.display().to_string(), kind, record, means: Vec::new(), model: None }
}

fn measured(path: &Path) -> Result<Item, Unreadable> {
    Ok(item(path, ItemKind::Measured, read(path)?))
}

fn run(path: &Path, body: Option<&str>) -> Result<Item, Unreadable> {
    let source = read_run(path, body).map_err(Unreadable::Other)?;
    let quantities = source.record.channels.iter().map(|channel| channel.quantity);
    let mean = |quantity: Quantity| {
        let (mean, half) = source.steady_mean(quantity)?;
        Some((quantity, SteadyMean { mean, half }))
    };
    let means = quantities.filter_map(mean).collect();
    Ok(Item { means, ..item(path, ItemKind::Run, source.record.clone()) })
}

fn closed_form(path: &Path) -> Result<Item, Unreadable> {
    let (case, _) = case::load_for_forecast(path, &[])?;
    let model =
        ClosedForm::of(&case, None).map_err(|why| Unreadable::Other(format!("{}: {why}", path.display())))?;
    let steady = [Quantity::Drag, Quantity::Vertical, Quantity::Sinkage, Quantity::Lateral];
    let mean = |quantity: Quantity| {
        let value = model.values(quantity, Along::Steady, &[]).ok()?.first().copied()?;
        Some((quantity, SteadyMean { mean: value, half: None }))
    };
    let means = steady.into_iter().filter_map(mean).collect();
    let mut found = item(path, ItemKind::ClosedForm, Record::default());
    found.name = format!("{} ({})", path.display(), model.candidate.name());
    Ok(Item { means, model: Some(model), ..found })
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

impl Item {
    /// Its curve of a quantity along an abscissa, rising; of a model at the abscissae of another curve. `None` where it has none.
    #[must_use]
    pub fn curve(&self, quantity: Quantity, abscissa: Quantity, at: &[f64]) -> Option<Vec<[f64; 2]>> {
        if let Some(model) = &self.model {
            let along = model.along(abscissa);
            if along == Along::Steady {
                return None;
            }
            // Where the model has no answer, such as at a sinkage of 0, its curve has a gap.
            let value = |x: &f64| Some([*x, model.values(quantity, along, &[*x]).ok()?.first().copied()?]);
            let points: Vec<[f64; 2]> = at.iter().filter_map(value).collect();
            return (!points.is_empty()).then_some(points);
        }
        let (x, y) = (self.record.values(abscissa)?, self.record.values(quantity)?);
        let points = rising(x, y);
        (points.len() >= 2).then_some(points)
    }

    /// The steady mean that it states itself.
    #[must_use]
    pub fn stated(&self, quantity: Quantity) -> Option<SteadyMean> {
        self.means.iter().find(|(known, _)| *known == quantity).map(|(_, mean)| *mean)
    }
}
