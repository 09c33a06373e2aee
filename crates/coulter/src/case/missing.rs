//! Keys that must be given, and what is said where they are not.

use super::keys::{self, Kind};
use super::numbers::in_order;
use super::problem::Problems;
use super::typed::Section;

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
    let cure = format!("add  {key} = {}  to [{}]", example(&path), section.path);
    problems.add(&path, format!("`{path}` is missing"), cure);
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

/// A value for the key at a path as one would write it.
fn example(path: &str) -> String {
    match keys::at(path).map(|key| key.kind) {
        Some(Kind::Quantity(measure)) => format!("\"{}\"", measure.example),
        Some(Kind::Choice(words)) => format!("\"{}\"", words.first().unwrap_or(&"")),
        Some(Kind::Range(measure)) => format!("[\"-{0}\", \"{0}\"]", measure.example),
        Some(Kind::Vector(measure)) => format!("[\"{0}\", \"{0}\", \"{0}\"]", measure.example),
        Some(Kind::Modulus(offset)) => format!("\"102 kN/m^(n+{offset})\""),
        Some(Kind::NamePair) => "[\"frame\", \"disc\"]".into(),
        Some(Kind::Ratios) => "[3, 3, 1]".into(),
        Some(Kind::Interval) => "[0.3, 0.5]".into(),
        Some(Kind::Count) => "24".into(),
        Some(Kind::Flag) => "true".into(),
        _ => "0.3".into(),
    }
}
