//! Every key of a case file, with its kind, default and meaning. Reading, the JSON schema and the documentation all
//! follow from this one table.

use analytic::wheel::{CMU_SAND, TERRAINS};

use super::quantity::{
    ACCELERATION, ANGLE, DENSITY, FORCE, INERTIA, LENGTH, MASS, Measure, SPEED, STRESS, TIME, TORQUE,
    TURN_RATE, UNIT_WEIGHT,
};

/// What a value may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Any text.
    Text,
    /// A number with a unit, as text.
    Quantity(Measure),
    /// A number without a unit.
    Number,
    /// A whole number, 0 or more.
    Count,
    /// `true` or `false`.
    Flag,
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// Low and high end: two quantities.
    Range(Measure),
    /// Two or three quantities.
    Vector(Measure),
    /// Bekker's modulus in N/m^(n+i), whose unit has the sinkage exponent n in it; here is i.
    Modulus(i32),
    /// A number, or the word `rough`.
    Friction,
    /// What the walls at the low and at the high end do.
    WallPair,
    /// How a degree of freedom moves: a word, or a table with a speed or a load.
    Motion {
        /// The word for no motion.
        still: &'static str,
        /// What `speed` measures.
        speed: Measure,
        /// What `load` measures.
        load: Measure,
    },
}

/// One key.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name in its section.
    pub name: &'static str,
    /// What its value may be.
    pub kind: Kind,
    /// What holds if it is left out; `required` if it must not be.
    pub default: &'static str,
    /// What it means.
    pub meaning: &'static str,
}

/// A section and its keys.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// Its name; empty for the top of the file, `body` for `[body.NAME]`.
    pub name: &'static str,
    /// What it is about.
    pub meaning: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

const fn key(name: &'static str, kind: Kind, default: &'static str, meaning: &'static str) -> Key {
    Key { name, kind, default, meaning }
}

/// Soil laws.
pub const LAWS: [&str; 4] = ["mohr-coulomb", "tresca", "von-mises", "elastic"];
/// Body shapes.
pub const SHAPES: [&str; 4] = ["disc", "block", "cylinder", "ball"];
/// Axes of a cylinder.
pub const AXES: [&str; 3] = ["x", "y", "z"];
/// Flow potentials of the frictional law.
pub const POTENTIALS: [&str; 2] = ["mohr-coulomb", "menetrey-willam"];
/// Contact methods.
pub const CONTACTS: [&str; 2] = ["penalty", "impulse"];
/// Precisions of the soil's fields.
pub const PRECISIONS: [&str; 2] = ["double", "single"];
/// What a wall may be.
pub const WALLS: [&str; 2] = ["smooth", "fixed"];
/// Whose factors of shape, depth and inclination the bearing model takes.
pub const FACTORS: [&str; 3] = ["meyerhof", "hansen-vesic", "lyamin"];
/// Soils with published plate constants.
pub const PLATES: [&str; TERRAINS.len() + 1] = {
    let mut names = [CMU_SAND.name; TERRAINS.len() + 1];
    let mut n = 0;
    while n < TERRAINS.len() {
        names[n] = TERRAINS[n].name;
        n += 1;
    }
    names
};
/// Keys of a motion that is written as a table.
pub const MOTION_KEYS: [&str; 5] = ["speed", "load", "start", "ramp", "end"];

const SLIDE: Kind = Kind::Motion { still: "fixed", speed: SPEED, load: FORCE };
const TURN: Kind = Kind::Motion { still: "locked", speed: TURN_RATE, load: TORQUE };

const TOP: &[Key] = &[
    key(
        "name",
        Kind::Text,
        "the name of the file",
        "Name of the results folder: letters, digits, `-` and `_`.",
    ),
    key("title", Kind::Text, "the name", "One line for the report."),
    key(
        "gravity",
        Kind::Quantity(ACCELERATION),
        "9.81 m/s^2",
        "Acceleration of gravity, downwards; may be 0.",
    ),
];

