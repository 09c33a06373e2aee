//! Keys of a layer, of the ground, of the box round it and of the grid.

use crate::keys::allowed::{ASPECT, GROWTH, NOT_NEGATIVE, POSITIVE, SLOPE};
use crate::keys::words::FOLLOWED;
use crate::soil::KEYS as SOIL;
use input::key::DefaultValue::{Derived, Flag, Number, Quantity, Ratios, Required, Walls, Word};
use input::key::joined;
use input::key::{Key, Kind, key};
use input::quantity::{ANGLE, LENGTH, SPEED, STRESS};

/// Keys of a layer: its depth, and those of a soil.
pub(super) const LAYER: &[Key] = &joined::<{ 1 + SOIL.len() }>(&[&[TOP], SOIL]);

const TOP: Key =
    key("top", Kind::Quantity(LENGTH), Required, "Depth of the top of the layer below the surface.")
        .within(POSITIVE);

pub(super) const GROUND: &[Key] = &[
    key("surface", Kind::Quantity(LENGTH), Quantity("0 m"), "Height of the level soil surface; of uneven ground that over which it rises and falls. Sinkages and depths count from it."),
    key("slope", Kind::Quantity(ANGLE), Quantity("0 deg"), "Angle of the slope along x, uphill positive: x and y lie in the surface, z is normal to it, and gravity is tilted.").within(SLOPE),
    key("cross_slope", Kind::Quantity(ANGLE), Quantity("0 deg"), "The same along y.").within(SLOPE),
    key(
        "x",
        Kind::Range(LENGTH),
        Derived("the whole domain"),
        "Where there is soil along x, e.g. a bank in front of a wall.",
    ),
    key("y", Kind::Range(LENGTH), Derived("the whole domain"), "Where there is soil along y."),
    key(
        "radius",
        Kind::Quantity(LENGTH),
        Derived("none"),
        "Soil only within this distance of the axis x = y = 0: a round column or bar.",
    )
    .within(POSITIVE),
    key(
        "velocity",
        Kind::Vector(SPEED),
        Derived("at rest"),
        "Initial velocity of the soil along x, y, z; along x, z in plane strain.",
    ),
    key(
        "overburden",
        Kind::Quantity(STRESS),
        Quantity("0 Pa"),
        "Vertical pressure of the lid on the soil, which must reach up to the lid: soil at depth.",
    )
    .within(NOT_NEGATIVE),
];

pub(super) const DOMAIN: &[Key] = &[
    key(
        "x",
        Kind::Range(LENGTH),
        Derived(
            "the bodies' path and 1.5 body lengths at each end, more ahead where the failing soil needs it",
        ),
        "The box along the tow; from 0 if symmetric_x.",
    ),
    key(
        "y",
        Kind::Range(LENGTH),
        Derived("the bodies and 1.5 body lengths at each side, more where the failing soil needs it"),
        "The box across the tow; from 0 if symmetric.",
    ),
    key(
        "z",
        Kind::Range(LENGTH),
        Derived(
            "1.25 body lengths of soil (1.9 where nothing is towed), 0.4 of headroom, more where the heap of soil needs it",
        ),
        "The box in height: floor and lid.",
    ),
    key("symmetric", Kind::Flag, Flag(false), "Model only y ≥ 0; y = 0 is a plane of symmetry."),
    key("symmetric_x", Kind::Flag, Flag(false), "Model only x ≥ 0; x = 0 is a plane of symmetry."),
    key(
        "plane_strain",
        Kind::Flag,
        Flag(false),
        "Model a slab that is one cell thick in y; weights, masses, loads and forces are per metre of width.",
    ),
    key(
        "x_walls",
        Kind::WallPair,
        Walls(["smooth", "smooth"]),
        "Walls at the low and the high end of x; `fixed` by default where ground.slope is given, `pressure` for none: the ground beyond bears \
         its stress at rest.",
    ),
    key(
        "y_walls",
        Kind::WallPair,
        Walls(["smooth", "smooth"]),
        "Walls at the low and the high end of y; `fixed` by default where ground.cross_slope is given, `pressure` as along x.",
    ),
    key(
        "z_walls",
        Kind::WallPair,
        Walls(["fixed", "smooth"]),
        "Floor and lid; a `pressure` lid keeps ground.overburden however the soil rises.",
    ),
];

/// Keys of what the grid follows.
pub(super) const FOLLOW: &[Key] = &[
    key("body", Kind::Text, Required, "Name of the body."),
    key("axes", Kind::Choice(&FOLLOWED), Word("x"), "Axes along which the grid follows it."),
];

pub(super) const GRID: &[Key] = &[
    key("cell", Kind::Quantity(LENGTH), Required, "Cell size h in the fine zone: the smallest width of its cells.").within(POSITIVE),
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
