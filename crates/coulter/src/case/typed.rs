//! The content of a case as typed: sections and values in SI units, with the defaults of the keys that are left out.

use super::tree::{Value, join};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A value of the right type, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Given {
    Text(String),
    Number(f64),
    Flag(bool),
    List(Vec<f64>),
    Words(Vec<String>),
    /// As typed.
    AsTyped(Value),
    Motion(Motion),
    /// Name of a body, and axes.
    Follow([String; 2]),
    Until(Until),
    /// Reported already; counts as given, so that it is not reported as missing as well.
    Broken,
}

/// How a degree of freedom moves, as typed; start and ramp are their defaults unless given.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Motion {
    pub(super) word: Option<String>,
    pub(super) speed: Option<f64>,
    pub(super) load: Option<f64>,
    pub(super) start: f64,
    pub(super) ramp: f64,
    pub(super) end: Option<f64>,
    /// Slip of a rolling body.
    pub(super) slip: Option<f64>,
    pub(super) displacement: Option<f64>,
    /// The file of a table.
    pub(super) table: Option<String>,
    /// The word that says which of its times is the start.
    pub(super) from: Option<String>,
    /// Whether a time was given.
    pub(super) is_timed: bool,
}

/// What ends a stage, as typed: a body, and the key and the value of what it reaches.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Until {
    pub(super) body: String,
    pub(super) key: &'static str,
    pub(super) value: f64,
}

/// A section as typed.
#[derive(Clone, Debug)]
pub struct Section {
    /// Path of the section: `soil`, or `body.disc`; empty for the top.
    pub(super) path: String,
    /// Folder of the case file, to which files that it names are relative.
    pub(super) folder: PathBuf,
    given: BTreeMap<&'static str, Given>,
    defaults: BTreeMap<&'static str, Given>,
    /// Sections in it: motions of bodies in a stage.
    pub(super) inner: Vec<Section>,
}

impl Section {
    pub(super) fn empty(path: &str) -> Self {
        Self {
            path: path.to_owned(),
            folder: PathBuf::new(),
            given: BTreeMap::new(),
            defaults: BTreeMap::new(),
            inner: Vec::new(),
        }
    }

    /// Enters the value of a key.
    pub(super) fn insert(&mut self, key: &'static str, value: Given) {
        self.given.insert(key, value);
    }

    /// Enters what applies if a key is not given.
    pub(super) fn insert_default(&mut self, key: &'static str, value: Given) {
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
    pub(super) fn number_or(&self, key: &str, derived: f64) -> Option<f64> {
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

    pub(super) fn list(&self, key: &str) -> Option<Vec<f64>> {
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

    pub(super) fn follow(&self, key: &str) -> Option<[String; 2]> {
        self.get(key, |v| if let Given::Follow(f) = v { Some(f.clone()) } else { None })
    }

    pub(super) fn until(&self, key: &str) -> Option<Until> {
        self.get(key, |v| if let Given::Until(u) = v { Some(u.clone()) } else { None })
    }

    pub(super) fn motion(&self, key: &str) -> Option<Motion> {
        self.get(key, |v| if let Given::Motion(m) = v { Some(m.clone()) } else { None })
    }
}

/// A whole case as typed.
#[derive(Clone, Debug)]
pub(super) struct Schema {
    pub(super) top: Section,
    /// `None` where the case has no such section.
    pub(super) water: Option<Section>,
    pub(super) soil: Section,
    pub(super) ground: Section,
    pub(super) height_map: Option<Section>,
    pub(super) furrows: Option<Section>,
    pub(super) domain: Section,
    pub(super) grid: Section,
    pub(super) bodies: Vec<Section>,
    pub(super) layers: Vec<Section>,
    pub(super) soil_bodies: Vec<Section>,
    pub(super) joints: Vec<Section>,
    pub(super) stages: Vec<Section>,
    pub(super) run: Section,
    pub(super) output: Section,
    pub(super) numerics: Section,
    pub(super) forecast: Section,
}

impl Schema {
    /// Says in which folder the files lie that the case names.
    pub(super) fn lie_in(&mut self, folder: &Path) {
        let in_stages = self.stages.iter_mut().flat_map(|stage| &mut stage.inner);
        let of_ground = self.soil_bodies.iter_mut().chain(&mut self.height_map);
        for section in self.bodies.iter_mut().chain(in_stages).chain(of_ground) {
            section.folder = folder.to_path_buf();
        }
    }
}
