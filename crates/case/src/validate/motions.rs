//! Whether prescribed displacements come into the run.

use crate::resolved::Case;
use input::problem::Problems;
use input::quantity::plain;

/// Reports displacements over time that begin after the end of the run, or before its beginning.
pub(super) fn times(case: &Case, problems: &mut Problems) {
    for timed in case.timed_motions() {
        let [first, last] = timed.span;
        let is_table = case.tables.iter().any(|table| table.keys.join(".") == timed.path);
        let cure = if is_table {
            "write from = \"first line\" beside `table`, so that its times count from there; or change its times, or `start`"
        } else {
            "change `start`, or run.duration"
        };
        let lasts = format!("{} to {} s", plain(first), plain(last));
        if first >= timed.remaining {
            let message = format!(
                "the motion never begins: its times are {lasts}, and the run ends {} s after they count",
                plain(timed.remaining)
            );
            problems.add(timed.path, message, cure);
        } else if first < 0.0 {
            let message = format!("the motion begins before the run does: its times are {lasts}");
            problems.add(timed.path, message, cure);
        }
    }
}
