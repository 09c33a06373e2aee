//! The columns of the history files: name, unit, meaning and value, from which header, lines, reading back and
//! documentation follow.

use super::reference::Reference;
use super::rim::RimLine;
use super::{BodySample, BoundarySample, EnergySample, ForceSample, RutSection, SurfacePoint};

/// A column of a history file.
#[derive(Debug)]
pub struct Column<S: 'static> {
    /// Its name, without the unit.
    pub name: &'static str,
    /// Its unit; `-` for a number without one.
    pub unit: &'static str,
    /// What it is, for the documentation.
    pub meaning: &'static str,
    /// Where its values come from.
    pub source: Source<S>,
    /// Whether every line of a sound history has a finite number here.
    pub is_required: bool,
}

/// Where the values of a column come from.
#[derive(Debug)]
pub enum Source<S: 'static> {
    /// A number of the sample; reading the file back fills it.
    Sampled(fn(&mut S) -> &mut f64),
    /// A number that follows from the sample and the reference quantities of its body; none where it is not defined.
    Derived(fn(&S, &Reference) -> Option<f64>),
}

impl<S: Copy> Column<S> {
    const fn sampled(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        number: fn(&mut S) -> &mut f64,
    ) -> Self {
        Self { name, unit, meaning, source: Source::Sampled(number), is_required: false }
    }

    const fn derived(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        number: fn(&S, &Reference) -> Option<f64>,
    ) -> Self {
        Self { name, unit, meaning, source: Source::Derived(number), is_required: false }
    }

    const fn required(mut self) -> Self {
        self.is_required = true;
        self
    }

    /// Its header: name and unit.
    #[must_use]
    pub fn header(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }

    /// Its value in a line; not-a-number where it is not defined.
    #[must_use]
    pub fn value(&self, sample: &S, reference: &Reference) -> f64 {
        match self.source {
            Source::Sampled(number) => *number(&mut { *sample }),
            Source::Derived(number) => number(sample, reference).unwrap_or(f64::NAN),
        }
    }
}

/// The header line of a file.
#[must_use]
pub fn header<S: Copy>(columns: &[Column<S>]) -> String {
    columns.iter().map(Column::header).collect::<Vec<_>>().join(",")
}

type BodyColumn = Column<BodySample>;
type EnergyColumn = Column<EnergySample>;
type RimColumn = Column<RimLine>;

