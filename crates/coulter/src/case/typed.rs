//! The content of a case file as typed: sections, values and their locations.

use super::problem::Location;
use std::collections::BTreeMap;

/// A value and its location.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Typed<T> {
    pub(super) value: T,
    pub(super) location: Location,
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
    /// Reported already; counts as given, so that it is not reported as missing as well.
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
    /// Its path: `soil`, or `body.disc`.
    pub(super) path: String,
    /// Location of its heading.
    pub(super) location: Location,
    values: BTreeMap<&'static str, Typed<Given>>,
}

impl Section {
    pub(super) fn empty(path: &str, location: Location) -> Self {
        Self { path: path.to_owned(), location, values: BTreeMap::new() }
    }

    /// Enters the value of a key.
    pub(super) fn insert(&mut self, key: &'static str, value: Given, location: Location) {
        self.values.insert(key, Typed { value, location });
    }

    /// Whether the key is given, right or wrong.
    pub(super) fn has(&self, key: &str) -> bool {
        self.values.contains_key(key)
    }

    /// Location of the value of the key, or of the section's heading.
    pub(super) fn location_of(&self, key: &str) -> &Location {
        self.values.get(key).map_or(&self.location, |v| &v.location)
    }

    fn get<T>(&self, key: &str, pick: impl Fn(&Given) -> Option<T>) -> Option<Typed<T>> {
        let typed = self.values.get(key)?;
        Some(Typed { value: pick(&typed.value)?, location: typed.location.clone() })
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
