//! Files with keys other than cases, such as studies: read against tables of keys, with the same errors as a
//! case.

use super::format;
use super::keys::{self, DefaultValue, KeyTable, Kind};
use super::values::value;
use input::error::CaseError;
use input::toml_tree::{self, TomlTree};
use input::unknown::unknown;

pub use input::names::nearest;
pub use input::problem::{Problem, Problems};
pub use input::tree::{Entry, Value, join};
pub use input::typed::Section;

use input::places::Places;

/// A file with keys, and where each of them stands in its text.
#[derive(Debug)]
pub struct Form {
    /// Entries of the file, in the order of the text.
    pub entries: Vec<Entry>,
    places: Places,
}

impl Form {
    /// Reads the text of a file in TOML; `name` is what to call it in messages.
    ///
    /// # Errors
    /// [`CaseError`] where it is not TOML.
    pub fn read(text: &str, name: &str) -> Result<Self, CaseError> {
        let TomlTree { tree, places, problems } = toml_tree::read(name, text, &[]);
        if problems.is_empty() { Ok(Self { entries: tree, places }) } else { Err(places.error_at(problems)) }
    }

    /// The error with these problems, each at its place in the text.
    #[must_use]
    pub fn error(&self, problems: Problems) -> CaseError {
        self.places.error(problems.into_aimed())
    }
}

/// Whether the key of a case at a path takes this value, by its kind and its range alone; if not, what is
/// wrong and what to write.
///
/// # Errors
/// Message and cure.
pub fn accepts(path: &str, node: &Value) -> Result<(), [String; 2]> {
    let Some(key) = keys::at(path) else {
        let section = path.rsplit_once('.').map_or("", |(section, _)| section);
        let cure = "name a key of a case file, such as soil.friction_angle or body.disc.weight; docs/reference/case-file.md lists them";
        let place =
            if section.is_empty() { "at the top of a case".to_owned() } else { format!("in [{section}]") };
        return Err([format!("there is no key `{path}` {place}"), cure.to_owned()]);
    };
    // What a motion measures depends on its degree of freedom: only the whole case knows.
    let is_of_motion = path.split('.').count() == 4 || key.kind.is_motion();
    if is_of_motion || matches!(key.kind, Kind::Follow | Kind::Until) {
        return Ok(());
    }
    let mut problems = Problems::default();
    let _ = value(node, &key.kind, path, &mut problems);
    problems.into_list().into_iter().next().map_or(Ok(()), |p| Err([p.message, p.cure]))
}

/// The value at a path of a tree.
#[must_use]
pub fn find<'a>(entries: &'a [Entry], path: &str) -> Option<&'a Value> {
    let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
    let value = &entries.iter().find(|entry| entry.key == first)?.value;
    match (rest, value) {
        (None, value) => Some(value),
        (Some(rest), Value::Table(inner)) => find(inner, rest),
        _ => None,
    }
}

/// Reads the entries of a section against its table of keys; unknown keys are reported, unless `others` knows
/// them.
pub fn section(
    entries: &[Entry],
    table: &KeyTable,
    path: &str,
    others: &[&str],
    problems: &mut Problems,
) -> Section {
    let mut read = with_defaults(table, path);
    for entry in entries {
        match table.keys.iter().find(|key| key.name == entry.key) {
            Some(key) => {
                read.insert(key.name, value(&entry.value, &key.kind, &join(path, key.name), problems));
            }
            None if others.contains(&entry.key.as_str()) => {}
            None => {
                let known = table.keys.iter().map(|key| key.name).chain(others.iter().copied());
                unknown(entry, path, known, problems);
            }
        }
    }
    for key in table.keys.iter().filter(|key| key.default == DefaultValue::Required && !read.has(key.name)) {
        if matches!(key.kind, Kind::Format) {
            format::missing(problems);
            continue;
        }
        let at = join(path, key.name);
        problems.add(at.clone(), format!("`{at}` is missing"), key.meaning);
    }
    for key in table.keys {
        let (Some(range), Some(number)) = (key.range, read.number(key.name)) else { continue };
        if read.has(key.name) && !range.contains(number) {
            let at = join(path, key.name);
            let cure = format!("it must be {}", key.range_text().unwrap_or_default());
            problems.add(at.clone(), format!("{at} = {} is out of range", key.shown(number)), cure);
        }
    }
    read
}

/// A section in which nothing is given.
pub(super) fn with_defaults(table: &KeyTable, path: &str) -> Section {
    let mut section = Section::empty(path);
    for key in table.keys {
        if let Some(default) = default_as_typed(&key.default) {
            // Every default can be read: a test reads them all.
            section.insert_default(
                key.name,
                value(&default, &key.kind, &join(path, key.name), &mut Problems::default()),
            );
        }
    }
    section
}

/// A default as it would be typed; `None` if it is derived, or if there is none.
pub(super) fn default_as_typed(default: &DefaultValue) -> Option<Value> {
    match *default {
        DefaultValue::Number(number) => {
            Some(if number.fract() == 0.0 { Value::Integer(number as i64) } else { Value::Number(number) })
        }
        DefaultValue::Ratios(numbers) => Some(Value::List(numbers.map(Value::Number).into())),
        DefaultValue::Quantity(text)
        | DefaultValue::Otherwise { quantity: text, .. }
        | DefaultValue::Word(text) => Some(Value::Text(text.to_owned())),
        DefaultValue::Flag(flag) => Some(Value::Flag(flag)),
        DefaultValue::Walls(walls) => {
            Some(Value::List(walls.map(|wall| Value::Text(wall.to_owned())).into()))
        }
        DefaultValue::Required
        | DefaultValue::RequiredFor(_)
        | DefaultValue::DurationOver(_)
        | DefaultValue::ByLaw { .. }
        | DefaultValue::Derived(_) => None,
    }
}
