//! `coulter.run`.

use crate::attend::{ask_to_stop, attend};
use crate::failure::{raised, refused};
use crate::follow::{Asking, told};
use crate::source::{Source, SourceText, count, device, request};
use coulter::confidence::Wanted;
use coulter::confidence::variations::ErrorSource;
use coulter::interrupts::Interrupts;
use coulter::run::{Accuracy, Follower, NoFollower, Start};
use coulter_cli::{Failure, PreparedRun, RunRequest, asked, budget, error_source, graded};
use pyo3::prelude::*;
use serde::Deserialize;
use std::path::PathBuf;

/// The call of `run`, as the Python part writes it.
#[derive(Debug, Deserialize)]
struct RunCall {
    source: Source,
    set: Vec<String>,
    output: Option<PathBuf>,
    start: String,
    threads: Option<i64>,
    device: String,
    meshes: Option<i64>,
    confidence: bool,
    accuracy: Option<String>,
    budget: Option<String>,
    without: Vec<String>,
    quiet: bool,
}

/// What to do with a folder that holds a run.
pub(crate) fn start(word: &str) -> PyResult<Start> {
    match word {
        "new" => Ok(Start::Anew),
        "replace" => Ok(Start::Replace),
        "resume" => Ok(Start::Resume),
        "auto-resume" => Ok(Start::AutoResume),
        _ => Err(refused(format!(
            "start = \"{word}\": it must be \"new\", \"replace\", \"resume\" or \"auto-resume\""
        ))),
    }
}

impl RunCall {
    fn request(&self) -> PyResult<RunRequest> {
        let SourceText { text, name } = self.source.text()?;
        let refused = |why: String| raised(&Failure::Request(why));
        let budget = self.budget.as_deref().map(budget).transpose().map_err(refused)?;
        let accuracy = self.accuracy.as_deref().map(Wanted::parse).transpose().map_err(refused)?;
        let without: Result<Vec<ErrorSource>, String> =
            self.without.iter().map(|word| error_source(word)).collect();
        let without = without.map_err(refused)?;
        let variations = asked(count("meshes", self.meshes)?, self.confidence, &without)
            .map(|asked| (asked, self.confidence.then(|| budget.unwrap_or_default())));
        Ok(RunRequest {
            text,
            source_name: name,
            overrides: self.set.clone(),
            output: self.output.clone(),
            start: start(&self.start)?,
            threads: count("threads", self.threads)?,
            variations,
            accuracy: accuracy.map(|wanted| Accuracy { wanted, budget: budget.unwrap_or_default(), without }),
            quiet: self.quiet,
            device: device(&self.device)?,
        })
    }
}

/// Runs a case to its end, or until `on_sample(time, bodies)` returns `False` or raises, or Ctrl-C.
/// `warn(text)` gets the warnings before it begins. Returns the results folder, how it ended (`finished`,
/// `stopped` or `broken`), and of a broken one why.
///
/// # Errors
/// `Failure`; the exception of a callback; `KeyboardInterrupt`. A run that has begun leaves a checkpoint.
#[pyfunction]
pub(crate) fn run(
    py: Python<'_>,
    call: &str,
    on_sample: Option<Bound<'_, PyAny>>,
    warn: Bound<'_, PyAny>,
) -> PyResult<(PathBuf, &'static str, String)> {
    let wanted: RunRequest = request::<RunCall>(call)?.request()?;
    let prepared = py.detach(|| wanted.prepare()).map_err(|failure| raised(&failure))?;
    for warning in &prepared.warnings {
        warn.call1((warning,))?;
    }
    let interrupts = Interrupts::default();
    let end = attended(py, &prepared, on_sample, &interrupts)?;
    match end {
        Ok(()) => Ok((prepared.folder, "finished", String::new())),
        Err(Failure::Stopped { signal: 0, .. }) => Ok((prepared.folder, "stopped", String::new())),
        Err(Failure::Physics(why)) => Ok((prepared.folder, "broken", why)),
        Err(failure) => Err(raised(&failure)),
    }
}

fn attended(
    py: Python<'_>,
    prepared: &PreparedRun,
    on_sample: Option<Bound<'_, PyAny>>,
    interrupts: &Interrupts,
) -> PyResult<Result<(), Failure>> {
    let is_followed = on_sample.is_some();
    attend(
        py,
        |sender| {
            let mut asking = Asking::of(&prepared.case, sender);
            let follower: &mut dyn Follower = if is_followed { &mut asking } else { &mut NoFollower };
            prepared.run(interrupts, follower).and_then(|summary| graded(&summary))
        },
        |sample| on_sample.as_ref().map_or(Ok(true), |callback| told(callback, &sample)),
        || ask_to_stop(interrupts),
    )
}
