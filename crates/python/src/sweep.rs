//! `coulter.sweep`.

use crate::attend::{Question, ask_to_stop, attend};
use crate::failure::raised;
use crate::source::{count, device, request};
use coulter::interrupts::Interrupts;
use coulter_cli::{SweepRequest, sweep_study};
use pyo3::prelude::*;
use serde::Deserialize;
use serde_json::json;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::mpsc::{SyncSender, sync_channel};
use studies::sweep::evaluate::Unended;
use studies::sweep::line::CaseLine;
use studies::sweep::outcome::Outcome;
use studies::sweep::pool::Watcher;

/// The call of `sweep`, as the Python part writes it.
#[derive(Debug, Deserialize)]
struct SweepCall {
    study: PathBuf,
    quick: bool,
    output: Option<PathBuf>,
    workers: Option<i64>,
    threads: Option<i64>,
    device: String,
}

/// A case that has ended: number of its point, its id, its state, the reason.
type Told = (usize, String, String, String);

/// Tells the calling thread of every case that has ended.
struct Telling<'a> {
    is_followed: bool,
    sender: Mutex<SyncSender<Question<Told>>>,
    interrupts: &'a Interrupts,
}

impl Watcher for Telling<'_> {
    fn ended(&self, line: &CaseLine, outcome: &Result<Outcome, Unended>) {
        if !self.is_followed {
            return;
        }
        let (state, reason) = match outcome {
            Ok(outcome) => (outcome.ending.word().to_owned(), outcome.reason.clone()),
            Err(Unended::Busy(_) | Unended::Stopped(_)) => return,
            Err(why) => ("failed".to_owned(), why.to_string()),
        };
        let (answer, answered) = sync_channel(1);
        let told = (line.point, line.id.to_string(), state, reason);
        let sender = self.sender.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let goes_on = sender.send((told, answer)).is_ok() && answered.recv().unwrap_or(false);
        if !goes_on {
            ask_to_stop(self.interrupts);
        }
    }
}

/// Runs what is left of a study and collects it; `on_case(point, id, state, reason)` is called for every case
/// that ends. Returns its folder, and how many cases have become what, as JSON.
///
/// # Errors
/// `Failure`; the exception of the callback; `KeyboardInterrupt`. What has ended is kept.
#[pyfunction]
pub(crate) fn sweep(
    py: Python<'_>,
    call: &str,
    on_case: Option<Bound<'_, PyAny>>,
) -> PyResult<(PathBuf, String)> {
    let SweepCall { study, quick, output, workers, threads, device: strained_by } = request(call)?;
    let (workers, threads) = (count("workers", workers)?, count("threads", threads)?);
    let device = device(&strained_by)?;
    let wanted = SweepRequest { study, quick, output, workers, threads, device };
    let interrupts = Interrupts::default();
    let is_followed = on_case.is_some();
    let swept = attend(
        py,
        |sender| {
            let telling = Telling { is_followed, sender: Mutex::new(sender), interrupts: &interrupts };
            sweep_study(&wanted, &interrupts, &telling)
        },
        |(point, id, state, reason): Told| match &on_case {
            Some(callback) => callback.call1((point, id, state, reason)).map(|_| true),
            None => Ok(true),
        },
        || ask_to_stop(&interrupts),
    )?;
    let swept = swept.map_err(|failure| raised(&failure))?;
    let counts = json!({
        "cases": swept.counts.cases, "done": swept.counts.done, "broken": swept.counts.broken,
        "refused": swept.counts.refused, "failed": swept.counts.failed, "missing": swept.counts.missing,
    });
    Ok((swept.folder, counts.to_string()))
}
