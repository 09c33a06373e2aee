//! Samples of a run for a callback.

use crate::attend::Question;
use coulter::case::Case;
use coulter::history::History;
use coulter::history::columns::FORCES;
use coulter::history::reference::Reference;
use coulter::run::Follower;
use coulter::simulation::Next;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString};
use std::sync::mpsc::{SyncSender, sync_channel};

/// A sample: its time [s], and of every body its name and the numbers of its line in `forces.csv`.
#[derive(Debug)]
pub(crate) struct SampleValues {
    time: f64,
    bodies: Vec<(String, Vec<f64>)>,
}

/// The columns of a sample: name, unit and meaning of each.
#[pyfunction]
pub(crate) fn sample_columns() -> Vec<(&'static str, &'static str, &'static str)> {
    FORCES.iter().map(|column| (column.name, column.unit, column.meaning)).collect()
}

/// Asks the calling thread at every sample whether to go on.
pub(crate) struct Asking {
    pub(crate) sender: SyncSender<Question<SampleValues>>,
    pub(crate) references: Vec<Reference>,
}

impl Asking {
    pub(crate) fn of(case: &Case, sender: SyncSender<Question<SampleValues>>) -> Self {
        Self { sender, references: Reference::all(case) }
    }
}

impl Follower for Asking {
    fn sampled(&mut self, history: &History) -> Next {
        let (answer, answered) = sync_channel(1);
        let goes_on = self.sender.send((last(history, &self.references), answer)).is_ok()
            && answered.recv().unwrap_or(false);
        if goes_on { Next::Continue } else { Next::Stop("the caller".to_owned()) }
    }
}

/// The last sample of a history.
fn last(history: &History, references: &[Reference]) -> SampleValues {
    let bodies = history.names.iter().zip(&history.bodies).zip(references);
    let values = bodies.filter_map(|((name, samples), reference)| {
        let sample = samples.last()?;
        Some((name.clone(), FORCES.iter().map(|column| column.value(sample, reference)).collect()))
    });
    SampleValues {
        time: history.energy.last().map_or(f64::NAN, |sample| sample.time),
        bodies: values.collect(),
    }
}

/// Calls a function with a sample, as `(time, {name: numbers})`; whether the run is to go on, which it
/// returns.
pub(crate) fn told(callback: &Bound<'_, PyAny>, sample: &SampleValues) -> PyResult<bool> {
    let py = callback.py();
    let bodies = PyDict::new(py);
    for (name, values) in &sample.bodies {
        bodies.set_item(PyString::new(py, name), PyList::new(py, values)?)?;
    }
    callback.call1((sample.time, bodies))?.is_truthy()
}
