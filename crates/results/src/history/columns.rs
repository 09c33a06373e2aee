//! The columns of the history files: name, unit, meaning and value, from which header, lines, reading back
//! and documentation follow.

pub use super::quantities::{Column, FILTERED, FORCES, Source, header};
use super::quantities::{derived, sampled};
use super::rim::RimLine;
use super::{BoundarySample, EnergySample, ForceSample, RutSection, SurfacePoint};

/// Columns of `part_NAME.csv`.
pub const PARTS: &[Column<ForceSample>] = &[
    sampled("time", "s", "time since the start", |s| &mut s.time),
    sampled("force x", "N", "force of the soil on this part of the body, along x", |s| &mut s.force_x),
    sampled("force y", "N", "the same along y", |s| &mut s.force_y),
    sampled("force z", "N", "the same along z", |s| &mut s.force_z),
    sampled("moment x", "N m", "moment about x through the reference point of the part", |s| &mut s.moment_x),
    sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
];

/// Columns of `joint_NAME.csv`.
pub const JOINTS: &[Column<ForceSample>] = &[
    sampled("time", "s", "time since the start", |s| &mut s.time),
    sampled("force x", "N", "force of the first body on the second through the joint, along x", |s| {
        &mut s.force_x
    }),
    sampled("force y", "N", "the same along y", |s| &mut s.force_y),
    sampled("force z", "N", "the same along z", |s| &mut s.force_z),
    derived("force", "N", "its magnitude; of a cable the tension", |s, _| Some(s.force())),
    sampled("moment x", "N m", "moment about x through the joint's point of the second body", |s| {
        &mut s.moment_x
    }),
    sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
    sampled(
        "distance",
        "m",
        "between its points of the two bodies: length of a spring or a cable, displacement of a slider, otherwise 0 but for round-off",
        |s| &mut s.distance,
    ),
];

/// Columns of `energy.csv`.
pub const ENERGY: &[Column<EnergySample>] = &[
    sampled("time", "s", "time since the start", |s| &mut s.time),
    sampled::<EnergySample>("external", "J", "work of loads, drives and gravity, kinetic energy at the start, and elastic energy of soil that entered the domain", |s| &mut s.external).required(),
    sampled::<EnergySample>("kinetic", "J", "kinetic energy of soil and bodies", |s| &mut s.kinetic).required(),
    sampled::<EnergySample>("elastic", "J", "elastic energy of the soil less that at the start", |s| &mut s.elastic)
    .required(),
    sampled::<EnergySample>("plastic", "J", "plastic dissipation", |s| &mut s.plastic).required(),
    sampled("friction", "J", "dissipation by friction on the bodies", |s| &mut s.friction),
    sampled(
        "contact method",
        "J",
        "what the contact method itself stores, dissipates or adds; should be small",
        |s| &mut s.contact,
    ),
    sampled("viscous", "J", "dissipation by bulk viscosity", |s| &mut s.viscous),
    sampled("hourglass", "J", "dissipation by hourglass viscosity", |s| &mut s.hourglass),
    sampled(
        "seepage",
        "J",
        "dissipation by pore water that seeps through the soil; 0 where no pore pressure is computed",
        |s| &mut s.seepage,
    ),
    sampled("remap loss", "J", "kinetic and elastic energy lost in remaps", |s| &mut s.remap_loss),
    derived(
        "closure",
        "-",
        "error of the energy balance: unexplained energy over the external work (over the plastic or the kinetic energy \
         where that is larger)",
        |s, _| Some(s.closure()),
    ),
    sampled::<EnergySample>("volume ratio", "-", "soil volume, less what has entered the domain, over that at the start", |s| &mut s.volume_ratio)
        .required(),
    sampled(
        "elastic compression",
        "-",
        "volume by which the pressure compresses the soil elastically, over the volume at the start; not of sand",
        |s| &mut s.compression,
    ),
    sampled(
        "overdense mass",
        "-",
        "portion of the soil's mass in cells denser than 1.1 times its densest state, compressed elastically",
        |s| &mut s.overdense,
    ),
    sampled(
        "void under soil",
        "-",
        "volume of voids under soil at rest that neither a body nor cohesion carries, over that of soil with a plastic strain above 0.1",
        |s| &mut s.void,
    ),
];

/// Columns of `boundaries.csv`.
pub const BOUNDARIES: &[Column<BoundarySample>] = &[
    sampled("time", "s", "time since the start", |s| &mut s.time),
    sampled(
        "lid area",
        "m^2",
        "area of the lid that soil has reached; 0 where the soil extends up to the lid from the start",
        |s| &mut s.lid_area,
    ),
    sampled("lid force", "N", "force of the soil on that area", |s| &mut s.lid_force),
    sampled(
        "bare wall area",
        "m^2",
        "area of the side walls, without soil at the start, that soil has reached",
        |s| &mut s.wall_area,
    ),
    sampled(
        "stress rise",
        "Pa",
        "largest rise of the normal pressure on floor and side walls above that at rest",
        |s| &mut s.stress_rise,
    ),
];