/// Columns of `forces.csv`.
pub const FORCES: &[Column<BodySample>] = &[
    BodyColumn::sampled("time", "s", "time since the start", |s| &mut s.time),
    BodyColumn::sampled(
        "displacement u",
        "m",
        "distance the reference point has travelled along the tow since the start",
        |s| &mut s.displacement,
    )
    .required(),
    BodyColumn::sampled(
        "sinkage z",
        "m",
        "depth of the body's lowest point below the undisturbed surface, positive downwards",
        |s| &mut s.sinkage,
    )
    .required(),
    BodyColumn::sampled("drag F_H", "N", "horizontal force against the tow", |s| &mut s.drag).required(),
    BodyColumn::sampled("vertical F_V", "N", "vertical force, positive upwards", |s| &mut s.vertical)
        .required(),
    BodyColumn::sampled(
        "lateral",
        "N",
        "force across the tow, to the left positive; 0 in a symmetric case",
        |s| &mut s.lateral,
    )
    .required(),
    BodyColumn::sampled(
        "axle torque",
        "N m",
        "torque about the axle, positive when it makes the body roll forward",
        |s| &mut s.axle_torque,
    )
    .required(),
    BodyColumn::sampled("rotation", "rad", "angle of rotation Ω about the axle", |s| &mut s.rotation),
    BodyColumn::sampled("spin", "rad/s", "its rate ω", |s| &mut s.spin),
    BodyColumn::derived(
        "turn ratio",
        "-",
        "ω r / v with the rolling speed v (below); empty at rest and for a body that cannot roll",
        |s, reference| reference.turn_ratio_of(s),
    ),
    BodyColumn::sampled("normal drag", "N", "drag due to the pressure normal to the surface", |s| {
        &mut s.drag_normal
    }),
    BodyColumn::derived("friction drag", "N", "drag due to friction", |s, _| Some(s.drag - s.drag_normal)),
    BodyColumn::sampled(
        "normal vertical",
        "N",
        "vertical force due to the pressure normal to the surface",
        |s| &mut s.vertical_normal,
    ),
    BodyColumn::derived("friction vertical", "N", "vertical force due to friction", |s, _| {
        Some(s.vertical - s.vertical_normal)
    }),
    BodyColumn::sampled(
        "leak",
        "m^3",
        "soil volume inside the body: in the cells that it fills, and what finds no space in those that it cuts",
        |s| &mut s.leaked_volume,
    ),
    BodyColumn::sampled("embedded", "m^3", "volume of the body below the undisturbed surface", |s| {
        &mut s.embedded_volume
    }),
    BodyColumn::sampled("speed v", "m/s", "velocity along the tow", |s| &mut s.speed),
    BodyColumn::sampled("heave speed", "m/s", "velocity upwards", |s| &mut s.heave_speed),
    BodyColumn::sampled(
        "rolling speed",
        "m/s",
        "velocity in the direction in which the body rolls: level, and across its axle",
        |s| &mut s.rolling_speed,
    ),
    BodyColumn::sampled(
        "lateral displacement",
        "m",
        "distance travelled across the tow since the start, to the left",
        |s| &mut s.lateral_displacement,
    ),
    BodyColumn::sampled("yaw", "rad", "rotation of the axle about z, positive to the left", |s| &mut s.yaw),
    BodyColumn::sampled(
        "tilt",
        "rad",
        "inclination of the axle, positive when its left end is raised",
        |s| &mut s.tilt,
    ),
    BodyColumn::sampled("moment x", "N m", "moment of the soil about x through the reference point", |s| {
        &mut s.moment_x
    }),
    BodyColumn::sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    BodyColumn::sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
    BodyColumn::sampled(
        "water drag",
        "N",
        "drag of the water against the tow, ½ρC_dA v²; not part of the drag F_H, which is that of the soil",
        |s| &mut s.water_drag,
    ),
    BodyColumn::sampled(
        "pore pressure drag",
        "N",
        "portion of the drag F_H that excess pore pressure exerts on the body; 0 where none is computed",
        |s| &mut s.pore_drag,
    ),
    BodyColumn::sampled(
        "pore pressure vertical",
        "N",
        "the same of the vertical force F_V; negative where suction holds the body down",
        |s| &mut s.pore_vertical,
    ),
    BodyColumn::derived("Z", "-", "z/d", |s, reference| reference.length_group(s.sinkage)),
    BodyColumn::derived("u_bar", "-", "u/d", |s, reference| reference.length_group(s.displacement)),
    BodyColumn::derived("F_H_bar", "-", "F_H/(γ t d²); empty for weightless soil", |s, reference| {
        reference.force_group(s.drag)
    }),
    BodyColumn::derived("F_V_bar", "-", "F_V/(γ t d²); empty for weightless soil", |s, reference| {
        reference.force_group(s.vertical)
    }),
];

/// Columns of `part_NAME.csv`.
pub const PARTS: &[Column<ForceSample>] = &[
    Column::sampled("time", "s", "time since the start", |s| &mut s.time),
    Column::sampled("force x", "N", "force of the soil on this part of the body, along x", |s| {
        &mut s.force_x
    }),
    Column::sampled("force y", "N", "the same along y", |s| &mut s.force_y),
    Column::sampled("force z", "N", "the same along z", |s| &mut s.force_z),
    Column::sampled("moment x", "N m", "moment about x through the reference point of the part", |s| {
        &mut s.moment_x
    }),
    Column::sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    Column::sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
];

