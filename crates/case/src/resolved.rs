//! What a case means: every default filled in, every number in SI units. It is plain data:
//! [`super::validate`] says whether it can be simulated.

pub use super::joint::{GROUND, Joint, JointKind};
pub use super::measured::{Factors, Measured, Plate, Plough};
pub use super::numerics::{Contact, Numerics, Precision};
pub use super::output::Output;
use super::relief::Relief;
use super::rigid_body::pitched;
pub use super::rigid_body::{Attitude, Body, MOTIONS, PLANE_STRAIN_WIDTH, Part, Staged};
use super::shapes::Shape;
use super::slope::Slope;
pub(crate) use super::soil::SOIL;
pub use super::soil::{ClaySoftening, Law, MohrCoulomb, Potential, Sand, Soil, Tresca, VonMises};
use super::stage;
pub use super::stage::{Change, MotionTable, Stage, StageQuantity, Until};
pub use super::water::Water;
use glam::DVec3;
pub use mechanics::Motion;
use mechanics::Pose;
use serde::Serialize;
pub use solver::model::Follow;

/// A case. One that was read is valid; one that is made or changed by hand is checked by [`super::validate`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Case {
    /// Short name, also of the results folder. Letters, digits, `-` and `_`.
    pub name: String,
    /// One line for the report.
    pub title: String,
    /// Acceleration of gravity, downwards [m/s²]. May be 0 (weightless soil).
    pub gravity: f64,
    /// Slope of the ground, in whose surface x and y lie.
    #[serde(skip_serializing_if = "Slope::is_level")]
    pub slope: Slope,
    /// The water over it; `None` for dry ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub water: Option<Water>,
    /// The soil, of ground in layers the uppermost.
    pub soil: Soil,
    /// The layers below it, from the top down.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// Bodies of soil of another kind, in the order of the file; where two overlap, the first counts.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub soil_bodies: Vec<SoilBody>,
    /// Where there is soil at the start.
    pub ground: Ground,
    /// How its surface rises and falls.
    #[serde(skip_serializing_if = "Relief::is_level")]
    pub relief: Relief,
    /// Vertical pressure of the lid on the soil at the start [Pa].
    pub overburden: f64,
    /// Initial velocity of the soil [m/s].
    pub velocity: DVec3,
    /// The box that is modelled.
    pub domain: Domain,
    /// Cell sizes.
    pub grid: Grid,
    /// Rigid bodies in the order of the file; may be empty.
    pub bodies: Vec<Body>,
    /// Joints in the order of the file; may be empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<Joint>,
    /// Stages of the run in the order of the file; empty for a run that has only one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stages: Vec<Stage>,
    /// Files of tables that motions follow.
    #[serde(skip)]
    pub tables: Vec<MotionTable>,
    /// What is to be said of how its files were read.
    #[serde(skip)]
    pub remarks: Vec<String>,
    /// Duration of the run [s]; of one of several stages the longest possible.
    pub duration: f64,
    /// What to write, and how often.
    pub output: Output,
    /// Parameters of the method.
    pub numerics: Numerics,
    /// Parameters of the closed-form models only.
    pub forecast: Measured,
}

impl Case {
    /// The stage over which averages are taken, by number: the last one in which a body is towed, or else the
    /// last one.
    #[must_use]
    pub fn steady_stage(&self) -> Option<usize> {
        stage::steady(&self.stages)
    }

    /// The case as it stands in the stage over which averages are taken, for closed forms: its motions, from
    /// the depth to which bodies have been pressed by then.
    ///
    /// # Errors
    /// In words, where the depth of a body follows only from the run.
    pub fn in_steady_stage(&self) -> Result<Self, String> {
        let mut case = Self { stages: Vec::new(), ..self.clone() };
        for body in &mut case.bodies {
            if let Some(Staged { motions, bounds, depth_is_known }) = body.staged.take() {
                if !motions[2].is_free() {
                    if !depth_is_known {
                        return Err(format!(
                            "how deep `{}` is follows from the run: a stage before the tow moves it until a force or a torque is \
                             reached; end that stage at a sinkage for a forecast",
                            body.name
                        ));
                    }
                    let [down, up] = bounds[2];
                    body.position.z += if -down > up { down } else { up };
                }
                let [x, y, z, yaw, tilt, spin] = motions;
                (body.translation, body.rotation) = ([x, y, z], [yaw, tilt, spin]);
            }
        }
        Ok(case)
    }

    /// The soil and its layers from the top down, each with the path of its section.
    pub fn layered_soils(&self) -> impl Iterator<Item = (String, &Soil)> {
        let layers = self.layers.iter().map(|layer| (layer.path(), &layer.soil));
        std::iter::once((SOIL.to_owned(), &self.soil)).chain(layers)
    }

    /// All soils, each with the path of its section: the layers from the top down, then the soil bodies.
    pub fn soils(&self) -> impl Iterator<Item = (String, &Soil)> {
        self.layered_soils().chain(self.soil_bodies.iter().map(|body| (body.path(), &body.soil)))
    }

    /// Whether the surface is level, or an even slope, and no soil body lies in the ground.
    #[must_use]
    pub fn is_even(&self) -> bool {
        self.relief.is_level() && self.soil_bodies.is_empty()
    }

    /// The bodies that have a surface, which the soil can touch, with their numbers.
    pub fn touching(&self) -> impl Iterator<Item = (usize, &Body)> {
        self.bodies.iter().enumerate().filter(|(_, body)| body.has_surface())
    }
}

/// A layer of the ground below the uppermost soil.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Layer {
    /// Name of the layer.
    pub name: String,
    /// Depth of its top below the surface [m].
    pub top: f64,
    /// Soil of the layer.
    pub soil: Soil,
}