const SOIL: &[Key] = &[
    key(
        "law",
        Kind::Choice(&LAWS),
        "required",
        "Strength: frictional, undrained, that of a metal, or none (elastic).",
    ),
    key(
        "friction_angle",
        Kind::Quantity(ANGLE),
        "required for mohr-coulomb",
        "Friction angle φ, 0 to below 90 deg.",
    ),
    key("dilation_angle", Kind::Quantity(ANGLE), "0 deg", "Dilation angle ψ, 0 to φ (mohr-coulomb)."),
    key("cohesion", Kind::Quantity(STRESS), "0 Pa", "Cohesion c; exactly 0 is fine (mohr-coulomb)."),
    key("tension_limit", Kind::Quantity(STRESS), "0 Pa", "Largest tension, at most c cot φ (mohr-coulomb)."),
    key(
        "flow_potential",
        Kind::Choice(&POTENTIALS),
        "\"mohr-coulomb\"",
        "Where yielding soil flows to: along the pyramid with ψ for φ, or along the smooth potential that Abaqus has (mohr-coulomb).",
    ),
    key(
        "meridional_eccentricity",
        Kind::Number,
        "0.1",
        "How fast the smooth potential nears its asymptote; has no effect without cohesion (menetrey-willam).",
    ),
    key(
        "deviatoric_eccentricity",
        Kind::Number,
        "(3 − sin φ)/(3 + sin φ)",
        "Shape of the smooth potential across the pressure axis: above 0.5, 1 is a circle (menetrey-willam).",
    ),
    key(
        "critical_density",
        Kind::Quantity(DENSITY),
        "none",
        "Soil that is looser than this dilates no more (mohr-coulomb, with dilation_angle).",
    ),
    key(
        "shear_strength",
        Kind::Quantity(STRESS),
        "required for tresca",
        "Undrained shear strength s_u (tresca).",
    ),
    key(
        "yield_stress",
        Kind::Quantity(STRESS),
        "required for von-mises",
        "Stress σ_y at which a bar in plain tension first yields (von-mises).",
    ),
    key(
        "hardening_modulus",
        Kind::Quantity(STRESS),
        "0 Pa",
        "How fast the yield stress grows with the plastic strain, H (von-mises).",
    ),
    key(
        "unit_weight",
        Kind::Quantity(UNIT_WEIGHT),
        "density × gravity",
        "Unit weight γ; 0 for weightless soil.",
    ),
    key(
        "density",
        Kind::Quantity(DENSITY),
        "unit_weight / gravity",
        "Density ρ, which gives the soil its inertia.",
    ),
    key("young_modulus", Kind::Quantity(STRESS), "required", "Young's modulus E."),
    key("poisson_ratio", Kind::Number, "0.3", "Poisson's ratio ν, 0 to below 0.5."),
    key(
        "rest_pressure_ratio",
        Kind::Number,
        "1 − sin φ (Jaky 1944); else ν/(1 − ν)",
        "Horizontal over vertical stress at the start, K₀.",
    ),
];

const GROUND: &[Key] = &[
    key("surface", Kind::Quantity(LENGTH), "0 m", "Height of the soil's level surface."),
    key(
        "x",
        Kind::Range(LENGTH),
        "the whole domain",
        "Where along x there is soil, e.g. a bank in front of a wall.",
    ),
    key("y", Kind::Range(LENGTH), "the whole domain", "Where along y there is soil."),
    key(
        "radius",
        Kind::Quantity(LENGTH),
        "none",
        "Soil only so near to the axis x = y = 0: a round column or bar.",
    ),
    key(
        "velocity",
        Kind::Vector(SPEED),
        "at rest",
        "Velocity of the soil at the start along x, y, z; along x, z in plane strain.",
    ),
    key(
        "overburden",
        Kind::Quantity(STRESS),
        "0 Pa",
        "Vertical pressure of the lid on the soil, which must reach up to it: soil at depth.",
    ),
];

