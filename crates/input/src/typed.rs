//! The content of a case as typed: sections and values in SI units, with the defaults of the keys that are
//! left out.

use super::tree::{Value, join};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// A value of the right type, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// A text.
    Text(String),
    /// A number.
    Number(f64),
    /// `true` or `false`.
    Flag(bool),
    /// Several numbers.
    List(Vec<f64>),
    /// Several words.
    Words(Vec<String>),
    /// A value as it was typed.
    AsTyped(Value),
    /// How a degree of freedom moves.
    Motion(Motion),
    /// Name of a body, and axes.
    Follow([String; 2]),
    /// What ends a stage.
    Until(Until),
    /// Reported already; counts as given, so that it is not reported as missing as well.
    Broken,
}

/// How a degree of freedom moves, as typed; start and ramp are their defaults unless given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// A word: `"free"`, `"rolling"`.
    pub word: Option<String>,
    /// Speed [m/s or rad/s].
    pub speed: Option<f64>,
    /// Force [N] or torque [N m].
    pub load: Option<f64>,
    /// When the motion begins [s].
    pub start: f64,
    /// How long the motion takes to reach its full value [s].
    pub ramp: f64,
    /// When the motion ends [s].
    pub end: Option<f64>,
    /// Slip of a rolling body.
    pub slip: Option<f64>,
    /// How far the motion goes [m or rad].
    pub displacement: Option<f64>,
    /// The file of a table.
    pub table: Option<String>,
    /// The word that says which of the times of the table is the start.
    pub from: Option<String>,
    /// Whether a time was given.
    pub is_timed: bool,
}

/// What ends a stage, as typed: a body, and the key and the value of what it reaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Until {
    /// Name of the body.
    pub body: String,
    /// What the body reaches: a key of `until`.
    pub key: &'static str,
    /// The value that the quantity reaches, in SI units.
    pub value: f64,
}

/// A section as typed.
#[derive(Clone, Debug)]
pub struct Section {
    /// Path of the section: `soil`, or `body.disc`; empty for the top.
    pub path: String,
    /// Folder of the case file, to which files that it names are relative.
    pub folder: PathBuf,
    given: BTreeMap<&'static str, Given>,
    defaults: BTreeMap<&'static str, Given>,
    /// Sections in this one: motions of bodies in a stage.
    pub inner: Vec<Section>,
}

impl Section {
    /// A section in which nothing is given.
    #[must_use]
    pub fn empty(path: &str) -> Self {
        Self {
            path: path.to_owned(),
            folder: PathBuf::new(),
            given: BTreeMap::new(),
            defaults: BTreeMap::new(),
            inner: Vec::new(),
        }
    }

    /// Enters the value of a key.
    pub fn insert(&mut self, key: &'static str, value: Given) {
        self.given.insert(key, value);
    }

    /// Enters what applies if a key is not given.
    pub fn insert_default(&mut self, key: &'static str, value: Given) {
        self.defaults.insert(key, value);
    }

    /// The path of a key: `soil.cohesion`, or `gravity` at the top.
    #[must_use]
    pub fn at(&self, key: &str) -> String {
        join(&self.path, key)
    }

    /// Whether the key is given, right or wrong.
    #[must_use]
    pub fn has(&self, key: &str) -> bool {
        self.given.contains_key(key)
    }

    /// What is given, or the default; `None` for neither, and for what is wrong.
    fn get<T>(&self, key: &str, pick: impl Fn(&Given) -> Option<T>) -> Option<T> {
        self.given.get(key).or_else(|| self.defaults.get(key)).and_then(pick)
    }

    /// The number of a key.
    #[must_use]
    pub fn number(&self, key: &str) -> Option<f64> {
        self.get(key, |v| if let Given::Number(n) = v { Some(*n) } else { None })
    }

    /// The number, or one that is derived if the key is not given.
    pub fn number_or(&self, key: &str, derived: f64) -> Option<f64> {
        if self.has(key) { self.number(key) } else { Some(derived) }
    }

    /// The text of a key.
    #[must_use]
    pub fn text(&self, key: &str) -> Option<String> {
        self.get(key, |v| if let Given::Text(t) = v { Some(t.clone()) } else { None })
    }

    /// The flag of a key.
    #[must_use]
    pub fn flag(&self, key: &str) -> Option<bool> {
        self.get(key, |v| if let Given::Flag(f) = v { Some(*f) } else { None })
    }

    /// The numbers of a key.
    #[must_use]
    pub fn list(&self, key: &str) -> Option<Vec<f64>> {
        self.get(key, |v| if let Given::List(l) = v { Some(l.clone()) } else { None })
    }

    /// The words of a key.
    #[must_use]
    pub fn words(&self, key: &str) -> Option<Vec<String>> {
        self.get(key, |v| if let Given::Words(w) = v { Some(w.clone()) } else { None })
    }

    /// What was typed for a key whose values are not read any further.
    #[must_use]
    pub fn as_typed(&self, key: &str) -> Option<Value> {
        self.get(key, |v| if let Given::AsTyped(value) = v { Some(value.clone()) } else { None })
    }

    /// The body that the grid follows, and along which axes.
    #[must_use]
    pub fn follow(&self, key: &str) -> Option<[String; 2]> {
        self.get(key, |v| if let Given::Follow(f) = v { Some(f.clone()) } else { None })
    }

    /// What ends a stage.
    #[must_use]
    pub fn until(&self, key: &str) -> Option<Until> {
        self.get(key, |v| if let Given::Until(u) = v { Some(u.clone()) } else { None })
    }

    /// How a degree of freedom moves.
    #[must_use]
    pub fn motion(&self, key: &str) -> Option<Motion> {
        self.get(key, |v| if let Given::Motion(m) = v { Some(m.clone()) } else { None })
    }
}
