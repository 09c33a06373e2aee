//! Keys of a stage of a run, and of what ends it.

use super::Stage;
use crate::key::allowed::POSITIVE;
use input::key::DefaultValue::{Derived, Required};
use input::key::{Key, KeyOf, Kind, Place, declared, key};
use input::quantity::{FORCE, LENGTH, TIME, TORQUE};

type Field = KeyOf<Stage>;

/// Keys of a stage, and where their values lie.
pub(super) const FIELDS: &[Field] = &[
    Field::new("duration", Kind::Quantity(TIME), Place::Number(|stage| &mut stage.duration))
        .within(POSITIVE)
        .means(
            "How long the stage lasts; with `until` how long at most: a stage that does not reach its end by then ends the run as broken.",
        ),
    Field::new("until", Kind::Until, Place::Elsewhere).derived("the duration").means("What ends the stage."),
    Field::new("steady", Kind::Flag, Place::Elsewhere).derived("the last that tows").means(
        "Whether steady averages are taken over this stage; of one stage at most. Otherwise over the last that sets `forward` or \
         `lateral` of a body in motion, or else the last.",
    ),
];

/// Keys of a stage, without the places of their values.
pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

/// Keys of what ends a stage.
pub(crate) const UNTIL: &[Key] = &[
    key("body", Kind::Text, Required, "Name of the body."),
    key(
        "sinkage",
        Kind::Quantity(LENGTH),
        Derived("one quantity"),
        "Depth of its lowest point below the surface.",
    ),
    key(
        "displacement",
        Kind::Quantity(LENGTH),
        Derived("one quantity"),
        "Displacement along the tow since the stage began; backwards, along −x, it is negative.",
    ),
    key(
        "vertical_force",
        Kind::Quantity(FORCE),
        Derived("one quantity"),
        "Vertical force of the soil on it, upwards.",
    ),
    key("drag", Kind::Quantity(FORCE), Derived("one quantity"), "Drag."),
    key(
        "axle_torque",
        Kind::Quantity(TORQUE),
        Derived("one quantity"),
        "Torque of the soil about its axle, positive when it makes it roll forward.",
    ),
];
