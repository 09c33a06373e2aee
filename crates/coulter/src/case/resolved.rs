//! What a case means: every default filled in, every number in SI units. It is plain data: [`super::validate`] says whether it
//! can be simulated.

pub use super::joint::{GROUND, Joint, JointKind};
use super::relief::Relief;
use super::rigid_body::pitched;
pub use super::rigid_body::{Attitude, Body, MOTIONS, PLANE_STRAIN_WIDTH, Part, Staged};
use super::shapes::Shape;
use super::slope::Slope;
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
    /// The stage over which averages are taken, by number: the last one in which a body is towed, or else the last one.
    #[must_use]
    pub fn steady_stage(&self) -> Option<usize> {
        stage::steady(&self.stages)
    }

    /// The case as it stands in the stage over which averages are taken, for closed forms: its motions, from the depth to which bodies
    /// have been pressed by then.
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

/// Parameters of the soil.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Soil {
    /// Yield law.
    pub law: Law,
    /// Inertial density ρ [kg/m³] (γ/g unless given); under water the dry density.
    pub density: f64,
    /// Unit weight γ [N/m³], under water the submerged one γ′; 0 for weightless soil.
    pub unit_weight: f64,
    /// Young's modulus E [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio ν, 0 ≤ ν < 0.5.
    pub poisson_ratio: f64,
    /// Coefficient of earth pressure at rest K₀: horizontal over vertical stress at the start.
    pub k0: f64,
}

impl Soil {
    /// Young's modulus where it is largest [Pa].
    #[must_use]
    pub fn stiffest_modulus(&self) -> f64 {
        match self.law {
            Law::Sand { stiffness_limit, .. } => {
                self.young_modulus * (stiffness_limit / STIFFNESS_PRESSURE).sqrt()
            }
            _ => self.young_modulus,
        }
    }

    /// The same soil at another density [kg/m³], under the same gravity.
    #[must_use]
    pub fn at_density(&self, density: f64) -> Self {
        Self { density, unit_weight: self.unit_weight * (density / self.density), ..self.clone() }
    }

    /// Density [kg/m³] at a relative density, of sand.
    #[must_use]
    pub fn density_at(&self, relative_density: f64) -> Option<f64> {
        self.law.density_at(relative_density)
    }

    /// Growth of the relative density with depth [1/m].
    #[must_use]
    pub fn density_gradient(&self) -> f64 {
        if let Law::Sand { density_gradient, .. } = self.law { density_gradient } else { 0.0 }
    }

    /// The same soil as it is at a depth below its top [m].
    #[must_use]
    pub fn at_depth(&self, depth: f64) -> Self {
        let soil = Self { law: self.law.at_depth(depth), ..self.clone() };
        let relative = self.relative_density().map(|relative| relative + self.density_gradient() * depth);
        let density = relative.filter(|_| self.density_gradient() > 0.0).and_then(|r| self.density_at(r));
        density.map_or_else(|| soil.clone(), |density| soil.at_density(density))
    }

    /// Relative density at the start, of sand: (e_max − e)/(e_max − e_min).
    #[must_use]
    pub fn relative_density(&self) -> Option<f64> {
        match self.law {
            Law::Sand { minimum_density, maximum_density, .. } => {
                let range = maximum_density - minimum_density;
                Some(maximum_density * (self.density - minimum_density) / (self.density * range))
            }
            _ => None,
        }
    }
}

/// Mean pressure to which Young's modulus of sand refers [Pa].
const STIFFNESS_PRESSURE: f64 = 1e5;

