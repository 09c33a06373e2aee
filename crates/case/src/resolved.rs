//! What a case means: every default filled in, every number in SI units. It is plain data:
//! [`super::validate`] says whether it can be simulated.

pub use super::body::{Attitude, Body, MOTIONS, Part, Staged};
use super::clearance::SoilConditions;
pub use super::domain::{Domain, Wall};
pub use super::grid::Grid;
pub use super::ground::Ground;
pub use super::joint::{GROUND, Joint, JointKind};
pub use super::layer::Layer;
pub use super::measured::{Factors, Measured, Plate, Plough};
pub use super::numerics::{Contact, Numerics, Precision};
pub use super::output::Output;
use super::path::Paths;
use super::relief::Relief;
pub use super::shapes::slab::PLANE_STRAIN_WIDTH;
use super::slope::Slope;
pub(crate) use super::soil::SOIL;
pub use super::soil::{ClaySoftening, Law, MohrCoulomb, Potential, Sand, Soil, Tresca, VonMises};
pub use super::soil_body::SoilBody;
use super::stage;
pub use super::stage::{Change, MotionTable, Stage, StageQuantity, Until};
pub use super::water::Water;
use glam::DVec3;
pub use mechanics::Motion;
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
    /// The water over the soil; `None` for dry ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub water: Option<Water>,
    /// The soil, of ground in layers the uppermost.
    pub soil: Soil,
    /// The layers below the uppermost soil, from the top down.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// Bodies of soil of another kind, in the order of the file; where two overlap, the first counts.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub soil_bodies: Vec<SoilBody>,
    /// Where there is soil at the start.
    pub ground: Ground,
    /// How the surface of the ground rises and falls.
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

impl<'a> Paths<'a> {
    /// The paths of the bodies of a case.
    pub fn of(case: &'a Case) -> Self {
        Self { bodies: &case.bodies, follow: case.grid.follow, duration: case.duration }
    }
}

impl SoilConditions {
    /// The soil of a case.
    pub(crate) fn of(case: &Case) -> Self {
        Self {
            law: case.soil.law,
            surface: case.ground.surface(),
            floor: case.domain.low.z,
            velocity: case.velocity,
            gravity: case.gravity,
            plane_strain: case.domain.plane_strain,
            confined: case.domain.high.z <= case.ground.surface(),
        }
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
