//! Keys of a joint.

use crate::keys::allowed::{NOT_NEGATIVE, POSITIVE};
use crate::keys::words::JOINTS;
use input::key::DefaultValue::{Derived, Quantity, Required};
use input::key::{Key, Kind, key};
use input::quantity::{DAMPING, LENGTH, STIFFNESS, TORQUE};

pub(super) const JOINT: &[Key] = &[
    key(
        "kind",
        Kind::Choice(&JOINTS),
        Required,
        "A hinge, a ball joint or a slider, which let the second body rotate about an axis, rotate about a point, or move along an \
         axis; a spring with a damper, or a cable, which only pulls.",
    ),
    key(
        "bodies",
        Kind::NamePair,
        Required,
        "The two bodies; the first may be \"ground\". By a hinge, a ball joint or a slider the first carries the second.",
    ),
    key(
        "at",
        Kind::Vector(LENGTH),
        Derived("the reference point of the second body"),
        "Where it is at the start: x, y and height above the surface; of a spring or a cable its end at the second body.",
    ),
    key(
        "from",
        Kind::Vector(LENGTH),
        Derived("the reference point of the first body"),
        "The other end of a spring or a cable, at the first body.",
    ),
    key(
        "axis",
        Kind::Ratios,
        Derived("the axle of the second body (hinge); required (slider)"),
        "Direction of the axis at the start.",
    ),
    key(
        "friction_torque",
        Kind::Quantity(TORQUE),
        Quantity("0 N*m"),
        "Torque of the bearing of a hinge against its rotation.",
    )
    .within(NOT_NEGATIVE),
    key(
        "drive_torque",
        Kind::Quantity(TORQUE),
        Quantity("0 N*m"),
        "Torque of a drive of the first body on the second about the axis of a hinge; of a disc or wheel with a positive one drives \
         it forward, a negative one brakes it.",
    ),
    key("stiffness", Kind::Quantity(STIFFNESS), Derived("required (spring, cable)"), "Force per extension.")
        .within(POSITIVE),
    key(
        "damping",
        Kind::Quantity(DAMPING),
        Quantity("0 N*s/m"),
        "Force per rate of extension (spring, cable).",
    )
    .within(NOT_NEGATIVE),
    key(
        "length",
        Kind::Quantity(LENGTH),
        Derived("the distance of its ends at the start"),
        "Length without force (spring, cable).",
    )
    .within(POSITIVE),
];
