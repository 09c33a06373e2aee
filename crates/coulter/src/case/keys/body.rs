//! Keys of a rigid body.

use super::key::{Key, Kind, key};
use super::words::{AXES, SHAPES};
use crate::case::quantity::{ANGLE, FORCE, INERTIA, LENGTH, MASS, SPEED, TORQUE, TURN_RATE};

const SLIDE: Kind = Kind::Motion { still: "fixed", speed: SPEED, load: FORCE };
const TURN: Kind = Kind::Motion { still: "locked", speed: TURN_RATE, load: TORQUE };

pub(super) const BODY: &[Key] = &[
    key(
        "shape",
        Kind::Choice(&SHAPES),
        "required",
        "A disc with its axle along y, a rectangular block, a cylinder along any axis, or a sphere.",
    ),
    key(
        "diameter",
        Kind::Quantity(LENGTH),
        "required except for a block",
        "Diameter d (disc, cylinder, sphere).",
    ),
    key("thickness", Kind::Quantity(LENGTH), "required for a disc", "Thickness t along the axle (disc)."),
    key("axis", Kind::Choice(&AXES), "required for a cylinder", "Axis of the cylinder; \"z\": upright."),
    key("length", Kind::Quantity(LENGTH), "required for a cylinder", "Length along its axis (cylinder)."),
    key(
        "size",
        Kind::Vector(LENGTH),
        "required for a block",
        "Edges along x, y, z (block); x, z in plane strain.",
    ),
    key(
        "orientation",
        Kind::Quantity(ANGLE),
        "0 deg",
        "Rotation about y at the start, positive when it tips the top towards +x (block).",
    ),
    key(
        "friction",
        Kind::Friction,
        "required",
        "Coefficient of friction μ against the soil, or \"rough\": no slip.",
    ),
    key(
        "adhesion_factor",
        Kind::Number,
        "no such limit",
        "Frictional traction is at most α s_u, whatever the pressure (tresca); 0 to 1.",
    ),
    key("weight", Kind::Quantity(FORCE), "mass × gravity", "Weight W of the whole body."),
    key(
        "mass",
        Kind::Quantity(MASS),
        "weight / gravity",
        "Mass of the whole body; needed only if it moves freely.",
    ),
    key(
        "axle_inertia",
        Kind::Quantity(INERTIA),
        "that of a solid of this mass",
        "Moment of inertia about the axle.",
    ),
    key("x", Kind::Quantity(LENGTH), "0 m", "Initial position of its centre along x."),
    key("y", Kind::Quantity(LENGTH), "0 m", "Initial position of its centre along y."),
    key("sinkage", Kind::Quantity(LENGTH), "0 m", "Initial depth of its lowest point below the surface."),
    key("forward", SLIDE, "\"fixed\"", "Motion along x, the tow."),
    key("lateral", SLIDE, "\"fixed\"", "Motion along y."),
    key(
        "heave",
        SLIDE,
        "\"fixed\"",
        "Motion along z, upwards; \"free\": under its weight and the force of the soil.",
    ),
    key("spin", TURN, "\"locked\"", "Rotation about the axle, positive when it rolls forward."),
];
