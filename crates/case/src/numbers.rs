//! Whether a number is in the range of its key.

use super::keys;
use input::problem::Problems;

/// Whether a number is finite and in the range of its key; reported if not.
pub(super) fn in_range(path: &str, number: f64, problems: &mut Problems) -> bool {
    check(path, number, number.is_finite(), problems)
}

/// As [`in_range`], for a number that may be infinite.
pub(super) fn in_range_or_infinite(path: &str, number: f64, problems: &mut Problems) -> bool {
    check(path, number, true, problems)
}

fn check(path: &str, number: f64, is_allowed: bool, problems: &mut Problems) -> bool {
    let key = keys::at(path);
    let range = key.and_then(|key| key.range);
    let is_right = is_allowed && range.map_or(!number.is_nan(), |range| range.contains(number));
    if is_right {
        return true;
    }
    match key {
        Some(key) => key.refuse(path, number, problems),
        None => {
            problems.add(path, format!("{path} = {number} is out of range"), "it must be a finite number")
        }
    }
    false
}

/// Whether the low end is below the high end; reported if not.
pub(super) fn in_order(path: &str, [low, high]: [f64; 2], problems: &mut Problems) -> bool {
    if low < high {
        return true;
    }
    let message = format!("{path} is empty: its low end is not below its high end");
    problems.add(path, message, "write the lower value first");
    false
}
