//! Every key of a case file, with its kind, default and meaning. Reading, the JSON schema and the documentation all
//! follow from these tables.

mod body;
mod forecast;
mod key;
mod run;
mod soil;
pub mod words;

pub use key::{Key, KeyTable, Kind};

use key::section;

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
