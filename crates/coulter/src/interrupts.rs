//! Requests from outside to a run: to stop, or to write a checkpoint.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Pending requests. Signal handlers set them, a run polls them between two steps.
#[derive(Clone, Debug, Default)]
pub struct Interrupts {
    /// Number of the signal that asks to stop; 0 for none.
    pub stop: Arc<AtomicUsize>,
    /// Whether a checkpoint is requested.
    pub checkpoint: Arc<AtomicBool>,
    /// Called at every sample, when the tables and fields of the folder are up to it; the run waits
    /// meanwhile.
    pub at_sample: Option<fn()>,
}

impl Interrupts {
    /// The signal that asks to stop, if one does. This request remains pending.
    #[must_use]
    pub fn stopped_by(&self) -> Option<i32> {
        let signal = self.stop.load(Ordering::Relaxed);
        (signal != 0).then(|| i32::try_from(signal).unwrap_or(i32::MAX))
    }

    /// Whether a checkpoint is requested.
    #[must_use]
    pub(crate) fn asks_for_checkpoint(&self) -> bool {
        self.checkpoint.load(Ordering::Relaxed)
    }

    /// Whether a checkpoint is requested; the request is settled then.
    #[must_use]
    pub fn take_checkpoint(&self) -> bool {
        self.checkpoint.swap(false, Ordering::Relaxed)
    }
}