/// Columns of `ground_left.csv`.
pub const GROUND_LEFT: &[Column<SurfacePoint>] = &[
    sampled("x", "m", "position along x", |s| &mut s.x),
    sampled("y", "m", "position along y", |s| &mut s.y),
    sampled("z", "m", "height of the surface of the soil", |s| &mut s.column.z),
    sampled(
        "compaction",
        "m",
        "volume per area that the soil has lost since the start by becoming denser; negative where it is looser",
        |s| &mut s.column.compaction,
    ),
    sampled("void", "m", "the same of voids below the surface, less that of soil above it", |s| {
        &mut s.column.void
    }),
    sampled("disturbed", "m", "the same of soil with an equivalent plastic strain above 0.1", |s| {
        &mut s.column.disturbed
    }),
    sampled("mixed", "m", "the same of soil with one above 1", |s| &mut s.column.mixed),
    sampled(
        "disturbed to",
        "m",
        "height down to which soil is disturbed; of the surface where none is",
        |s| &mut s.column.disturbed_to,
    ),
];

/// Columns of `height_map.csv`.
pub const HEIGHT_MAP: &[Column<SurfacePoint>] = GROUND_LEFT;

/// Columns of `rut.csv`.
pub const RUT: &[Column<RutSection>] = &[
    sampled("position", "m", "position along the tow: x, of a lateral tow y", |s| &mut s.position),
    sampled("depth", "m", "depth of the deepest point below the undisturbed surface", |s| &mut s.depth),
    sampled(
        "width",
        "m",
        "width between the points at which the surface rises to the undisturbed one",
        |s| &mut s.width,
    ),
    sampled("area", "m^2", "area of the rut: soil displaced per metre", |s| &mut s.area),
    sampled("high berm", "m", "height of the berm on the side of larger y, of a lateral tow larger x", |s| {
        &mut s.high_berm
    }),
    sampled("low berm", "m", "height of the berm on the other side", |s| &mut s.low_berm),
    sampled("berm area", "m^2", "area of both berms", |s| &mut s.berm_area),
    sampled(
        "compaction",
        "m^2",
        "area that the soil has lost by becoming denser; negative where it has become looser",
        |s| &mut s.compaction,
    ),
    sampled("void", "m^2", "area of voids below the surface, less that of soil above it", |s| &mut s.void),
    sampled(
        "disturbed",
        "m^2",
        "area of disturbed soil, with an equivalent plastic strain above 0.1: soil disturbed per metre",
        |s| &mut s.disturbed,
    ),
    sampled("mixed", "m^2", "area of mixed soil, with one above 1", |s| &mut s.mixed),
    sampled(
        "disturbed depth",
        "m",
        "depth below the undisturbed surface down to which soil is disturbed",
        |s| &mut s.disturbed_depth,
    ),
];

/// Columns of `rim.csv`.
pub const RIM: &[Column<RimLine>] = &[
    sampled(
        "angle",
        "rad",
        "polar angle about the axle: 0 straight below, positive towards the front",
        |l| &mut l.angle,
    ),
    sampled("arc", "m", "distance along the outline from straight below, with the same sign", |l| &mut l.arc),
    sampled("x", "m", "middle of the bin, from the reference point", |l| &mut l.x),
    sampled("z", "m", "the same", |l| &mut l.z),
    sampled("area", "m^2", "area of the surface that it represents", |l| &mut l.area),
    sampled("contact", "-", "fraction of area and time in contact", |l| &mut l.contact),
    sampled("normal stress", "Pa", "σ, positive in compression", |l| &mut l.normal_stress),
    sampled(
        "shear stress along",
        "Pa",
        "τ of the soil on the body along the outline; below the body positive forwards",
        |l| &mut l.shear_along,
    ),
    sampled("shear stress lateral", "Pa", "the same along the axle; 0 in a symmetric case", |l| {
        &mut l.shear_lateral
    }),
    sampled("shear stress outward", "Pa", "the same along the axle, away from the mid-plane", |l| {
        &mut l.shear_outward
    }),
    sampled(
        "slip velocity along",
        "m/s",
        "velocity of the body's surface relative to the soil along the outline; empty without contact",
        |l| &mut l.slip_along,
    ),
    sampled("slip velocity lateral", "m/s", "the same along the axle; 0 in a symmetric case", |l| {
        &mut l.slip_lateral
    }),
    sampled("slip velocity outward", "m/s", "the same along the axle, away from the mid-plane", |l| {
        &mut l.slip_outward
    }),
    sampled(
        "mobilised friction",
        "-",
        "friction over its limit μσ (or the adhesion, where that is less), whatever its direction; empty without a limit",
        |l| &mut l.mobilised,
    ),
    sampled(
        "mobilised along",
        "-",
        "its mean along the outline over the limit: τ/(μσ), with its sign",
        |l| &mut l.mobilised_along,
    ),
    sampled("drag", "N", "contribution of the bin to the drag F_H of the whole body", |l| &mut l.drag),
    sampled("vertical", "N", "contribution to the vertical force F_V", |l| &mut l.vertical),
];
