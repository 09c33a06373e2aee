//! Keys at the top of the file, of the run, of what it writes and of the method.

use super::key::{Key, Kind, key};
use super::words::{CONTACTS, PRECISIONS};
use crate::case::quantity::{ACCELERATION, LENGTH, TIME};

pub(super) const TOP: &[Key] = &[
    key("format", Kind::Format, "required", "Version of the case-file format."),
    key(
        "name",
        Kind::Text,
        "the name of the file",
        "Name of the results folder: letters, digits, `-` and `_`.",
    ),
    key("title", Kind::Text, "the name", "One line for the report."),
    key(
        "gravity",
        Kind::Quantity(ACCELERATION),
        "9.81 m/s^2",
        "Acceleration of gravity, downwards; may be 0.",
    ),
];

pub(super) const RUN: &[Key] = &[
    key("duration", Kind::Quantity(TIME), "this or tow_distance", "How long to run."),
    key(
        "tow_distance",
        Kind::Quantity(LENGTH),
        "this or duration",
        "Run until every towed body has travelled this far.",
    ),
];

pub(super) const OUTPUT: &[Key] = &[
    key("history_interval", Kind::Quantity(TIME), "duration / 500", "Time between the lines of forces.csv."),
    key("field_interval", Kind::Quantity(TIME), "duration / 20", "Time between the field files of the soil."),
    key("checkpoint_interval", Kind::Quantity(TIME), "10 min", "Wall-clock time between checkpoints."),
    key(
        "steady_fraction",
        Kind::Number,
        "0.3",
        "Fraction of the run, at its end, over which steady averages are taken.",
    ),
];

pub(super) const NUMERICS: &[Key] = &[
    key(
        "courant",
        Kind::Number,
        "0.5",
        "Courant number: time step over the time that a wave takes to cross the smallest cell.",
    ),
    key(
        "remap_displacement",
        Kind::Number,
        "0.1",
        "Displacement in cell widths at which the soil is remapped.",
    ),
    key("hourglass", Kind::Number, "0.01", "Coefficient of hourglass viscosity."),
    key(
        "hourglass_yielding",
        Kind::Number,
        "1",
        "Fraction of the hourglass viscosity that acts in cells that yield, 0 to 1.",
    ),
    key(
        "bulk_viscosity_linear",
        Kind::Number,
        "0.02; tresca and von-mises 0.06",
        "Linear coefficient b₁ of bulk viscosity.",
    ),
    key("bulk_viscosity_quadratic", Kind::Number, "1.2", "Quadratic coefficient b₂ of bulk viscosity."),
    key("contact", Kind::Choice(&CONTACTS), "\"impulse\"", "Contact method."),
    key("edge_inset", Kind::Number, "0.5", "Distance of contact points from sharp edges, in cell widths."),
    key("point_spacing", Kind::Number, "0.25", "Spacing of contact points, in cell widths."),
    key("threads", Kind::Count, "0", "Threads, at most 64; 0 for one per core."),
    key(
        "precision",
        Kind::Choice(&PRECISIONS),
        "\"double\"",
        "Precision of the soil's fields; single takes two thirds of the time and about half the memory.",
    ),
];
