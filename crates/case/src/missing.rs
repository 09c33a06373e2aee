//! Keys that must be given, and what is said where they are not.

use super::keys;
use super::numbers::in_order;
use input::problem::Problems;
use input::typed::Section;

/// The number of a required key.
pub(super) fn required(section: &Section, key: &str, problems: &mut Problems) -> Option<f64> {
    if !section.has(key) {
        missing(section, key, problems);
    }
    section.number(key)
}

/// Reports a required key that is missing.
pub(super) fn missing(section: &Section, key: &str, problems: &mut Problems) {
    let path = section.at(key);
    match keys::at(&path) {
        Some(key) => key.missing(section, problems),
        None => problems.add(&path, format!("`{path}` is missing"), format!("add it to [{}]", section.path)),
    }
}

/// A low and a high end; reported if they are swapped, or missing without a default.
pub(super) fn range(
    section: &Section,
    key: &str,
    default: Option<[f64; 2]>,
    problems: &mut Problems,
) -> Option<[f64; 2]> {
    if !section.has(key) {
        if default.is_none() {
            missing(section, key, problems);
        }
        return default;
    }
    let given = section.list(key)?;
    let ends = [*given.first()?, *given.last()?];
    in_order(&section.at(key), ends, problems).then_some(ends)
}