/// Columns of `joint_NAME.csv`.
pub const JOINTS: &[Column<ForceSample>] = &[
    Column::sampled("time", "s", "time since the start", |s| &mut s.time),
    Column::sampled(
        "force x",
        "N",
        "force of the first body on the second through the joint, along x",
        |s| &mut s.force_x,
    ),
    Column::sampled("force y", "N", "the same along y", |s| &mut s.force_y),
    Column::sampled("force z", "N", "the same along z", |s| &mut s.force_z),
    Column::derived("force", "N", "its magnitude; of a cable the tension", |s, _| Some(s.force())),
    Column::sampled("moment x", "N m", "moment about x through the joint's point of the second body", |s| {
        &mut s.moment_x
    }),
    Column::sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    Column::sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
    Column::sampled(
        "distance",
        "m",
        "between its points of the two bodies: length of a spring or a cable, displacement of a slider, otherwise 0 but for round-off",
        |s| &mut s.distance,
    ),
];

/// Columns of `energy.csv`.
pub const ENERGY: &[Column<EnergySample>] = &[
    EnergyColumn::sampled("time", "s", "time since the start", |s| &mut s.time),
    EnergyColumn::sampled("external", "J", "work of loads, drives and gravity, kinetic energy at the start, and elastic energy of soil that entered the domain", |s| &mut s.external).required(),
    EnergyColumn::sampled("kinetic", "J", "kinetic energy of soil and bodies", |s| &mut s.kinetic).required(),
    EnergyColumn::sampled("elastic", "J", "elastic energy of the soil less that at the start", |s| {
        &mut s.elastic
    })
    .required(),
    EnergyColumn::sampled("plastic", "J", "plastic dissipation", |s| &mut s.plastic).required(),
    EnergyColumn::sampled("friction", "J", "dissipation by friction on the bodies", |s| &mut s.friction),
    EnergyColumn::sampled(
        "contact method",
        "J",
        "what the contact method itself stores, dissipates or adds; should be small",
        |s| &mut s.contact,
    ),
    EnergyColumn::sampled("viscous", "J", "dissipation by bulk viscosity", |s| &mut s.viscous),
    EnergyColumn::sampled("hourglass", "J", "dissipation by hourglass viscosity", |s| &mut s.hourglass),
    EnergyColumn::sampled(
        "seepage",
        "J",
        "dissipation by pore water that seeps through the soil; 0 where no pore pressure is computed",
        |s| &mut s.seepage,
    ),
    EnergyColumn::sampled("remap loss", "J", "kinetic and elastic energy lost in remaps", |s| &mut s.remap_loss),
    EnergyColumn::derived(
        "closure",
        "-",
        "error of the energy balance: unexplained energy over the external work (over the plastic or the kinetic energy \
         where that is larger)",
        |s, _| Some(s.closure()),
    ),
    EnergyColumn::sampled("volume ratio", "-", "soil volume, less what has entered the domain, over that at the start", |s| &mut s.volume_ratio)
        .required(),
    EnergyColumn::sampled(
        "elastic compression",
        "-",
        "volume by which the pressure compresses the soil elastically, over the volume at the start; not of sand",
        |s| &mut s.compression,
    ),
    EnergyColumn::sampled(
        "overdense mass",
        "-",
        "portion of the soil's mass in cells denser than 1.1 times its densest state, compressed elastically",
        |s| &mut s.overdense,
    ),
    EnergyColumn::sampled(
        "void under soil",
        "-",
        "volume of voids under soil at rest that neither a body nor cohesion carries, over that of soil with a plastic strain above 0.1",
        |s| &mut s.void,
    ),
];

