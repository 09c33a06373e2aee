//! What was typed: the tree, checked against the table of keys. Nothing is interpreted here.

use super::format;
use super::keys;
use super::problem::{Place, Problems};
use super::tree::{Entry, Value};
use super::values::value;
use super::{is_device, nearest};
use std::collections::BTreeMap;

/// A value and where it was typed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Typed<T> {
    pub(super) value: T,
    pub(super) place: Place,
}

/// A value of the right type, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Given {
    Text(String),
    Number(f64),
    Flag(bool),
    List(Vec<Typed<f64>>),
    Words(Vec<String>),
    Motion(Motion),
    /// Reported already; counts as given so that it is not reported as missing too.
    Broken,
}

/// How a degree of freedom moves, as typed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Motion {
    pub(super) word: Option<String>,
    pub(super) speed: Option<Typed<f64>>,
    pub(super) load: Option<Typed<f64>>,
    pub(super) start: Option<Typed<f64>>,
    pub(super) ramp: Option<Typed<f64>>,
    pub(super) end: Option<Typed<f64>>,
}

/// A section as typed.
#[derive(Clone, Debug)]
pub(super) struct Section {
    /// `soil`, or `body.disc`.
    pub(super) path: String,
    /// Its heading.
    pub(super) place: Place,
    values: BTreeMap<&'static str, Typed<Given>>,
}

impl Section {
    fn empty(path: &str, place: Place) -> Self {
        Self { path: path.to_owned(), place, values: BTreeMap::new() }
    }

    /// Whether the key stands in the file, right or wrong.
    pub(super) fn has(&self, key: &str) -> bool {
        self.values.contains_key(key)
    }

    /// Where the value of the key stands, or the section's heading.
    pub(super) fn place_of(&self, key: &str) -> &Place {
        self.values.get(key).map_or(&self.place, |v| &v.place)
    }

    fn get<T>(&self, key: &str, pick: impl Fn(&Given) -> Option<T>) -> Option<Typed<T>> {
        let typed = self.values.get(key)?;
        Some(Typed { value: pick(&typed.value)?, place: typed.place.clone() })
    }

    pub(super) fn number(&self, key: &str) -> Option<Typed<f64>> {
        self.get(key, |v| if let Given::Number(n) = v { Some(*n) } else { None })
    }

    pub(super) fn text(&self, key: &str) -> Option<Typed<String>> {
        self.get(key, |v| if let Given::Text(t) = v { Some(t.clone()) } else { None })
    }

    pub(super) fn flag(&self, key: &str) -> Option<Typed<bool>> {
        self.get(key, |v| if let Given::Flag(f) = v { Some(*f) } else { None })
    }

    pub(super) fn list(&self, key: &str) -> Option<Typed<Vec<Typed<f64>>>> {
        self.get(key, |v| if let Given::List(l) = v { Some(l.clone()) } else { None })
    }

    pub(super) fn words(&self, key: &str) -> Option<Typed<Vec<String>>> {
        self.get(key, |v| if let Given::Words(w) = v { Some(w.clone()) } else { None })
    }

    pub(super) fn motion(&self, key: &str) -> Option<Typed<Motion>> {
        self.get(key, |v| if let Given::Motion(m) = v { Some(m.clone()) } else { None })
    }
}

/// A whole file as typed.
#[derive(Clone, Debug)]
pub(super) struct Schema {
    pub(super) top: Section,
    pub(super) soil: Section,
    pub(super) ground: Section,
    pub(super) domain: Section,
    pub(super) grid: Section,
    pub(super) bodies: Vec<Section>,
    pub(super) run: Section,
    pub(super) output: Section,
    pub(super) numerics: Section,
    pub(super) forecast: Section,
}

