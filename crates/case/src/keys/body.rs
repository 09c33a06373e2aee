//! Keys of a rigid body.

use crate::keys::allowed::{APEX, BEVEL, FRACTION, GROUSERS, IN_THE_RUN, NOT_NEGATIVE, POSITIVE, SLIP, TILT};
use crate::keys::usual::{SPEED as USUAL_SPEED, SURFACE_FRICTION};
use crate::keys::words::{AXES, BEVELS, HOLLOWS, MESH_UNITS, ORIGINS, RIMS, SHAPES};
use input::key::DefaultValue::{Derived, Quantity, Required, Word};
use input::key::{Key, Kind, key};
use input::quantity::{ANGLE, FORCE, INERTIA, LENGTH, MASS, SPEED, TIME, TORQUE, TURN_RATE};

const FIXED: &str = "fixed";
const LOCKED: &str = "locked";
const SLIDE: Kind = Kind::Motion { still: FIXED, way: LENGTH, speed: SPEED, load: FORCE };
const TURN: Kind = Kind::Motion { still: LOCKED, way: ANGLE, speed: TURN_RATE, load: TORQUE };

/// Keys of a motion that is written as a table, `{ speed = "0.2 m/s", ramp = "0.1 s" }`; those of a rotation
/// measure a rate of turning and a torque.
pub(super) const MOTION: &[Key] = &[
    key(
        "speed",
        Kind::Quantity(SPEED),
        Derived("one of speed, load, displacement, table"),
        "Speed after the ramp; for `spin` a rate of turning.",
    )
    .usually(USUAL_SPEED),
    key(
        "load",
        Kind::Quantity(FORCE),
        Derived("one of speed, load, displacement, table"),
        "Load on a free motion; for `spin` a torque.",
    ),
    key(
        "displacement",
        Kind::Quantity(LENGTH),
        Derived("one of speed, load, displacement, table"),
        "Displacement from rest to rest within the ramp; for `spin` an angle.",
    ),
    key(
        "table",
        Kind::Text,
        Derived("one of speed, load, displacement, table"),
        "Table, relative to the folder of the case file, of displacements or speeds over time (docs/tables.md); its header names them \
         with their units: `time [s],displacement [mm]` or `time [s],speed [mm/s]`. Between its lines a displacement is a smooth curve \
         without overshoot, a speed is linear.",
    ),
    key(
        "from",
        Kind::Choice(&ORIGINS),
        Word("zero"),
        "Which time of a table is `start`: its zero, or its `first line`, of a log that counts from elsewhere.",
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
        "How long it takes until speed, load or displacement are reached.",
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
    key(
        "friction",
        Kind::Friction,
        Derived("required except for a frame"),
        "Coefficient of friction μ against the soil, or \"rough\": no slip.",
    )
    .within(NOT_NEGATIVE)
    .usually(SURFACE_FRICTION),
    key(
        "adhesion_factor",
        Kind::Number,
        Derived("1: the strength of the soil"),
        "Frictional traction is at most α s_u, whatever the pressure (tresca).",
    )
    .within(FRACTION),
    key("weight", Kind::Quantity(FORCE), Derived("mass × gravity"), "Weight W of the whole body, in air.")
        .within(POSITIVE),
    key(
        "mass",
        Kind::Quantity(MASS),
        Derived("weight / gravity"),
        "Mass of the whole body; needed only if it moves freely.",
    )
    .within(POSITIVE),
    key(
        "submerged_weight",
        Kind::Quantity(FORCE),
        Derived("weight less buoyancy"),
        "Weight in water W′, instead of `weight` or `mass` (with `[water]`).",
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
        "elevation",
        Kind::Quantity(LENGTH),
        Derived("from the sinkage"),
        "Initial height of its reference point above the surface, instead of `sinkage`.",
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
