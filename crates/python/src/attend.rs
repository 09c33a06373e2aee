//! Work that goes on beside the interpreter: on a thread of its own, while the calling thread serves what it
//! asks and watches for Ctrl-C. The only file of the crate that starts threads, with `pool` and `session`.

use crate::failure::internal;
use coulter::interrupts::Interrupts;
use pyo3::{PyErr, PyResult, Python};
use std::sync::Mutex;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::time::Duration;

/// How long the calling thread waits before it looks for signals again.
const PATIENCE: Duration = Duration::from_millis(50);

/// Number of the signal of Ctrl-C, by which work is stopped whatever the reason.
const INTERRUPT: usize = 2;

/// Asks a run or a study to stop.
pub(crate) fn ask_to_stop(interrupts: &Interrupts) {
    interrupts.stop.store(INTERRUPT, Ordering::Relaxed);
}

/// A question of the work to the calling thread, with the way of the answer: whether to go on.
pub(crate) type Question<Q> = (Q, SyncSender<bool>);

/// Lets `work` run on a thread of its own without the interpreter's lock, and serves its questions in this
/// one, in their order.
///
/// # Errors
/// The first exception that `serve` or a signal has raised: `stop` has been called then, and the work has
/// finished.
pub(crate) fn attend<Q: Send, T: Send>(
    py: Python<'_>,
    work: impl FnOnce(SyncSender<Question<Q>>) -> T + Send,
    mut serve: impl FnMut(Q) -> PyResult<bool>,
    stop: impl Fn(),
) -> PyResult<T> {
    let (sender, receiver) = sync_channel(0);
    let receiver = Mutex::new(receiver);
    // The receiver goes into the scope: whatever ends it, a worker that asks is not left waiting.
    std::thread::scope(move |scope| {
        let worker = scope.spawn(move || work(sender));
        let mut raised: Option<PyErr> = None;
        while let Some(question) = next(py, &receiver) {
            let outcome = match question {
                Some((asked, answer)) if raised.is_none() => {
                    serve(asked).map(|goes_on| (goes_on, Some(answer)))
                }
                Some((_, answer)) => Ok((false, Some(answer))),
                None => Ok((true, None)),
            };
            let outcome = outcome.and_then(|outcome| py.check_signals().map(|()| outcome));
            match outcome {
                // A worker that no longer waits has ended for another reason.
                Ok((goes_on, Some(answer))) => drop(answer.send(goes_on)),
                Ok((_, None)) => {}
                Err(error) => {
                    stop();
                    raised.get_or_insert(error);
                }
            }
        }
        let result = py.detach(|| worker.join()).map_err(|_| internal())?;
        raised.map_or(Ok(result), Err)
    })
}

/// The next question, or none after a while; `None` when the work is over.
fn next<Q: Send>(py: Python<'_>, receiver: &Mutex<Receiver<Question<Q>>>) -> Option<Option<Question<Q>>> {
    py.detach(|| {
        let receiver = receiver.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        match receiver.recv_timeout(PATIENCE) {
            Ok(question) => Some(Some(question)),
            Err(RecvTimeoutError::Timeout) => Some(None),
            Err(RecvTimeoutError::Disconnected) => None,
        }
    })
}
