//! Keys of a rigid body.

use super::Body;
use crate::key::allowed::{FRACTION, NOT_NEGATIVE, POSITIVE, TILT};
use crate::key::usual::SURFACE_FRICTION;
use crate::shapes::KEYS as SHAPE;
use input::key::DefaultValue::{Derived, Quantity, Word};
use input::key::{Key, KeyOf, Kind, Place, count, declared, joined, key};
use input::quantity::{ANGLE, FORCE, INERTIA, LENGTH, MASS, SPEED, TORQUE, TURN_RATE};

const FIXED: &str = "fixed";
const LOCKED: &str = "locked";
const SLIDE: Kind = Kind::Motion { still: FIXED, way: LENGTH, speed: SPEED, load: FORCE };
const TURN: Kind = Kind::Motion { still: LOCKED, way: ANGLE, speed: TURN_RATE, load: TORQUE };

type Field = KeyOf<Body>;

/// Keys of a body but for its shape and its motions, and where their values lie.
pub(super) const FIELDS: &[Field] = &[
    Field::new("friction", Kind::Friction, Place::Derived(|body| bounded(&mut body.friction)))
        .derived("required except for a frame")
        .within(NOT_NEGATIVE)
        .usually(SURFACE_FRICTION)
        .means("Coefficient of friction μ against the soil, or \"rough\": no slip."),
    Field::new("adhesion_factor", Kind::Number, Place::Derived(|body| bounded(&mut body.adhesion_factor)))
        .derived("1: the strength of the soil")
        .within(FRACTION)
        .means("Frictional traction is at most α s_u, whatever the pressure (tresca)."),
    Field::new("weight", Kind::Quantity(FORCE), Place::Elsewhere)
        .derived("mass × gravity")
        .within(POSITIVE)
        .means("Weight W of the whole body, in air."),
    Field::new("mass", Kind::Quantity(MASS), Place::Derived(|body| bounded(&mut body.mass)))
        .derived("weight / gravity")
        .within(POSITIVE)
        .means("Mass of the whole body; needed only if it moves freely."),
    Field::new("submerged_weight", Kind::Quantity(FORCE), Place::Elsewhere)
        .derived("weight less buoyancy")
        .within(POSITIVE)
        .means("Weight in water W′, instead of `weight` or `mass` (with `[water]`)."),
    Field::new("axle_inertia", Kind::Quantity(INERTIA), Place::Derived(|body| bounded(&mut body.axle_inertia)))
        .derived("that of a solid of this mass")
        .within(POSITIVE)
        .means("Moment of inertia about the axle."),
    Field::new("x", Kind::Quantity(LENGTH), Place::Derived(|body| Some(&mut body.position.x)))
        .default(Quantity("0 m"))
        .means("Initial position of its centre along x."),
    Field::new("y", Kind::Quantity(LENGTH), Place::Derived(|body| Some(&mut body.position.y)))
        .default(Quantity("0 m"))
        .means("Initial position of its centre along y."),
    Field::new("sinkage", Kind::Quantity(LENGTH), Place::Elsewhere)
        .default(Quantity("0 m"))
        .means("Initial depth of its lowest point below the surface."),
    Field::new("elevation", Kind::Quantity(LENGTH), Place::Elsewhere)
        .derived("from the sinkage")
        .means("Initial height of its reference point above the surface, instead of `sinkage`."),
    Field::new("yaw", Kind::Quantity(ANGLE), Place::Derived(|body| Some(&mut body.attitude.yaw)))
        .default(Quantity("0 deg"))
        .means(
            "Rotation about z at the start, positive when it turns the front (+x) to the left (+y); the last of the three.",
        ),
    Field::new("tilt", Kind::Quantity(ANGLE), Place::Derived(|body| Some(&mut body.attitude.tilt)))
        .default(Quantity("0 deg"))
        .within(TILT)
        .means("Rotation about x at the start, positive when it lifts the left end (+y) of the axle; before yaw."),
    Field::new("pitch", Kind::Quantity(ANGLE), Place::Derived(|body| Some(&mut body.attitude.pitch)))
        .default(Quantity("0 deg"))
        .means(
            "Rotation about y, the axle, at the start, positive when it tips the top forwards (+x); before tilt and yaw.",
        ),
];

const MOTION: &[Key] = &[
    key(
        "welded_to",
        Kind::Text,
        Derived("none"),
        "Name of the body with which this one moves as one rigid body; it then has no motions of its own. They may share faces.",
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

/// A number that may be infinite, and then is not to be in a range.
fn bounded(number: &mut f64) -> Option<&mut f64> {
    Some(number).filter(|number| **number != f64::INFINITY)
}

const LISTS: &[&[Key]] = &[SHAPE, &declared::<_, { FIELDS.len() }>(FIELDS), MOTION];

/// All keys of a body: those of its shape first.
pub(crate) const KEYS: &[Key] = &joined::<{ count(LISTS) }>(LISTS);
