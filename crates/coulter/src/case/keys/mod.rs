//! Every key of a case file, with its kind, default, range and meaning. Reading, `validate`, the JSON schema and the
//! documentation all follow from these tables.

mod allowed_range;
mod body;
mod default_value;
mod forecast;
mod joint;
mod key;
mod run;
mod soil;
pub mod words;

pub use allowed_range::{AllowedRange, Bound};
pub use default_value::DefaultValue;
pub use key::{Key, KeyTable, Kind};

use key::section;

/// All sections.
pub const SECTIONS: [KeyTable; 11] = [
    section("", "At the top of the file, before any section.", run::TOP),
    section("soil", "The soil.", soil::SOIL),
    section("ground", "Where there is soil at the start.", soil::GROUND),
    section("domain", "The box that is modelled.", soil::DOMAIN),
    section("grid", "Cell sizes.", soil::GRID),
    section("body", "A rigid body, `[body.NAME]`; any number of them.", body::BODY),
    section(
        "joint",
        "A joint between two bodies, or between a body and the ground, `[joint.NAME]`. Motions of a body that a joint carries are free \
         unless they are given.",
        joint::JOINT,
    ),
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

/// The keys of a motion that is written as a table.
pub const MOTION: KeyTable =
    section("motion", "A motion of a body that is written as a table.", body::MOTION);

/// The keys of what a grid follows.
pub const FOLLOW: KeyTable =
    section("follow", "What the grid follows, `{ body = \"disc\", axes = \"x\" }`.", soil::FOLLOW);

/// The key that a path leads to: `gravity`, `soil.cohesion`, `body.disc.forward.ramp`; of a list `domain.x[0]`, too.
#[must_use]
pub fn at(path: &str) -> Option<&'static Key> {
    let path = path.split('[').next().unwrap_or_default();
    let names: Vec<&str> = path.split('.').collect();
    match names[..] {
        [name] => find("")?.key(name),
        [kind @ ("body" | "joint"), _, name] => find(kind)?.key(name),
        ["body", _, motion, name] if matches!(find("body")?.key(motion)?.kind, Kind::Motion { .. }) => {
            MOTION.key(name)
        }
        ["grid", "follow", name] => FOLLOW.key(name),
        [section, name] if !["body", "joint"].contains(&section) => find(section)?.key(name),
        _ => None,
    }
}
