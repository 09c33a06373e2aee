//! How long to run, and how often to write.

use crate::case::numbers::{in_range, in_range_or_infinite};
use crate::case::problem::Problems;
use crate::case::resolved::Output;

/// Largest number of lines of a history.
const MAX_LINES: f64 = 1e7;

/// Reports a duration [s] that is none.
pub(super) fn duration(duration: f64, problems: &mut Problems) {
    in_range("run.duration", duration, problems);
}

/// Reports what is wrong with the output of a run of this duration [s].
pub(in crate::case) fn output(output: &Output, duration: f64, problems: &mut Problems) {
    in_range("output.filter_cutoff", output.filter_cutoff, problems);
    in_range("output.steady_fraction", output.steady_fraction, problems);
    in_range_or_infinite("output.checkpoint_interval", output.checkpoint_interval, problems);
    let between = [("history_interval", output.history_interval), ("field_interval", output.field_interval)];
    for (key, interval) in between {
        let path = format!("output.{key}");
        let count = duration / interval;
        if in_range_or_infinite(&path, interval, problems) && count > MAX_LINES {
            let message = format!("{path} means {count:.1e} outputs in {duration} s");
            problems.add(path, message, "make the interval longer");
        }
    }
}