/// The yield law of the soil.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Law {
    /// Linear elastic.
    Elastic,
    /// Tresca: undrained shear strength s_u [Pa].
    Tresca {
        /// Undrained shear strength s_u of the intact soil, at the top of its layer [Pa].
        shear_strength: f64,
        /// Its growth with depth k [Pa/m].
        gradient: f64,
        /// What remoulding and rate do to it; `None` for nothing.
        softening: Option<ClaySoftening>,
    },
    /// Von Mises with linear isotropic hardening.
    VonMises {
        /// Yield stress in plain tension σ_y [Pa].
        yield_stress: f64,
        /// Hardening modulus: its slope over the equivalent plastic strain, H ≥ 0 [Pa].
        hardening_modulus: f64,
    },
    /// Mohr–Coulomb.
    MohrCoulomb {
        /// Friction angle φ [rad].
        friction_angle: f64,
        /// Dilation angle ψ [rad], 0 ≤ ψ ≤ φ.
        dilation_angle: f64,
        /// Cohesion c [Pa]; 0 is allowed.
        cohesion: f64,
        /// Tension cut-off: the largest tensile stress [Pa]; at most c cot φ.
        tension_cutoff: f64,
        /// Plastic flow potential.
        potential: Potential,
        /// Density below which the soil no longer dilates [kg/m³].
        critical_density: Option<f64>,
    },
    /// Sand whose strength and stiffness follow its density and pressure.
    Sand {
        /// Friction angle of the critical state in triaxial compression φ_cv [rad].
        critical_friction_angle: f64,
        /// Dry density in the loosest state [kg/m³].
        minimum_density: f64,
        /// Dry density in the densest state [kg/m³].
        maximum_density: f64,
        /// Bolton's Q.
        bolton_q: f64,
        /// Bolton's R.
        bolton_r: f64,
        /// Plastic shear strain at which half of the strength is mobilised.
        reference_strain: f64,
        /// Bulk modulus of plastic compression at 100 kPa [Pa].
        compression_modulus: f64,
        /// Largest mean pressure that the soil has borne before [Pa].
        #[serde(skip_serializing_if = "is_zero")]
        preconsolidation: f64,
        /// Mean pressure beyond which the elastic moduli no longer grow [Pa].
        stiffness_limit: f64,
        /// Length over which the density that governs the strength is averaged [m].
        characteristic_length: Option<f64>,
        /// Growth of the relative density at the start with the depth below the top of the soil [1/m].
        #[serde(skip_serializing_if = "is_zero")]
        density_gradient: f64,
    },
}

/// Whether a number is 0.
#[allow(clippy::trivially_copy_pass_by_ref)] // as serde calls it
fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

/// What remoulding and rate of shear do to the strength of undrained clay (Einav & Randolph 2005).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ClaySoftening {
    /// Sensitivity S_t ≥ 1: strength of the intact clay over that of the remoulded one.
    pub sensitivity: f64,
    /// Plastic shear strain at which 95 % of the loss has happened, ξ₉₅.
    pub remoulding_strain: f64,
    /// Gain of strength per tenfold rate of shear, μ ≥ 0.
    pub rate_strengthening: f64,
    /// Rate of shear up to which there is none [1/s].
    pub reference_rate: f64,
}

impl Law {
    /// The law at a depth below the top of its layer [m]: with the strength that undrained soil has there.
    #[must_use]
    pub fn at_depth(self, depth: f64) -> Self {
        match self {
            Self::Tresca { shear_strength, gradient, softening } => {
                Self::Tresca { shear_strength: shear_strength + gradient * depth, gradient, softening }
            }
            _ => self,
        }
    }

