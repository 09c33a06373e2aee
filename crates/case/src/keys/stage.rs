//! Keys of a stage of a run, and of what ends it.

use crate::keys::allowed::POSITIVE;
use input::key::DefaultValue::{Derived, Required};
use input::key::{Key, Kind, key};
use input::quantity::{FORCE, LENGTH, TIME, TORQUE};

pub(super) const STAGE: &[Key] = &[
    key(
        "duration",
        Kind::Quantity(TIME),
        Required,
        "How long the stage lasts; with `until` how long at most: a stage that does not reach its end by then ends the run as broken.",
    )
    .within(POSITIVE),
    key("until", Kind::Until, Derived("the duration"), "What ends the stage."),
];

pub(super) const UNTIL: &[Key] = &[
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
