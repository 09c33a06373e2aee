//! Every key of a case file, with its kind, default, range and meaning. Reading, `validate`, the JSON schema
//! and the documentation all follow from these tables.

pub use super::key::words;
pub use super::soil_body::PLACE_KEYS;
use super::{body, domain, grid, ground, height_map, joint, run, shapes, stage, top};
pub use input::key::{AllowedRange, Bound, DefaultValue, Key, KeyTable, Kind, UsualRange, key, section};

/// Number of keys that describe a shape: the first of a body.
pub const SHAPE_KEYS: usize = shapes::KEYS.len();

/// All sections.
pub const SECTIONS: [KeyTable; 17] = [
    section("", "At the top of the file, before any section.", top::KEYS),
    section("soil", "The soil; of ground in layers the uppermost.", super::soil::KEYS),
    section(
        "layer",
        "A layer of another soil, `[layer.NAME]`, from its top down to that of the next layer below, or to the floor; up to 20 of \
         them. It has a depth and every key of `[soil]`.",
        super::layer::Layer::KEYS,
    ),
    section(
        "soil_body",
        "A body of soil of another kind, `[soil_body.NAME]`: a lens, a boulder of clay, a backfilled trench; above the surface a heap. Up to 20 of \
         them; where two overlap, the first in the file counts. It has a place and an attitude, and besides these every key of a \
         `[body.NAME]` that describes its shape, and every key of `[soil]`. Strength and density that grow with depth do so from its highest \
         point.",
        super::soil_body::SoilBody::KEYS,
    ),
    section("ground", "Where there is soil at the start.", ground::KEYS),
    section(
        "height_map",
        "Heights of the ground from a file, over `ground.surface`. The map must cover the domain, of a grid that follows a body on its \
         whole path.",
        height_map::KEYS,
    ),
    section(
        "furrows",
        "Furrows: a surface that rises and falls periodically, alone or added to a height map.",
        super::relief::Furrows::KEYS,
    ),
    section(
        "water",
        "Water over the ground. Without this section the ground is dry. Under water `unit_weight` of a soil is its submerged unit weight γ′, \
         `density` its dry density, and the weight of a body is reduced by its buoyancy.",
        super::water::Water::KEYS,
    ),
    section("domain", "The box that is modelled.", domain::KEYS),
    section("grid", "Cell sizes.", grid::KEYS),
    section("body", "A rigid body, `[body.NAME]`; any number of them.", body::KEYS),
    section(
        "joint",
        "A joint between two bodies, or between a body and the ground, `[joint.NAME]`. Motions of a body that a joint carries are free \
         unless they are given.",
        joint::KEYS,
    ),
    section(
        "stage",
        "A stage of the run, `[stage.NAME]`, in the order of the file; any number of them. Every other key is the name of a body with the \
         motions that change: `disc.heave = \"free\"`. They start from the speed and the load that the body has then, and their times \
         count from the beginning of the stage; motions that are not named go on as they were. Steady averages are taken over the last \
         stage in which a body is towed.",
        stage::KEYS,
    ),
    section("run", "How long to run.", run::KEYS),
    section("output", "What to write, and how often.", super::output::Output::KEYS),
    section("numerics", "Parameters of the method.", super::numerics::Numerics::KEYS),
    section(
        "forecast",
        "Used by `coulter forecast` only; `coulter run` ignores it.",
        super::measured::Measured::KEYS,
    ),
];

/// Sections of which there are several, each with a name: `[body.disc]`.
pub const NAMED: [&str; 5] = ["layer", "soil_body", "body", "joint", "stage"];

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
    section("follow", "What the grid follows, `{ body = \"disc\", axes = \"x\" }`.", grid::FOLLOW);

/// The keys of what ends a stage.
pub const UNTIL: KeyTable = section(
    "until",
    "What ends a stage, `{ body = \"disc\", sinkage = \"20 mm\" }`: one quantity of a body that reaches or passes a value, from above \
     or below. It is looked at with every line of the history, so forces are means over `output.history_interval`.",
    stage::UNTIL,
);

/// The key that a path leads to: `gravity`, `soil.cohesion`, `body.disc.forward.ramp`; of a list
/// `domain.x[0]`, too.
#[must_use]
pub fn at(path: &str) -> Option<&'static Key> {
    let path = path.split('[').next().unwrap_or_default();
    let names: Vec<&str> = path.split('.').collect();
    match names[..] {
        [name] => find("")?.key(name),
        [kind, _, name] if NAMED.contains(&kind) => find(kind)?.key(name),
        ["stage", _, "until", name] => UNTIL.key(name),
        ["stage", _, _, motion] => find("body")?.key(motion).filter(|key| key.kind.is_motion()),
        ["stage", _, _, motion, name] if find("body")?.key(motion)?.kind.is_motion() => MOTION.key(name),
        ["body", _, motion, name] if find("body")?.key(motion)?.kind.is_motion() => MOTION.key(name),
        ["grid", "follow", name] => FOLLOW.key(name),
        [section, name] if !NAMED.contains(&section) => find(section)?.key(name),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{MOTION, SECTIONS};

    #[test]
    fn every_usual_range_has_ends_in_order_and_within_what_is_allowed() {
        for key in SECTIONS.iter().flat_map(|section| section.keys).chain(MOTION.keys) {
            if key.usual.is_some() {
                let [low, high] = key.usual_ends().expect(key.name);
                assert!(low < high, "{}", key.name);
                assert!(key.range.is_none_or(|range| range.contains(high)), "{}", key.name);
            }
        }
    }
}
