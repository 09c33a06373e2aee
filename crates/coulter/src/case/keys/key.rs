//! A key of a case file and a section of keys.

use crate::case::quantity::Measure;

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

pub(super) const fn key(name: &'static str, kind: Kind, default: &'static str, meaning: &'static str) -> Key {
    Key { name, kind, default, meaning }
}

pub(super) const fn section(name: &'static str, meaning: &'static str, keys: &'static [Key]) -> KeyTable {
    KeyTable { name, meaning, keys }
}
