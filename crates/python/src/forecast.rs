//! `coulter.forecast`: the closed-form models at many points.
//!
//! A point is the case with some keys set, as `coulter forecast --set` would set them, so that its numbers
//! are those of the command.

use crate::attend::{Question, attend};
use crate::failure::{internal, refused, wrong_case};
use crate::pool;
use crate::source::{Source, SourceText, count, request};
use analytic::forecast::ModelForecast;
use coulter::case::{self, CaseError, cores};
use coulter::forecast::{Outlook, PREDICTED, outlook};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use serde::Deserialize;
use std::sync::atomic::{AtomicBool, Ordering};

/// The call of `forecast`, as the Python part writes it.
#[derive(Debug, Deserialize)]
struct ForecastCall {
    source: Source,
    set: Vec<String>,
    /// The keys that vary, with the unit in which their values are given; empty for bare numbers.
    varied: Vec<(String, String)>,
    /// Number of points.
    count: usize,
    which: Which,
    /// Threads, 0 for as many as a run has by default.
    threads: i64,
}

/// Which models are asked for.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Which {
    /// The model that is recommended at each point.
    Recommended,
    /// Every model.
    All,
    /// The model of this name.
    Named(String),
}

/// What a model says at a point.
struct Said {
    model: &'static str,
    numbers: [f64; PREDICTED.len()],
    /// Why there are no numbers.
    reason: String,
}

/// What there is at a point, or why nothing is.
type AtPoint = Result<Vec<Said>, Unsaid>;

/// Why nothing is said at a point.
enum Unsaid {
    Case(CaseError),
    Other(String),
}

impl Unsaid {
    fn reason(&self) -> String {
        match self {
            Self::Case(error) => error.to_string(),
            Self::Other(why) => why.clone(),
        }
    }
}

/// Most threads that share the points.
const MOST_THREADS: i64 = 1024;

const NOTHING: [f64; PREDICTED.len()] = [f64::NAN; PREDICTED.len()];

impl Said {
    /// What a model says where it applies.
    fn of(outlook: &Outlook, model: &ModelForecast) -> Self {
        if !model.applicable {
            return Self { model: model.name, numbers: NOTHING, reason: model.note.clone() };
        }
        let numbers = PREDICTED.map(|quantity| (quantity.of)(outlook, model).unwrap_or(f64::NAN));
        Self { model: model.name, numbers, reason: String::new() }
    }
}

impl Which {
    fn of(&self, outlook: &Outlook) -> AtPoint {
        let models = &outlook.forecast.models;
        match self {
            Self::All => Ok(models.iter().map(|model| Said::of(outlook, model)).collect()),
            Self::Recommended => Ok(vec![match outlook.best() {
                Some(model) => Said::of(outlook, model),
                None => Said { model: "", numbers: NOTHING, reason: outlook.forecast.recommendation.clone() },
            }]),
            Self::Named(name) => match models.iter().find(|model| model.name == name) {
                Some(model) => Ok(vec![Said::of(outlook, model)]),
                None => {
                    let names: Vec<&str> = models.iter().map(|model| model.name).collect();
                    let names = names.join(", ");
                    Err(Unsaid::Other(format!(
                        "there is no model \"{name}\" for this body; there are {names}"
                    )))
                }
            },
        }
    }
}

/// The points of a forecast.
struct Points<'a> {
    call: &'a ForecastCall,
    source: SourceText,
    /// The values of each key that varies, in its unit, at every point.
    columns: Vec<Vec<f64>>,
}

impl Points<'_> {
    fn at(&self, point: usize) -> AtPoint {
        let varied = self
            .call
            .varied
            .iter()
            .zip(&self.columns)
            .map(|((key, unit), column)| format!("{key}={} {unit}", column[point]).trim_end().to_owned());
        let set: Vec<String> = self.call.set.iter().cloned().chain(varied).collect();
        let (case, _) =
            case::parse_for_forecast(&self.source.text, &self.source.name, &set).map_err(Unsaid::Case)?;
        let outlook = outlook(&case)
            .map_err(|why| Unsaid::Other(format!("there is no forecast for this case: {why}")))?;
        self.call.which.of(&outlook)
    }
}