    /// What soil of this law is called in messages.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::Tresca { .. } => "undrained (tresca)",
            Self::VonMises { .. } => "metal (von-mises)",
            Self::MohrCoulomb { .. } => "frictional (mohr-coulomb)",
            Self::Sand { .. } => "frictional (sand)",
        }
    }

    /// Density [kg/m³] at a relative density, of sand.
    #[must_use]
    pub fn density_at(&self, relative_density: f64) -> Option<f64> {
        match *self {
            Self::Sand { minimum_density, maximum_density, .. } => {
                let range = maximum_density - minimum_density;
                Some(minimum_density * maximum_density / (maximum_density - relative_density * range))
            }
            _ => None,
        }
    }

    /// Friction angle φ [rad], of sand that of the critical state; `None` for a strength that does not depend on the pressure.
    #[must_use]
    pub fn friction_angle(&self) -> Option<f64> {
        match *self {
            Self::MohrCoulomb { friction_angle, .. } => Some(friction_angle),
            Self::Sand { critical_friction_angle, .. } => Some(critical_friction_angle),
            Self::Elastic | Self::Tresca { .. } | Self::VonMises { .. } => None,
        }
    }

    /// Whether its stress is that of the grains, beside which water in the pores has a pressure of its own; false for soil that is
    /// undrained by its law.
    #[must_use]
    pub fn bears_effective_stress(&self) -> bool {
        self.friction_angle().is_some() || matches!(self, Self::Elastic)
    }

    /// Dilation angle ψ [rad]; 0 for isochoric flow.
    #[must_use]
    pub fn dilation_angle(&self) -> f64 {
        match *self {
            Self::MohrCoulomb { dilation_angle, .. } => dilation_angle,
            Self::Elastic | Self::Tresca { .. } | Self::VonMises { .. } | Self::Sand { .. } => 0.0,
        }
    }

    /// Whether the soil may take up and lose volume as it is sheared, without limit on the way: [loses, takes up].
    #[must_use]
    pub fn changes_volume(&self) -> [bool; 2] {
        [matches!(self, Self::Sand { .. }), matches!(self, Self::Sand { .. }) || self.dilation_angle() > 0.0]
    }

    /// Shear strength without normal stress [Pa]: c, s_u, or about half of σ_y; `None` for soil that does not fail.
    #[must_use]
    pub fn cohesion(&self) -> Option<f64> {
        match *self {
            Self::Elastic => None,
            Self::Tresca { shear_strength, .. } => Some(shear_strength),
            Self::VonMises { yield_stress, .. } => Some(0.5 * yield_stress),
            Self::MohrCoulomb { cohesion, .. } => Some(cohesion),
            Self::Sand { .. } => Some(0.0),
        }
    }
}

/// The flow potential of the frictional law.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Potential {
    /// Of the form of the yield surface, with ψ in place of φ.
    MohrCoulomb,
    /// Menétrey and Willam (1995).
    MenetreyWillam {
        /// Meridional eccentricity ε ≥ 0.
        meridional: f64,
        /// Deviatoric eccentricity e, ½ < e ≤ 1.
        deviatoric: f64,
    },
}

/// A layer of the ground below the uppermost soil.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Layer {
    /// Its name.
    pub name: String,
    /// Depth of its top below the surface [m].
    pub top: f64,
    /// Its soil.
    pub soil: Soil,
}

/// Path of the section of the soil, of ground in layers of the uppermost.
pub(crate) const SOIL: &str = "soil";

impl Layer {
    /// Path of its section.
    pub(crate) fn path(&self) -> String {
        format!("layer.{}", self.name)
    }
}

/// A body of soil of another kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SoilBody {
    /// Its name.
    pub name: String,
    /// Its shape.
    pub shape: Shape,
    /// Its reference point [m].
    pub position: DVec3,
    /// Its attitude.
    pub attitude: Attitude,
    /// Its soil.
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
    /// Soil only in a box (a column that will collapse, a bank in front of a wall), or in the round column inside it.
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
    /// Whether y = 0 is a plane of symmetry and only y ≥ 0 is modelled. Forces are reported for the whole body.
    pub symmetric: bool,
    /// The same for x = 0 and x ≥ 0.
    pub symmetric_x: bool,
    /// Whether the case is plane strain: a slab one cell thick in y. Bodies, forces and weights are those of a width of
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

    /// Portion of the width of each body that is modelled: in plane strain that of the slab, which may be more than 1, otherwise 1.
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
    /// The body that the grid follows, if it does not stand still; the box and the faces are then those at the start.
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