const DOMAIN: &[Key] = &[
    key(
        "x",
        Kind::Range(LENGTH),
        "the bodies' path and 1.5 body lengths at each end, ahead more where the failing soil needs it",
        "The box along the tow; from 0 if symmetric_x.",
    ),
    key(
        "y",
        Kind::Range(LENGTH),
        "the bodies and 1.5 body lengths at each side, more where the failing soil needs it",
        "The box across; from 0 if symmetric.",
    ),
    key(
        "z",
        Kind::Range(LENGTH),
        "1.25 body lengths of soil, 0.4 of headroom, more where the heap of soil needs it",
        "The box in height: floor and lid.",
    ),
    key("symmetric", Kind::Flag, "false", "Model only y ≥ 0, y = 0 being a plane of symmetry."),
    key("symmetric_x", Kind::Flag, "false", "Model only x ≥ 0, x = 0 being a plane of symmetry."),
    key("plane_strain", Kind::Flag, "false", "Model a slab that is one cell thick in y."),
    key("x_walls", Kind::WallPair, "[\"smooth\", \"smooth\"]", "Walls at the low and the high end of x."),
    key("y_walls", Kind::WallPair, "[\"smooth\", \"smooth\"]", "Walls at the low and the high end of y."),
    key("z_walls", Kind::WallPair, "[\"fixed\", \"smooth\"]", "Floor and lid."),
];

const GRID: &[Key] = &[
    key("cell", Kind::Quantity(LENGTH), "required", "Cell size h in the fine zone."),
    key(
        "growth",
        Kind::Number,
        "1.12",
        "Largest ratio of neighbouring cells outside the fine zone, 1 to 1.5.",
    ),
    key(
        "fit",
        Kind::Flag,
        "true",
        "Make cells up to 1.25 times wider or narrower along an axis so that the flat faces of bodies that do not move along it lie between cells.",
    ),
    key("fine_x", Kind::Range(LENGTH), "the bodies' path ± 0.5 body lengths", "Fine zone along x."),
    key("fine_y", Kind::Range(LENGTH), "the bodies' path ± 0.25 body lengths", "Fine zone along y."),
    key(
        "fine_z",
        Kind::Range(LENGTH),
        "0.5 body lengths below the bodies' path; 0.25 above the soil, up to 0.5 where a heap is expected",
        "Fine zone in z.",
    ),
];

const BODY: &[Key] = &[
    key(
        "shape",
        Kind::Choice(&SHAPES),
        "required",
        "A disc with its axle along y, a rectangular block, a cylinder along any axis, or a ball.",
    ),
    key("diameter", Kind::Quantity(LENGTH), "required but for a block", "Diameter d (disc, cylinder, ball)."),
    key("thickness", Kind::Quantity(LENGTH), "required for a disc", "Thickness t along the axle (disc)."),
    key(
        "axis",
        Kind::Choice(&AXES),
        "required for a cylinder",
        "Along what the cylinder lies; \"z\": upright.",
    ),
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
        "Turned about y at the start, its top towards x if positive (block).",
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
        "Friction is at most α s_u, whatever the pressure (tresca); 0 to 1.",
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
    key("x", Kind::Quantity(LENGTH), "0 m", "Where its middle starts along x."),
    key("y", Kind::Quantity(LENGTH), "0 m", "Where its middle starts along y."),
    key("sinkage", Kind::Quantity(LENGTH), "0 m", "How deep its lowest point starts below the surface."),
    key("forward", SLIDE, "\"fixed\"", "Motion along x, the tow."),
    key("lateral", SLIDE, "\"fixed\"", "Motion along y."),
    key(
        "heave",
        SLIDE,
        "\"fixed\"",
        "Motion along z, upwards; \"free\": as its weight and the soil make it.",
    ),
    key("spin", TURN, "\"locked\"", "Turning about the axle, positive when it rolls forward."),
];

const RUN: &[Key] = &[
    key("duration", Kind::Quantity(TIME), "this or tow_distance", "How long to run."),
    key(
        "tow_distance",
        Kind::Quantity(LENGTH),
        "this or duration",
        "Run until every towed body has gone so far.",
    ),
];

const OUTPUT: &[Key] = &[
    key("history_interval", Kind::Quantity(TIME), "duration / 500", "Time between the lines of forces.csv."),
    key("field_interval", Kind::Quantity(TIME), "duration / 20", "Time between the pictures of the soil."),
    key(
        "checkpoint_interval",
        Kind::Quantity(TIME),
        "10 min",
        "Time between checkpoints, by the clock on the wall.",
    ),
    key("steady_share", Kind::Number, "0.3", "Share of the run's end that steady averages are taken over."),
];

