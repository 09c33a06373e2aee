//! Keys at the top of the file, of the run, of what it writes and of the method.

use super::allowed_range::{FRACTION, NOT_NEGATIVE, POSITIVE, POSITIVE_FRACTION, SPACING, THREADS};
use super::default_value::DefaultValue::{ByLaw, Derived, DurationOver, Number, Quantity, Required, Word};
use super::key::{Key, Kind, key};
use super::usual_range::GRAVITY;
use super::words::{CONTACTS, PRECISIONS};
use crate::case::quantity::{ACCELERATION, FREQUENCY, LENGTH, TIME};

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

pub(super) const OUTPUT: &[Key] = &[
    key(
        "history_interval",
        Kind::Quantity(TIME),
        DurationOver(500.0),
        "Time between the lines of forces.csv.",
    )
    .within(POSITIVE),
    key(
        "field_interval",
        Kind::Quantity(TIME),
        DurationOver(20.0),
        "Time between the field files of the soil.",
    )
    .within(POSITIVE),
    key(
        "filter_cutoff",
        Kind::Quantity(FREQUENCY),
        Derived("a 25th of the rate of the history"),
        "Cut-off frequency of the filtered forces (filtered.csv): what is faster is smoothed away.",
    )
    .within(POSITIVE),
    key(
        "checkpoint_interval",
        Kind::Quantity(TIME),
        Quantity("10 min"),
        "Wall-clock time between checkpoints.",
    )
    .within(POSITIVE),
    key(
        "steady_fraction",
        Kind::Number,
        Number(0.3),
        "Fraction of the run, at its end, over which steady averages are taken.",
    )
    .within(POSITIVE_FRACTION),
];

pub(super) const NUMERICS: &[Key] = &[
    key(
        "courant",
        Kind::Number,
        Number(0.5),
        "Courant number: time step over the time that a wave takes to cross the smallest cell.",
    )
    .within(POSITIVE_FRACTION),
    key(
        "remap_displacement",
        Kind::Number,
        Number(0.1),
        "Displacement in cell widths at which the soil is remapped.",
    )
    .within(POSITIVE_FRACTION),
    key("hourglass", Kind::Number, Number(0.01), "Coefficient of hourglass viscosity.").within(NOT_NEGATIVE),
    key(
        "hourglass_yielding",
        Kind::Number,
        Number(0.1),
        "Fraction of the hourglass viscosity that acts in cells that yield.",
    )
    .within(FRACTION),
    key(
        "bulk_viscosity_linear",
        Kind::Number,
        ByLaw { usual: 0.02, laws: &["tresca", "von-mises"], instead: 0.06 },
        "Linear coefficient b₁ of bulk viscosity.",
    )
    .within(NOT_NEGATIVE),
    key("bulk_viscosity_quadratic", Kind::Number, Number(1.2), "Quadratic coefficient b₂ of bulk viscosity.")
        .within(NOT_NEGATIVE),
    key("contact", Kind::Choice(&CONTACTS), Word("impulse"), "Contact method."),
    key(
        "edge_inset",
        Kind::Number,
        Number(0.5),
        "Distance of contact points from sharp edges, in cell widths.",
    )
    .within(NOT_NEGATIVE),
    key("point_spacing", Kind::Number, Number(0.25), "Spacing of contact points, in cell widths.")
        .within(SPACING),
    key(
        "threads",
        Kind::Count,
        Number(0.0),
        "Threads of each process; 0 for as many as SLURM_CPUS_PER_TASK says, or else OMP_NUM_THREADS, or else one per core that it \
         may use (processes on one machine share its cores).",
    )
    .within(THREADS),
    key(
        "precision",
        Kind::Choice(&PRECISIONS),
        Word("double"),
        "Precision of the soil's fields; single takes two thirds of the time and about half the memory.",
    ),
];
