//! How long to run.

use crate::numbers::in_range;
use input::problem::Problems;

/// Reports a duration [s] that is none.
pub(super) fn duration(duration: f64, problems: &mut Problems) {
    in_range("run.duration", duration, problems);
}