/// Checks the tree against the table of keys.
pub(super) fn read(root: &[Entry], problems: &mut Problems) -> Schema {
    let names: Vec<&str> = keys::SECTIONS.iter().map(|s| s.name).filter(|n| !n.is_empty()).collect();
    let (sections, plain): (Vec<&Entry>, Vec<&Entry>) = root.iter().partition(|e| names.contains(&&*e.key));
    let top_keys = keys::find("").map_or(&[][..], |s| s.keys);
    let mut top = Section::empty("", Place::file());
    for entry in plain {
        match top_keys.iter().find(|k| k.name == entry.key) {
            Some(key) => {
                let value = value(&entry.node, &key.kind, key.name, problems);
                top.values.insert(key.name, Typed { value, place: entry.node.place.clone() });
            }
            None => {
                unknown(entry, "", top_keys.iter().map(|k| k.name).chain(names.iter().copied()), problems)
            }
        }
    }
    if !top.has("format") {
        format::missing(problems);
    }
    let mut one = |name: &str| match sections.iter().find(|e| e.key == name) {
        Some(entry) => section(entry, name, name, problems),
        None => Section::empty(name, Place::file()),
    };
    let (soil, ground, domain, grid) = (one("soil"), one("ground"), one("domain"), one("grid"));
    let (run, output, numerics, forecast) = (one("run"), one("output"), one("numerics"), one("forecast"));
    let bodies = sections.iter().find(|e| e.key == "body").map_or(Vec::new(), |e| bodies(e, problems));
    Schema { top, soil, ground, domain, grid, bodies, run, output, numerics, forecast }
}

/// Most bodies of a case; with more, the text and the report can no longer be read.
const MOST_BODIES: usize = 500;

fn bodies(entry: &Entry, problems: &mut Problems) -> Vec<Section> {
    let Value::Table(table) = &entry.node.value else {
        let message = format!("`body` must be a table, not {}", entry.node.value.kind());
        problems.add(&entry.node.place, message, "give every body a section of its own: [body.disc]");
        return Vec::new();
    };
    if table.len() > MOST_BODIES {
        let message = format!("{} bodies; {MOST_BODIES} are the most", table.len());
        problems.add(&entry.key_place, message, "model fewer of them, or each group in a case of its own");
        return Vec::new();
    }
    let mut list = Vec::new();
    for named in table {
        let is_plain = named.key.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
        if named.key.is_empty() || !is_plain || is_device(&named.key) {
            let message = format!("a body cannot be called \"{}\"", named.key);
            problems.add(
                &named.key_place,
                message,
                "use letters, digits, `-` and `_`, and no name of a Windows device",
            );
        } else if matches!(named.node.value, Value::Table(_)) {
            list.push(section(named, "body", &format!("body.{}", named.key), problems));
        } else {
            let message = format!("`{}` stands in [body], which has no keys of its own", named.key);
            problems.add(&named.key_place, message, "give the body a name in its heading: [body.disc]");
        }
    }
    list
}

fn section(entry: &Entry, kind: &str, path: &str, problems: &mut Problems) -> Section {
    let mut read = Section::empty(path, entry.key_place.clone());
    let known = keys::find(kind).map_or(&[][..], |s| s.keys);
    let Value::Table(table) = &entry.node.value else {
        let message = format!("`{path}` must be a section, not {}", entry.node.value.kind());
        problems.add(&entry.node.place, message, format!("write it as a heading: [{path}]"));
        for key in known {
            read.values.insert(key.name, Typed { value: Given::Broken, place: entry.node.place.clone() });
        }
        return read;
    };
    for inner in table {
        if let Some(new) = format::new_key(path, &inner.key) {
            let message = format!("`{path}.{}` is now called `{path}.{new}`", inner.key);
            problems.add(&inner.key_place, message, format!("write {new} instead of {}", inner.key));
            read.values.insert(new, Typed { value: Given::Broken, place: inner.key_place.clone() });
            continue;
        }
        match known.iter().find(|k| k.name == inner.key) {
            Some(key) => {
                let value = value(&inner.node, &key.kind, &format!("{path}.{}", key.name), problems);
                read.values.insert(key.name, Typed { value, place: inner.node.place.clone() });
            }
            None => unknown(inner, path, known.iter().map(|k| k.name), problems),
        }
    }
    read
}

pub(super) fn unknown<'a>(
    entry: &Entry,
    path: &str,
    known: impl Iterator<Item = &'a str>,
    problems: &mut Problems,
) {
    let known: Vec<&str> = known.collect();
    let place = if path.is_empty() { "at the top of the file".to_owned() } else { format!("in [{path}]") };
    let cure = match nearest(&entry.key, known.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("known here: {}", known.join(", ")),
    };
    problems.add(&entry.key_place, format!("unknown key `{}` {place}", entry.key), cure);
}
