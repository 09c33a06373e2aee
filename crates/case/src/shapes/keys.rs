//! Keys that describe a shape, of a body or of a soil body.

use crate::key::allowed::{APEX, BEVEL, GROUSERS, NOT_NEGATIVE, POSITIVE};
use crate::key::words::{AXES, BEVELS, HOLLOWS, MESH_UNITS, RIMS, SHAPES};
use input::key::DefaultValue::{Derived, Quantity, Required, Word};
use input::key::{Key, KeyOf, Kind, Place, key};
use input::quantity::{ANGLE, LENGTH};

/// All keys of shapes. A shape says which of them it has, and where their values lie.
pub(crate) const KEYS: &[Key] = &[
    key(
        "shape",
        Kind::Choice(&SHAPES),
        Required,
        "What it is: a disc or a wheel with its axle along y, a rectangular block, a cylinder along any axis, a sphere, a cone on a shaft with its tip down, an upright blade across the tow, a wedge with its edge in front at the bottom, a mesh: a solid whose surface is in a file, or a frame: mass and motion without a surface.",
    ),
    key(
        "diameter",
        Kind::Quantity(LENGTH),
        Derived("required for a disc, cylinder, sphere, cone, wheel"),
        "Diameter d (disc, cylinder, sphere); of the base (cone); of the rim between the grousers, on which it rolls (wheel).",
    )
    .within(POSITIVE),
    key(
        "thickness",
        Kind::Quantity(LENGTH),
        Derived("required for a disc, wheel, blade"),
        "Thickness t along the axle (disc, wheel), or along x (blade).",
    )
    .within(POSITIVE),
    key("rim", Kind::Choice(&RIMS), Word("square"), "Rim of a disc."),
    key(
        "rim_radius",
        Kind::Quantity(LENGTH),
        Derived("half the thickness"),
        "Radius to which both edges of a rounded rim are rounded (disc).",
    )
    .within(POSITIVE),
    key(
        "bevel_angle",
        Kind::Quantity(ANGLE),
        Derived("required for a bevelled rim; a blade without it is square"),
        "Angle between the bevel and the face that it cuts (disc, blade at its lower end).",
    )
    .within(BEVEL),
    key(
        "bevel",
        Kind::Choice(&BEVELS),
        Derived("\"both\" of a disc, \"back\" of a blade"),
        "Faces that are bevelled: of a disc \"left\" (+y) or \"right\", of a blade \"front\" (+x) or \"back\", or \"both\".",
    ),
    key(
        "edge_thickness",
        Kind::Quantity(LENGTH),
        Quantity("0 m"),
        "Thickness of what the bevel leaves of the rim or the lower end (disc, blade); 0: a knife edge.",
    )
    .within(NOT_NEGATIVE),
    key(
        "concavity",
        Kind::Quantity(LENGTH),
        Derived("none: a flat disc"),
        "Depth c of the hollow of a dished disc, as of a harrow or a plough, below the plane of its edge; its faces are parts of spheres, that of the hollow of radius (d²/4 + c²)/(2c).",
    )
    .within(POSITIVE),
    key("hollow", Kind::Choice(&HOLLOWS), Word("left"), "The hollow side of a dished disc; \"left\": +y."),
    key("cone_angle", Kind::Quantity(ANGLE), Derived("required for a cone"), "Angle at the tip (cone): 60 or 30 deg of penetrometers.")
        .within(APEX),
    key(
        "shaft_diameter",
        Kind::Quantity(LENGTH),
        Derived("diameter"),
        "Diameter of the shaft behind the cone, at most that of its base.",
    )
    .within(POSITIVE),
    key("grousers", Kind::Count, Derived("required for a wheel"), "Number of grousers, evenly spaced; one points straight down.")
        .within(GROUSERS),
    key(
        "grouser_height",
        Kind::Quantity(LENGTH),
        Derived("required for a wheel"),
        "How far the grousers stand out from the rim.",
    )
    .within(POSITIVE),
    key(
        "grouser_thickness",
        Kind::Quantity(LENGTH),
        Derived("required for a wheel"),
        "Thickness of a grouser along the rim; it is as wide as the wheel.",
    )
    .within(POSITIVE),
    key(
        "axis",
        Kind::Choice(&AXES),
        Derived("required for a cylinder"),
        "Axis of the cylinder; \"z\": upright.",
    ),
    key(
        "length",
        Kind::Quantity(LENGTH),
        Derived("required for a cylinder, cone, wedge"),
        "Length along its axis (cylinder), of cone and shaft together (cone), along x (wedge).",
    )
    .within(POSITIVE),
    key(
        "width",
        Kind::Quantity(LENGTH),
        Derived("required for a blade, wedge"),
        "Width along y (blade, wedge).",
    )
    .within(POSITIVE),
    key(
        "height",
        Kind::Quantity(LENGTH),
        Derived("required for a blade, wedge"),
        "Height along z (blade, wedge). The rake of a blade is its `pitch`: 90° plus it from the horizontal, so that −45 deg leans back.",
    )
    .within(POSITIVE),
    key(
        "size",
        Kind::Vector(LENGTH),
        Derived("required for a block"),
        "Edges along x, y, z (block); x, z in plane strain.",
    )
    .within(POSITIVE),
    key(
        "file",
        Kind::Text,
        Derived("required for a mesh"),
        "File with a closed surface of triangles, relative to the folder of the case file: STL, OBJ or PLY (mesh). Its origin is the body's reference point, its y axis the axle.",
    ),
    key(
        "unit",
        Kind::Choice(&MESH_UNITS),
        Derived("that which the file states; required where it states none"),
        "Unit of the coordinates in the file (mesh). It must be that which the file states in a comment or header.",
    ),
];

/// The key of that name.
pub(super) const fn named(name: &str) -> &'static Key {
    let mut n = 0;
    while !KEYS[n].name.as_bytes().eq_ignore_ascii_case(name.as_bytes()) {
        n += 1;
    }
    &KEYS[n]
}

/// The key of that name, and where its value lies in a shape.
pub(super) const fn field<T>(name: &str, place: Place<T>) -> KeyOf<T> {
    KeyOf { key: *named(name), place }
}
