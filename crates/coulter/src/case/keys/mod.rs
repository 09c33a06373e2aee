//! Every key of a case file, with its kind, default and meaning. Reading, the JSON schema and the documentation all
//! follow from these tables.

mod body;
mod forecast;
mod run;
mod soil;
pub mod words;

use super::quantity::Measure;

/// What a value may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Any text.
    Text,
    /// The version of the case-file format.
    Format,
    /// A number with a unit, as text.
    Quantity(Measure),
    /// A number without a unit.
    Number,
    /// A whole number, 0 or more.
    Count,
    /// `true` or `false`.
    Flag,
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// Low and high end: two quantities.
    Range(Measure),
    /// Two or three quantities.
    Vector(Measure),
    /// Bekker's modulus in N/m^(n+i), whose unit contains the sinkage exponent n; the number is i.
    Modulus(i32),
    /// A number, or the word `rough`.
    Friction,
    /// The boundary conditions at the low and at the high end.
    WallPair,
    /// How a degree of freedom moves: a word, or a table with a speed or a load.
    Motion {
        /// The word for no motion.
        still: &'static str,
        /// What `speed` measures.
        speed: Measure,
        /// What `load` measures.
        load: Measure,
    },
}

/// One key.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name in its section.
    pub name: &'static str,
    /// What its value may be.
    pub kind: Kind,
    /// What applies if it is left out; `required` if it must not be.
    pub default: &'static str,
    /// What it means.
    pub meaning: &'static str,
}

/// The keys of one section.
#[derive(Clone, Copy, Debug)]
pub struct KeyTable {
    /// Name of the section; empty for the top of the file, `body` for `[body.NAME]`.
    pub name: &'static str,
    /// What the section is about.
    pub meaning: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

const fn key(name: &'static str, kind: Kind, default: &'static str, meaning: &'static str) -> Key {
    Key { name, kind, default, meaning }
}

const fn section(name: &'static str, meaning: &'static str, keys: &'static [Key]) -> KeyTable {
    KeyTable { name, meaning, keys }
}

/// All sections.
pub const SECTIONS: [KeyTable; 10] = [
    section("", "At the top of the file, before any section.", run::TOP),
    section("soil", "The soil.", soil::SOIL),
    section("ground", "Where there is soil at the start.", soil::GROUND),
    section("domain", "The box that is modelled.", soil::DOMAIN),
    section("grid", "Cell sizes.", soil::GRID),
    section("body", "A rigid body, `[body.NAME]`; any number of them.", body::BODY),
    section("run", "How long to run.", run::RUN),
    section("output", "What to write, and how often.", run::OUTPUT),
    section("numerics", "Parameters of the method.", run::NUMERICS),
    section("forecast", "Used by `coulter forecast` only; `coulter run` ignores it.", forecast::FORECAST),
];

/// The section of that name.
#[must_use]
pub fn find(name: &str) -> Option<&'static KeyTable> {
    SECTIONS.iter().find(|s| s.name == name)
}
