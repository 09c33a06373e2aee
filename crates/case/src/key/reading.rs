//! What every section needs for its reading: keys that are missing, ranges, and parts that are checked.

use input::key::Key;
use input::problem::Problems;
use input::typed::Section;

/// What each of these sections says, or `None` if any of it is wrong; all of them are read.
pub(crate) fn all<T>(sections: &[Section], read: impl FnMut(&Section) -> Option<T>) -> Option<Vec<T>> {
    let all: Vec<_> = sections.iter().map(read).collect();
    all.into_iter().collect()
}

/// The number of a required key of these.
pub(crate) fn required(keys: &[Key], section: &Section, name: &str, problems: &mut Problems) -> Option<f64> {
    missing(keys, section, name, problems);
    section.number(name)
}

/// Reports a required key of these if it is missing.
pub(crate) fn missing(keys: &[Key], section: &Section, name: &str, problems: &mut Problems) {
    for key in keys.iter().filter(|key| key.name == name && !section.has(name)) {
        key.missing(section, problems);
    }
}

/// A low and a high end; reported if they are swapped, or missing without a default.
pub(crate) fn range(
    keys: &[Key],
    section: &Section,
    name: &str,
    default: Option<[f64; 2]>,
    problems: &mut Problems,
) -> Option<[f64; 2]> {
    if !section.has(name) {
        if default.is_none() {
            missing(keys, section, name, problems);
        }
        return default;
    }
    let given = section.list(name)?;
    let ends = [*given.first()?, *given.last()?];
    in_order(&section.at(name), ends, problems).then_some(ends)
}

/// Whether numbers are in the range of the key `name`, or `name[0]`, of the section at a path; reported if
/// not.
pub(crate) fn in_range(
    keys: &[Key],
    path: &str,
    name: &str,
    numbers: &[f64],
    problems: &mut Problems,
) -> bool {
    let before = problems.len();
    for key in keys.iter().filter(|key| Some(key.name) == name.split('[').next()) {
        numbers.iter().for_each(|number| _ = key.admits(&format!("{path}.{name}"), *number, problems));
    }
    problems.len() == before
}

/// Whether the low end is below the high end; reported if not.
pub(crate) fn in_order(path: &str, [low, high]: [f64; 2], problems: &mut Problems) -> bool {
    if low < high {
        return true;
    }
    let message = format!("{path} is empty: its low end is not below its high end");
    problems.add(path, message, "write the lower value first");
    false
}

/// A part of the case, or `None` if `check` finds something wrong with it: what follows from it would be
/// wrong, too.
pub(crate) fn checked<T>(
    part: T,
    problems: &mut Problems,
    check: impl FnOnce(&T, &mut Problems),
) -> Option<T> {
    let before = problems.len();
    check(&part, problems);
    (problems.len() == before).then_some(part)
}