/// What to write.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Output {
    /// Time between lines of forces.csv [s]; the forces are averages over it.
    pub history_interval: f64,
    /// Time between field files [s]; infinite for only the first and the last.
    pub field_interval: f64,
    /// Time between checkpoints, in seconds of wall clock; infinite for none but at the end.
    pub checkpoint_interval: f64,
    /// Fraction of the run, at its end, over which steady averages are taken, 0 to 1.
    pub steady_fraction: f64,
    /// Cut-off frequency of the filtered forces [Hz].
    pub filter_cutoff: f64,
}

impl Output {
    /// Least number of lines of forces.csv in the steady window of which a run has statistics.
    pub const FEWEST_SAMPLES: usize = 24;
}

/// Contact method between soil and bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Contact {
    /// Penalty method with a penetration history that follows the geometric gap.
    Penalty,
    /// Velocity impulses, iterated together with the motion of the body.
    Impulse,
}

/// Precision of the soil's fields and of the arithmetic on them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Precision {
    /// 64 bits.
    #[default]
    Double,
    /// 32 bits.
    Single,
}

/// Parameters of the method; change them to study it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Numerics {
    /// Courant number of the time step.
    pub courant: f64,
    /// Displacement in cell widths at which a remap is due.
    pub remap_displacement: f64,
    /// Coefficient of hourglass viscosity.
    pub hourglass: f64,
    /// Fraction of the hourglass viscosity that acts in cells that yield.
    pub hourglass_yielding: f64,
    /// Linear coefficient of bulk viscosity b₁.
    pub bulk_viscosity_linear: f64,
    /// Quadratic coefficient of bulk viscosity b₂.
    pub bulk_viscosity_quadratic: f64,
    /// Contact method.
    pub contact: Contact,
    /// Distance of contact points from sharp edges, in cell widths.
    pub edge_inset: f64,
    /// Spacing of contact points, in cell widths.
    pub point_spacing: f64,
    /// Threads of each process; 0 for as many as [`super::cores::threads_by_default`].
    pub threads: usize,
    /// Precision of the soil's fields.
    pub precision: Precision,
}

/// Parameters of the closed-form models of `coulter forecast`; the solver ignores them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Measured {
    /// Inclination β of the ground in front of the disc [rad].
    pub backfill: f64,
    /// Bow wave: fraction χ of the displaced soil that accumulates in front of the disc.
    pub bow_wave: f64,
    /// Shape, depth and inclination factors of the bearing capacity.
    pub factors: Factors,
    /// Cone index CI [Pa].
    pub cone_index: Option<f64>,
    /// Pressure over depth under a level plate pushed down [N/m³].
    pub plate_stiffness: Option<f64>,
    /// Pressure–sinkage parameters.
    pub plate: Option<Plate>,
    /// Coefficients of a plough under water.
    pub plough: Option<Plough>,
}

/// Coefficients of the tow force of a plough under water, each least and most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Plough {
    /// C_w: friction over the weight in water.
    pub weight: [f64; 2],
    /// C_s: slow resistance over γ′ D³.
    pub slow: [f64; 2],
    /// C_d: growth of the resistance with the speed over D² [N s/m³].
    pub rate: [f64; 2],
}

/// Pressure–sinkage parameters of Bekker, p = (k_c/b + k_φ) zⁿ, and shear deformation modulus of Janosi and Hanamoto.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Plate {
    /// The published soil that they belong to, if any.
    pub name: Option<String>,
    /// Sinkage exponent n.
    pub exponent: f64,
    /// Cohesive modulus k_c [N/m^(n+1)].
    pub cohesive: f64,
    /// Frictional modulus k_φ [N/m^(n+2)].
    pub frictional: f64,
    /// Shear deformation modulus K [m].
    pub shear_deformation_modulus: f64,
}

/// Shape, depth and inclination factors of the bearing capacity model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Factors {
    /// Meyerhof (1963).
    #[default]
    Meyerhof,
    /// Hansen (1970) and Vesić (1973).
    HansenVesic,
    /// Lyamin et al. (2007).
    Lyamin,
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
