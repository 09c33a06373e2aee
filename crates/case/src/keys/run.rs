//! Keys at the top of the file and of the run.

use crate::keys::allowed::{NOT_NEGATIVE, POSITIVE};
use crate::keys::usual::GRAVITY;
use input::key::DefaultValue::{Derived, Quantity, Required};
use input::key::{Key, Kind, key};
use input::quantity::{ACCELERATION, LENGTH, TIME};

pub(super) const TOP: &[Key] = &[
    key("format", Kind::Format, Required, "Version of the case-file format."),
    key(
        "name",
        Kind::Text,
        Derived("the name of the file"),
        "Name of the results folder: letters, digits, `-` and `_`.",
    ),
    key("title", Kind::Text, Derived("the name"), "One line for the report."),
    key(
        "gravity",
        Kind::Quantity(ACCELERATION),
        Quantity("9.81 m/s^2"),
        "Acceleration of gravity, downwards.",
    )
    .within(NOT_NEGATIVE)
    .usually(GRAVITY),
];

pub(super) const RUN: &[Key] = &[
    key("duration", Kind::Quantity(TIME), Derived("this or tow_distance"), "How long to run.")
        .within(POSITIVE),
    key(
        "tow_distance",
        Kind::Quantity(LENGTH),
        Derived("this or duration"),
        "Run until every towed body has travelled this far.",
    )
    .within(POSITIVE),
];