/// Columns of `boundaries.csv`.
pub const BOUNDARIES: &[Column<BoundarySample>] = &[
    Column::sampled("time", "s", "time since the start", |s| &mut s.time),
    Column::sampled(
        "lid area",
        "m^2",
        "area of the lid that soil has reached; 0 where the soil extends up to the lid from the start",
        |s| &mut s.lid_area,
    ),
    Column::sampled("lid force", "N", "force of the soil on that area", |s| &mut s.lid_force),
    Column::sampled(
        "bare wall area",
        "m^2",
        "area of the side walls, without soil at the start, that soil has reached",
        |s| &mut s.wall_area,
    ),
    Column::sampled(
        "stress rise",
        "Pa",
        "largest rise of the normal pressure on floor and side walls above that at rest",
        |s| &mut s.stress_rise,
    ),
];

/// Columns of `ground_left.csv`.
pub const GROUND_LEFT: &[Column<SurfacePoint>] = &[
    Column::sampled("x", "m", "position along x", |s| &mut s.x),
    Column::sampled("y", "m", "position along y", |s| &mut s.y),
    Column::sampled("z", "m", "height of the surface of the soil", |s| &mut s.column.z),
    Column::sampled(
        "compaction",
        "m",
        "volume per area that the soil has lost since the start by becoming denser; negative where it is looser",
        |s| &mut s.column.compaction,
    ),
    Column::sampled("void", "m", "the same of voids below the surface, less that of soil above it", |s| {
        &mut s.column.void
    }),
    Column::sampled("disturbed", "m", "the same of soil with an equivalent plastic strain above 0.1", |s| {
        &mut s.column.disturbed
    }),
    Column::sampled("mixed", "m", "the same of soil with one above 1", |s| &mut s.column.mixed),
    Column::sampled(
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
    Column::sampled("position", "m", "position along the tow: x, of a lateral tow y", |s| &mut s.position),
    Column::sampled("depth", "m", "depth of the deepest point below the undisturbed surface", |s| {
        &mut s.depth
    }),
    Column::sampled(
        "width",
        "m",
        "width between the points at which the surface rises to the undisturbed one",
        |s| &mut s.width,
    ),
    Column::sampled("area", "m^2", "area of the rut: soil displaced per metre", |s| &mut s.area),
    Column::sampled(
        "high berm",
        "m",
        "height of the berm on the side of larger y, of a lateral tow larger x",
        |s| &mut s.high_berm,
    ),
    Column::sampled("low berm", "m", "height of the berm on the other side", |s| &mut s.low_berm),
    Column::sampled("berm area", "m^2", "area of both berms", |s| &mut s.berm_area),
    Column::sampled(
        "compaction",
        "m^2",
        "area that the soil has lost by becoming denser; negative where it has become looser",
        |s| &mut s.compaction,
    ),
    Column::sampled("void", "m^2", "area of voids below the surface, less that of soil above it", |s| {
        &mut s.void
    }),
    Column::sampled(
        "disturbed",
        "m^2",
        "area of disturbed soil, with an equivalent plastic strain above 0.1: soil disturbed per metre",
        |s| &mut s.disturbed,
    ),
    Column::sampled("mixed", "m^2", "area of mixed soil, with one above 1", |s| &mut s.mixed),
    Column::sampled(
        "disturbed depth",
        "m",
        "depth below the undisturbed surface down to which soil is disturbed",
        |s| &mut s.disturbed_depth,
    ),
];

/// Columns of `filtered.csv`.
pub const FILTERED: &[Column<BodySample>] = &[
    BodyColumn::sampled("time", "s", "time since the start", |s| &mut s.time),
    BodyColumn::sampled("displacement u", "m", "displacement along the tow, not filtered", |s| {
        &mut s.displacement
    }),
    BodyColumn::sampled(
        "sinkage z",
        "m",
        "depth of the lowest point below the undisturbed surface, not filtered",
        |s| &mut s.sinkage,
    ),
    BodyColumn::sampled("drag F_H", "N", "drag", |s| &mut s.drag),
    BodyColumn::sampled("vertical F_V", "N", "vertical force", |s| &mut s.vertical),
    BodyColumn::sampled("lateral", "N", "lateral force", |s| &mut s.lateral),
    BodyColumn::sampled("axle torque", "N m", "torque about the axle", |s| &mut s.axle_torque),
    BodyColumn::sampled("moment x", "N m", "moment about the x axis of space", |s| &mut s.moment_x),
    BodyColumn::sampled("moment y", "N m", "the same about y", |s| &mut s.moment_y),
    BodyColumn::sampled("moment z", "N m", "the same about z", |s| &mut s.moment_z),
    BodyColumn::derived("drawbar pull", "N", "−F_H, less the weight along a slope", |s, r| {
        Some(0.0 - s.drag - r.weight_along.unwrap_or(0.0))
    }),
    BodyColumn::derived("tow power", "W", "F_H v, of filtered drag and speed", |s, _| Some(s.drag * s.speed)),
    BodyColumn::derived("axle power", "W", "−M ω, of filtered torque and rate", |s, _| {
        Some(-s.axle_torque * s.spin)
    }),
    BodyColumn::derived("drag per width", "N/m", "drag over the width across the tow", |s, r| {
        (r.across > 0.0).then(|| s.drag / r.across)
    }),
];

/// Columns of `rim.csv`.
pub const RIM: &[Column<RimLine>] = &[
    RimColumn::sampled(
        "angle",
        "rad",
        "polar angle about the axle: 0 straight below, positive towards the front",
        |l| &mut l.angle,
    ),
    RimColumn::sampled(
        "arc",
        "m",
        "distance along the outline from straight below, with the same sign",
        |l| &mut l.arc,
    ),
    RimColumn::sampled("x", "m", "middle of the bin, from the reference point", |l| &mut l.x),
    RimColumn::sampled("z", "m", "the same", |l| &mut l.z),
    RimColumn::sampled("area", "m^2", "area of the surface that it represents", |l| &mut l.area),
    RimColumn::sampled("contact", "-", "fraction of area and time in contact", |l| &mut l.contact),
    RimColumn::sampled("normal stress", "Pa", "σ, positive in compression", |l| &mut l.normal_stress),
    RimColumn::sampled(
        "shear stress along",
        "Pa",
        "τ of the soil on the body along the outline; below the body positive forwards",
        |l| &mut l.shear_along,
    ),
    RimColumn::sampled("shear stress lateral", "Pa", "the same along the axle; 0 in a symmetric case", |l| {
        &mut l.shear_lateral
    }),
    RimColumn::sampled(
        "shear stress outward",
        "Pa",
        "the same along the axle, away from the mid-plane",
        |l| &mut l.shear_outward,
    ),
    RimColumn::sampled(
        "slip velocity along",
        "m/s",
        "velocity of the body's surface relative to the soil along the outline; empty without contact",
        |l| &mut l.slip_along,
    ),
    RimColumn::sampled(
        "slip velocity lateral",
        "m/s",
        "the same along the axle; 0 in a symmetric case",
        |l| &mut l.slip_lateral,
    ),
    RimColumn::sampled(
        "slip velocity outward",
        "m/s",
        "the same along the axle, away from the mid-plane",
        |l| &mut l.slip_outward,
    ),
    RimColumn::sampled(
        "mobilised friction",
        "-",
        "friction over its limit μσ (or the adhesion, where that is less), whatever its direction; empty without a limit",
        |l| &mut l.mobilised,
    ),
    RimColumn::sampled(
        "mobilised along",
        "-",
        "its mean along the outline over the limit: τ/(μσ), with its sign",
        |l| &mut l.mobilised_along,
    ),
    RimColumn::sampled("drag", "N", "contribution of the bin to the drag F_H of the whole body", |l| {
        &mut l.drag
    }),
    RimColumn::sampled("vertical", "N", "contribution to the vertical force F_V", |l| &mut l.vertical),
];