impl Layer {
    /// Path of its section.
    pub(crate) fn path(&self) -> String {
        format!("layer.{}", self.name)
    }
}

/// A body of soil of another kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SoilBody {
    /// Name of the soil body.
    pub name: String,
    /// Shape of the soil body.
    pub shape: Shape,
    /// Reference point of the soil body [m].
    pub position: DVec3,
    /// Attitude of the soil body.
    pub attitude: Attitude,
    /// Soil of the soil body.
    pub soil: Soil,
}

impl SoilBody {
    /// Path of its section.
    pub(crate) fn path(&self) -> String {
        format!("soil_body.{}", self.name)
    }

    /// The solver's soil body, of this material.
    pub(crate) fn solver_body(&self, material: usize) -> solver::model::SoilBody {
        let solid = pitched(&self.shape, self.attitude.pitch);
        let pose = Pose { position: self.position, rotation: self.attitude.of_axle() };
        solver::model::SoilBody::new(solid.into(), &pose, material)
    }
}

/// Where there is soil at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ground {
    /// The half space below z = `surface` [m].
    Level {
        /// Height of the surface [m].
        surface: f64,
    },
    /// Soil only in a box (a column that will collapse, a bank in front of a wall), or in the round column
    /// inside it.
    Column {
        /// Low corner [m].
        low: DVec3,
        /// High corner [m].
        high: DVec3,
        /// Radius of the round column about the z axis [m].
        radius: Option<f64>,
    },
}

impl Ground {
    /// Height of its level surface [m].
    #[must_use]
    pub fn surface(&self) -> f64 {
        match *self {
            Self::Level { surface } => surface,
            Self::Column { high, .. } => high.z,
        }
    }
}

/// Boundary condition at a face of the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wall {
    /// No motion through it, no friction along it. A symmetry plane is one.
    Smooth,
    /// No motion at all.
    Fixed,
    /// None: the ground beyond it bears what it bears at rest, soil leaves and ground enters.
    Pressure,
}

/// The box that is modelled.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Domain {
    /// Low corner [m].
    pub low: DVec3,
    /// High corner [m].
    pub high: DVec3,
    /// Walls by axis x, y, z: at the low end and at the high end.
    pub walls: [[Wall; 2]; 3],
    /// Whether y = 0 is a plane of symmetry and only y ≥ 0 is modelled. Forces are reported for the whole
    /// body.
    pub symmetric: bool,
    /// Whether x = 0 is a plane of symmetry and only x ≥ 0 is modelled.
    pub symmetric_x: bool,
    /// Whether the case is plane strain: a slab one cell thick in y. Bodies, forces and weights are those of
    /// a width of
    /// [`PLANE_STRAIN_WIDTH`], whatever the thickness of the slab.
    pub plane_strain: bool,
}

impl Domain {
    /// Whether any boundary is at constant stress.
    #[must_use]
    pub fn yields(&self) -> bool {
        self.walls.as_flattened().contains(&Wall::Pressure)
    }

    /// The boundary at the top.
    #[must_use]
    pub fn lid(&self) -> Wall {
        self.walls[2][1]
    }

    /// Width of a body along y [m] that is itself so wide; in plane strain [`PLANE_STRAIN_WIDTH`].
    #[must_use]
    pub fn width_of_body(&self, own: f64) -> f64 {
        if self.plane_strain { PLANE_STRAIN_WIDTH } else { own }
    }

    /// Portion of the width of each body that is modelled: in plane strain that of the slab, which may be
    /// more than 1, otherwise 1.
    #[must_use]
    pub fn modelled_width(&self) -> f64 {
        if self.plane_strain { (self.high.y - self.low.y) / PLANE_STRAIN_WIDTH } else { 1.0 }
    }
}

/// Cell sizes: uniform inside the fine zone, growing geometrically outside it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Grid {
    /// Cell size h in the fine zone [m]: the smallest width of its cells.
    pub cell: f64,
    /// Widths of the cells in the fine zone along x, y, z over `cell`; one of them is 1.
    pub aspect: DVec3,
    /// Low corner of the fine zone [m].
    pub fine_low: DVec3,
    /// High corner of the fine zone [m].
    pub fine_high: DVec3,
    /// Ratio of a cell's width to its inner neighbour's outside the fine zone (1 = uniform).
    pub growth: f64,
    /// The body that the grid follows, if it does not stand still; the box and the faces are then those at
    /// the start.
    pub follow: Option<Follow>,
    /// Face positions along x, y, z that follow from the above [m].
    pub faces: [Vec<f64>; 3],
}

impl Grid {
    /// Widths along x, y, z of the cells in the fine zone [m].
    #[must_use]
    pub fn fine_cell(&self) -> DVec3 {
        self.cell * self.aspect
    }
}

/// The resolved case as text, but for what makes no difference to the results of a run.
#[must_use]
pub fn case_text(case: &Case) -> String {
    case_text_with_forecast(&Case { forecast: Measured::default(), ..case.clone() })
}

/// The resolved case as text, but for what makes no difference to the results of a run or of a forecast.
#[must_use]
pub fn case_text_with_forecast(case: &Case) -> String {
    let mut case = case.clone();
    case.numerics.threads = 0;
    case.output.checkpoint_interval = 0.0;
    case.output.filter_cutoff = 0.0;
    // Its content says what a mesh is, not where it was read.
    for body in &mut case.bodies {
        body.shape.forget_file();
    }
    for body in &mut case.soil_bodies {
        body.shape.forget_file();
    }
    if let Some(map) = &mut case.relief.map {
        map.file.clear();
    }
    // A case is made of numbers, names and lists: it always has a text.
    serde_json::to_string(&case).unwrap_or_default()
}