/// The closed-form models at many points. `columns` holds the values of each key that varies, as bytes of
/// 64-bit numbers. Returns the rows (models, or the recommended one), of each quantity its unit and its
/// numbers row by row as bytes, and for every row and point the model and the reason why it has no numbers.
///
/// # Errors
/// `Failure` where nothing can be said at any point, with the reason at the first; `KeyboardInterrupt`.
#[pyfunction]
pub(crate) fn forecast<'py>(
    py: Python<'py>,
    call: &str,
    columns: Vec<Vec<u8>>,
) -> PyResult<Bound<'py, PyDict>> {
    let call: ForecastCall = request(call)?;
    let columns: Vec<Vec<f64>> = columns.iter().map(|bytes| numbers(bytes)).collect();
    if columns.len() != call.varied.len() || columns.iter().any(|column| column.len() != call.count) {
        return Err(internal());
    }
    let points = Points { source: call.source.text()?, call: &call, columns };
    if call.threads > MOST_THREADS {
        return Err(refused(format!("threads = {}: it must be from 0 to {MOST_THREADS}", call.threads)));
    }
    let threads = cores::threads(count("threads", Some(call.threads))?.unwrap_or_default());
    let stop = AtomicBool::new(false);
    let said = attend(
        py,
        |_asks_nothing: std::sync::mpsc::SyncSender<Question<()>>| {
            pool::map(call.count, threads, &stop, |point| points.at(point))
        },
        |()| Ok(true),
        || stop.store(true, Ordering::Relaxed),
    )?;
    document(py, &call.which, &said.unwrap_or_default())
}

/// Numbers from their bytes.
fn numbers(bytes: &[u8]) -> Vec<f64> {
    bytes.chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap_or_default())).collect()
}

fn document<'py>(py: Python<'py>, which: &Which, said: &[AtPoint]) -> PyResult<Bound<'py, PyDict>> {
    if let (false, Some(Err(first))) = (said.iter().any(Result::is_ok), said.first()) {
        return Err(match first {
            Unsaid::Case(error) => wrong_case(error),
            Unsaid::Other(why) => refused(why),
        });
    }
    let rows = rows(which, said);
    let mut numbers: Vec<Vec<u8>> = vec![Vec::with_capacity(8 * rows.len() * said.len()); PREDICTED.len()];
    let (mut models, mut reasons) = (Vec::new(), Vec::new());
    for row in 0..rows.len() {
        for point in said {
            let found = point.as_ref().ok().and_then(|list| match which {
                Which::All => list.iter().find(|said| said.model == rows[row]),
                _ => list.first(),
            });
            let values = found.map_or(NOTHING, |said| said.numbers);
            for (bytes, value) in numbers.iter_mut().zip(values) {
                bytes.extend_from_slice(&value.to_le_bytes());
            }
            models.push(found.map_or("", |said| said.model));
            reasons.push(match (point, found) {
                (Err(unsaid), _) => unsaid.reason(),
                (_, Some(said)) => said.reason.clone(),
                (_, None) => "the model is not one for this body".to_owned(),
            });
        }
    }
    let quantities = PyDict::new(py);
    for (quantity, bytes) in PREDICTED.iter().zip(&numbers) {
        quantities.set_item(quantity.name, (quantity.unit, PyBytes::new(py, bytes)))?;
    }
    let document = PyDict::new(py);
    document.set_item("rows", &rows)?;
    document.set_item("quantities", quantities)?;
    document.set_item("models", models)?;
    document.set_item("reasons", reasons)?;
    Ok(document)
}

/// The rows: every model that there is at some point, in the order in which they come, or the one that is
/// asked for.
fn rows(which: &Which, said: &[AtPoint]) -> Vec<String> {
    let mut rows = match which {
        Which::All => Vec::new(),
        Which::Recommended => vec!["recommended".to_owned()],
        Which::Named(name) => vec![name.clone()],
    };
    if let Which::All = which {
        for said in said.iter().flatten().flatten() {
            if rows.iter().all(|row| row != said.model) {
                rows.push(said.model.to_owned());
            }
        }
    }
    rows
}
