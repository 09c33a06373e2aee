//! Requests from outside to a run: to stop, or to write a checkpoint.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// A request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    /// To stop, by the signal of this number.
    Stop(i32),
    /// To write a checkpoint and continue.
    Checkpoint,
}

/// Pending requests. Signal handlers set them, a run polls them between two steps.
#[derive(Clone, Debug, Default)]
pub struct Interrupts {
    /// Number of the signal that asks to stop; 0 for none.
    pub stop: Arc<AtomicUsize>,
    /// Whether a checkpoint is requested.
    pub checkpoint: Arc<AtomicBool>,
}

impl Interrupts {
    /// Whether there is a request.
    #[must_use]
    pub fn is_pending(&self) -> bool {
        self.stopped_by().is_some() || self.checkpoint.load(Ordering::Relaxed)
    }

    /// The signal that asks to stop, if one does.
    #[must_use]
    pub fn stopped_by(&self) -> Option<i32> {
        let signal = self.stop.load(Ordering::Relaxed);
        (signal != 0).then(|| i32::try_from(signal).unwrap_or(i32::MAX))
    }

    /// The next request, if there is one. A request to stop remains pending.
    #[must_use]
    pub fn take(&self) -> Option<Request> {
        if let Some(signal) = self.stopped_by() {
            return Some(Request::Stop(signal));
        }
        self.checkpoint.swap(false, Ordering::Relaxed).then_some(Request::Checkpoint)
    }
}
