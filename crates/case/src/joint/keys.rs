//! Keys of a joint, and where their values lie.

use super::{Joint, JointKind};
use crate::key::allowed::{FRACTION, NOT_NEGATIVE, POSITIVE};
use crate::key::part;
use crate::key::words::JOINTS;
use input::key::DefaultValue::{Number, Quantity};
use input::key::{Key, KeyOf, Kind, Place, declared};
use input::quantity::{DAMPING, LENGTH, STIFFNESS, TORQUE};

type Field = KeyOf<Joint>;

/// Keys of a joint, and where their values lie.
pub(super) const FIELDS: &[Field] = &[
    Field::new("kind", Kind::Choice(&JOINTS), Place::Elsewhere).means(
        "A hinge, a ball joint or a slider, which let the second body rotate about an axis, rotate about a point, or move along an \
         axis; a spring with a damper, or a cable, which only pulls; contact of their surfaces, which only pushes and rubs.",
    ),
    Field::new("bodies", Kind::NamePair, Place::Elsewhere).means(
        "The two bodies; the first may be \"ground\". By a hinge, a ball joint or a slider the first carries the second.",
    ),
    Field::new("at", Kind::Vector(LENGTH), Place::Elsewhere).derived("the reference point of the second body").means(
        "Where it is at the start: x, y and height above the surface; of a spring or a cable its end at the second body.",
    ),
    Field::new("from", Kind::Vector(LENGTH), Place::Elsewhere)
        .derived("the reference point of the first body")
        .means("The other end of a spring or a cable, at the first body."),
    Field::new("axis", Kind::Ratios, Place::Elsewhere)
        .derived("the axle of the second body (hinge); required (slider)")
        .means("Direction of the axis at the start."),
    Field::new("friction_torque", Kind::Quantity(TORQUE), part!(kind, JointKind::Hinge, friction_torque))
        .default(Quantity("0 N*m"))
        .within(NOT_NEGATIVE)
        .means("Torque of the bearing of a hinge against its rotation."),
    Field::new("drive_torque", Kind::Quantity(TORQUE), part!(kind, JointKind::Hinge, drive_torque))
        .default(Quantity("0 N*m"))
        .means(
            "Torque of a drive of the first body on the second about the axis of a hinge; of a disc or wheel with a positive one drives \
             it forward, a negative one brakes it.",
        ),
    Field::new("stiffness", Kind::Quantity(STIFFNESS), part!(kind, JointKind::Spring, stiffness))
        .derived("required (spring, cable)")
        .within(POSITIVE)
        .means("Force per extension."),
    Field::new("damping", Kind::Quantity(DAMPING), part!(kind, JointKind::Spring, damping))
        .default(Quantity("0 N*s/m"))
        .within(NOT_NEGATIVE)
        .means("Force per rate of extension (spring, cable)."),
    Field::new("length", Kind::Quantity(LENGTH), part!(kind, JointKind::Spring, length))
        .derived("the distance of its ends at the start")
        .within(POSITIVE)
        .means("Length without force (spring, cable)."),
    Field::new("friction", Kind::Number, part!(kind, JointKind::Contact, friction))
        .derived("required (contact)")
        .within(NOT_NEGATIVE)
        .means("Coefficient of friction between the two surfaces."),
    Field::new("restitution", Kind::Number, part!(kind, JointKind::Contact, restitution))
        .default(Number(0.0))
        .within(FRACTION)
        .means("Velocity at which the surfaces part after an impact, over that at which they meet (contact)."),
];

/// Keys of a joint, without the places of their values.
pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);
