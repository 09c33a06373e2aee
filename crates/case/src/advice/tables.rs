//! What is to be said of files that a case names: how they were read, and whether tables of motions are as
//! long as the run.

use crate::resolved::Case;
use input::quantity::plain;

/// Notes on files.
pub(super) fn files(case: &Case, notes: &mut Vec<String>) {
    notes.extend(case.remarks.iter().map(|remark| format!("{remark}.")));
    for timed in case.timed_motions() {
        if !case.tables.iter().any(|table| table.keys.join(".") == timed.path) {
            continue;
        }
        let [first, last] = timed.span;
        if first > 0.0 {
            notes.push(format!(
                "{}: its table begins at {} s; until then the body is at rest.",
                timed.path,
                plain(first)
            ));
        }
        // Times of a table are rounded as they are written.
        if last < timed.remaining * (1.0 - 1e-6) {
            let then = match timed.last_speed {
                0.0 => "the body is at rest".to_owned(),
                speed => format!("it keeps its last speed, {}", plain(speed)),
            };
            notes.push(format!(
                "{}: its table ends at {} s, {} s before the run; after that {then}.",
                timed.path,
                plain(last),
                plain(timed.remaining - last)
            ));
        }
    }
}
