//! Keys of the grid, and of what it follows.

use crate::key::allowed::{ASPECT, GROWTH, POSITIVE};
use crate::key::words::FOLLOWED;
use input::key::DefaultValue::{Derived, Flag, Number, Ratios, Required, Word};
use input::key::{Key, Kind, key};
use input::quantity::LENGTH;

/// Keys of what the grid follows.
pub(crate) const FOLLOW: &[Key] = &[
    key("body", Kind::Text, Required, "Name of the body."),
    key("axes", Kind::Choice(&FOLLOWED), Word("x"), "Axes along which the grid follows it."),
];

/// Keys of the grid.
pub(crate) const KEYS: &[Key] = &[
    key(
        "cell",
        Kind::Quantity(LENGTH),
        Derived("small enough for the bodies and their sinkage, rounded down"),
        "Cell size h in the fine zone: the smallest width of its cells. Left out, there are some 8 over a body's length, 4 over its width and height, 5 over the sinkage of a free body, 8 over that of one that is held or moved, 8 over the contact of what rolls or is pressed; flat ones (`aspect`) where that needs fewer; none smaller than the longest body over 40. Without bodies it must be given.",
    )
    .within(POSITIVE),
    key(
        "aspect",
        Kind::Ratios,
        Ratios([1.0, 1.0, 1.0]),
        "Widths of the cells in the fine zone along x, y and z, over `cell`; one of them is 1. `[3, 3, 1]` are flat cells, for a body that sinks much less than it is long.",
    )
    .within(ASPECT),
    key(
        "growth",
        Kind::Number,
        Number(1.12),
        "Largest ratio of the widths of neighbouring cells outside the fine zone.",
    )
    .within(GROWTH),
    key(
        "fit",
        Kind::Flag,
        Flag(true),
        "Make cells up to 1.25 times wider or narrower along an axis so that the flat faces of bodies that do not move along it coincide with cell faces.",
    ),
    key("fine_x", Kind::Range(LENGTH), Derived("the bodies' path ± 0.5 body lengths"), "Fine zone along x."),
    key("fine_y", Kind::Range(LENGTH), Derived("the bodies' path ± 0.25 body lengths"), "Fine zone along y."),
    key(
        "fine_z",
        Kind::Range(LENGTH),
        Derived(
            "0.5 body lengths below the bodies' path; 0.25 above the soil, up to 0.5 where a heap is expected",
        ),
        "Fine zone in z.",
    ),
    key(
        "follow",
        Kind::Follow,
        Derived("none: the grid stands still"),
        "A body that the grid follows: it keeps its position in the grid, undisturbed ground enters in front of it and leaves behind. The box then is the one at the start.",
    ),
];
