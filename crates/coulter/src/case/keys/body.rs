//! Keys of a rigid body.

use super::allowed_range::{FRACTION, IN_THE_RUN, NOT_NEGATIVE, POSITIVE, SLIP, TILT};
use super::default_value::DefaultValue::{Derived, Quantity, Required, Word};
use super::key::{Key, Kind, key};
use super::words::{AXES, MESH_UNITS, SHAPES};
use crate::case::quantity::{ANGLE, FORCE, INERTIA, LENGTH, MASS, SPEED, TIME, TORQUE, TURN_RATE};

const FIXED: &str = "fixed";
const LOCKED: &str = "locked";
const SLIDE: Kind = Kind::Motion { still: FIXED, speed: SPEED, load: FORCE };
const TURN: Kind = Kind::Motion { still: LOCKED, speed: TURN_RATE, load: TORQUE };

/// Keys of a motion that is written as a table, `{ speed = "0.2 m/s", ramp = "0.1 s" }`; those of a rotation measure a rate
/// of turning and a torque.
pub(super) const MOTION: &[Key] = &[
    key(
        "speed",
        Kind::Quantity(SPEED),
        Derived("this or load"),
        "Speed after the ramp; for `spin` a rate of turning.",
    ),
    key(
        "load",
        Kind::Quantity(FORCE),
        Derived("this or speed"),
        "Load on a free motion; for `spin` a torque.",
    ),
    key(
        "slip",
        Kind::Number,
        Derived("this, speed or load"),
        "Slip of a rolling body, instead of the rate of turning; for `spin` only: −1 locked, 0 rolling, above 0 driven. Its times are those of `forward`.",
    )
    .within(SLIP),
    key("start", Kind::Quantity(TIME), Quantity("0 s"), "When the ramp begins.").within(IN_THE_RUN),
    key(
        "ramp",
        Kind::Quantity(TIME),
        Quantity("0.1 s"),
        "How long it takes until speed or load are reached.",
    )
    .within(IN_THE_RUN),
    key("end", Kind::Quantity(TIME), Derived("never"), "When a ramp back to rest begins; of a speed only.")
        .within(IN_THE_RUN),
];

pub(super) const BODY: &[Key] = &[
    key(
        "shape",
        Kind::Choice(&SHAPES),
        Required,
        "A disc with its axle along y, a rectangular block, a cylinder along any axis, a sphere, or a mesh: a solid whose surface is in a file.",
    ),
    key(
        "diameter",
        Kind::Quantity(LENGTH),
        Derived("required for a disc, a cylinder and a sphere"),
        "Diameter d (disc, cylinder, sphere).",
    )
    .within(POSITIVE),
    key(
        "thickness",
        Kind::Quantity(LENGTH),
        Derived("required for a disc"),
        "Thickness t along the axle (disc).",
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
        Derived("required for a cylinder"),
        "Length along its axis (cylinder).",
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
        Derived("required for a mesh"),
        "Unit of the coordinates in the file (mesh).",
    ),
    key(
        "friction",
        Kind::Friction,
        Required,
        "Coefficient of friction μ against the soil, or \"rough\": no slip.",
    )
    .within(NOT_NEGATIVE),
    key(
        "adhesion_factor",
        Kind::Number,
        Derived("no such limit"),
        "Frictional traction is at most α s_u, whatever the pressure (tresca).",
    )
    .within(FRACTION),
    key("weight", Kind::Quantity(FORCE), Derived("mass × gravity"), "Weight W of the whole body.")
        .within(POSITIVE),
    key(
        "mass",
        Kind::Quantity(MASS),
        Derived("weight / gravity"),
        "Mass of the whole body; needed only if it moves freely.",
    )
    .within(POSITIVE),
    key(
        "axle_inertia",
        Kind::Quantity(INERTIA),
        Derived("that of a solid of this mass"),
        "Moment of inertia about the axle.",
    )
    .within(POSITIVE),
    key("x", Kind::Quantity(LENGTH), Quantity("0 m"), "Initial position of its centre along x."),
    key("y", Kind::Quantity(LENGTH), Quantity("0 m"), "Initial position of its centre along y."),
    key(
        "sinkage",
        Kind::Quantity(LENGTH),
        Quantity("0 m"),
        "Initial depth of its lowest point below the surface.",
    ),
    key(
        "yaw",
        Kind::Quantity(ANGLE),
        Quantity("0 deg"),
        "Rotation about z at the start, positive when it turns the front (+x) to the left (+y); the last of the three.",
    ),
    key(
        "tilt",
        Kind::Quantity(ANGLE),
        Quantity("0 deg"),
        "Rotation about x at the start, positive when it lifts the left end (+y) of the axle; before yaw.",
    )
    .within(TILT),
    key(
        "pitch",
        Kind::Quantity(ANGLE),
        Quantity("0 deg"),
        "Rotation about y, the axle, at the start, positive when it tips the top forwards (+x); before tilt and yaw.",
    ),
    key("forward", SLIDE, Word(FIXED), "Motion along x, the tow."),
    key("lateral", SLIDE, Word(FIXED), "Motion along y."),
    key(
        "heave",
        SLIDE,
        Word(FIXED),
        "Motion along z, upwards; \"free\": under its weight and the force of the soil.",
    ),
    key("yaw_motion", TURN, Word(LOCKED), "Rotation about z; its speed and load have the sign of `yaw`."),
    key(
        "tilt_motion",
        TURN,
        Word(LOCKED),
        "Rotation about the horizontal axis across the axle; its speed and load have the sign of `tilt`.",
    ),
    key("spin", TURN, Word(LOCKED), "Rotation about the axle, positive when it rolls forward."),
];