const NUMERICS: &[Key] = &[
    key("courant", Kind::Number, "0.5", "Time step over the time in which a wave crosses the smallest cell."),
    key(
        "remap_displacement",
        Kind::Number,
        "0.1",
        "Displacement in cell widths at which the soil is remapped.",
    ),
    key("hourglass", Kind::Number, "0.01", "Coefficient of hourglass viscosity."),
    key("hourglass_yielding", Kind::Number, "1", "Share of it that acts in cells that yield, 0 to 1."),
    key(
        "bulk_viscosity_linear",
        Kind::Number,
        "0.02; tresca and von-mises 0.06",
        "Linear coefficient b₁ of bulk viscosity.",
    ),
    key("bulk_viscosity_quadratic", Kind::Number, "1.2", "Quadratic coefficient b₂ of bulk viscosity."),
    key("contact", Kind::Choice(&CONTACTS), "\"impulse\"", "Contact method."),
    key("edge_inset", Kind::Number, "0.5", "Distance of contact points from sharp edges, in cell widths."),
    key("point_spacing", Kind::Number, "0.25", "Spacing of contact points, in cell widths."),
    key("threads", Kind::Count, "0", "Threads, at most 64; 0 for one per core."),
    key(
        "precision",
        Kind::Choice(&PRECISIONS),
        "\"double\"",
        "Precision of the soil's fields; single takes two thirds of the time and about half the memory.",
    ),
];

const FORECAST: &[Key] = &[
    key(
        "plate",
        Kind::Choice(&PLATES),
        "none",
        "Soil whose published plate constants n, k_c, k_φ and K are taken (Bekker, Wong–Reece).",
    ),
    key("plate_exponent", Kind::Number, "none", "Sinkage exponent n of p = (k_c/b + k_φ) zⁿ, 0.05 to 2.5."),
    key("plate_cohesive", Kind::Modulus(1), "none", "Bekker's cohesive modulus k_c."),
    key("plate_frictional", Kind::Modulus(2), "none", "Bekker's frictional modulus k_φ."),
    key(
        "shear_displacement",
        Kind::Quantity(LENGTH),
        "that of `plate`; otherwise 15 mm (sand: 10 to 25 mm)",
        "Janosi and Hanamoto's shear displacement modulus K (Wong–Reece).",
    ),
    key("cone_index", Kind::Quantity(STRESS), "none", "Cone index CI (Wismer–Luth, Brixius)."),
    key(
        "plate_stiffness",
        Kind::Quantity(UNIT_WEIGHT),
        "that of 3D-RFT",
        "Pressure over depth under a level plate pushed down (2-D RFT).",
    ),
    key("heap", Kind::Number, "0", "Share χ of the soil swept aside that heaps up before the disc, 0 to 1."),
    key(
        "backfill",
        Kind::Quantity(ANGLE),
        "0 deg",
        "Rise β of the ground before the disc, -10 to 25 deg (PW).",
    ),
    key("factors", Kind::Choice(&FACTORS), "\"meyerhof\"", "Factors of shape, depth and inclination (BC)."),
];

const fn section(name: &'static str, meaning: &'static str, keys: &'static [Key]) -> Section {
    Section { name, meaning, keys }
}

/// All sections.
pub const SECTIONS: [Section; 10] = [
    section("", "At the top of the file, before any section.", TOP),
    section("soil", "The soil.", SOIL),
    section("ground", "Where soil is at the start.", GROUND),
    section("domain", "The box that is modelled.", DOMAIN),
    section("grid", "Cell sizes.", GRID),
    section("body", "A rigid body, `[body.NAME]`; any number of them.", BODY),
    section("run", "How long to run.", RUN),
    section("output", "What to write, and how often.", OUTPUT),
    section("numerics", "Parameters of the method.", NUMERICS),
    section("forecast", "For `coulter forecast` alone; `coulter run` takes no notice of it.", FORECAST),
];

/// The section of that name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Section> {
    SECTIONS.iter().find(|s| s.name == name)
}
