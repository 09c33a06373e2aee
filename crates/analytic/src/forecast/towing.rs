//! The input of the forecast: a towed or pressed body in its soil.

use super::body::reference_force;
use super::{Body, Outline};
use crate::bearing::Method;
use crate::disc::{Assembly, Disc, Drive};
use crate::error::{ModelResult, positive, within};
use crate::soil::Soil;
use crate::wheel::PressureSinkage;

/// The vertical condition of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// Free to sink under this weight [N].
    Weight(f64),
    /// The body is held at this sinkage [m].
    Sinkage(f64),
}

/// A towed body, or one that is pressed straight down, and its soil.
#[derive(Clone, Debug, PartialEq)]
pub struct Towing {
    /// The soil.
    pub soil: Soil,
    /// The body.
    pub body: Body,
    /// Reference length d and width t [m] of the dimensionless groups; `None` for [`Body::length`] and
    /// [`Body::width`].
    pub reference: Option<[f64; 2]>,
    /// Weight (of the whole assembly) or sinkage.
    pub load: Load,
    /// How the axle is driven.
    pub drive: Drive,
    /// Whether the body is pressed straight down, without a tow and without turning; a [`super::Plate`]
    /// always is.
    pub pressed: bool,
    /// Whether the body is pulled straight up, from where it lies buried; it then counts as pressed, with an
    /// upward motion.
    pub raised: bool,
    /// Resistance of the soil over that of the models: their own error, 1 for their predictions.
    pub resistance_factor: f64,
    /// Thrust of a driven body over that of the models at the same resistance of the soil: the error of the
    /// one is not that of the other.
    pub thrust_factor: f64,
    /// Gravity [m/s²]; converts weights to masses only.
    pub gravity: f64,
    /// Fraction of the displaced soil that stands as a bow wave before the disc, 0 to 1.
    pub bow_wave_fraction: f64,
    /// Slope of the ground before the body [rad], rising forwards.
    pub backfill: f64,
    /// Correction factors of the bearing model.
    pub method: Method,
    /// Several discs on one axle.
    pub assembly: Option<Assembly>,
    /// Young's modulus of the soil [Pa]; for the group Ē, and for cones and piles.
    pub elastic_modulus: Option<f64>,
    /// Poisson's ratio of the soil.
    pub poisson_ratio: f64,
    /// Coefficient of earth pressure at rest K₀.
    pub rest_pressure: f64,
    /// Bekker's plate constants, for Bekker and Wong–Reece; their c and φ are replaced by those of the soil.
    pub terrain: Option<PressureSinkage>,
    /// Cone index [Pa], for Wismer–Luth and Brixius.
    pub cone_index: Option<f64>,
    /// Pressure over depth under a level plate [N/m³], for 2-D RFT; by default that of 3D-RFT.
    pub plate_stiffness: Option<f64>,
}

/// An input of a curve or an uncertainty analysis; units as in [`Towing`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Parameter {
    /// φ [rad]; the dilation angle stays, but is limited to φ.
    FrictionAngle,
    /// ψ [rad].
    DilationAngle,
    /// c [Pa].
    Cohesion,
    /// γ [N/m³].
    UnitWeight,
    /// μ.
    BodyFriction,
    /// d [m]; of a disc, a pipe or a round plate only.
    Diameter,
    /// t [m]; of a disc only.
    Thickness,
    /// Rotation of a block about y [rad], positive when the top moves in the tow direction.
    Orientation,
    /// W [N]; replaces a prescribed sinkage.
    Weight,
    /// z [m]; replaces a weight.
    Sinkage,
    /// The [`crate::slip`]; replaces the drive.
    Slip,
    /// Braking torque at the axle [N m]; replaces the drive.
    BrakeTorque,
    /// Fraction χ of the bow wave.
    BowWaveFraction,
    /// β [rad].
    Backfill,
    /// Cone index [Pa].
    ConeIndex,
    /// Pressure over depth under a level plate [N/m³].
    PlateStiffness,
    /// Sinkage exponent n; like the other plate constants without effect in a case that has none.
    PlateExponent,
    /// k_c [N/m^{n+1}].
    PlateCohesive,
    /// k_φ [N/m^{n+2}].
    PlateFrictional,
    /// K [m].
    ShearModulus,
    /// Resistance of the soil over that of the models.
    ResistanceFactor,
    /// Thrust of a driven body over that of the models.
    ThrustFactor,
}

impl Towing {
    /// A single towed body (a plate: pressed down) on level ground under Earth's gravity, without measured
    /// plate constants or cone index.
    #[must_use]
    pub fn new(soil: Soil, body: impl Into<Body>, load: Load, drive: Drive) -> Self {
        let body = body.into();
        let pressed = matches!(body, Body::Plate(_) | Body::Cone(_) | Body::Pipe(_));
        Self {
            soil,
            body,
            reference: None,
            load,
            drive,
            pressed,
            raised: false,
            resistance_factor: 1.0,
            thrust_factor: 1.0,
            gravity: 9.81,
            bow_wave_fraction: 0.0,
            backfill: 0.0,
            method: Method::default(),
            assembly: None,
            elastic_modulus: None,
            poisson_ratio: 0.3,
            rest_pressure: 0.5,
            terrain: None,
            cone_index: None,
            plate_stiffness: None,
        }
    }

    /// Checks the inputs that all models share.
    ///
    /// # Errors
    /// The first input out of range, with its valid range.
    pub fn check(&self) -> ModelResult<()> {
        self.soil.check()?;
        self.body.check()?;
        self.drive.check()?;
        match self.load {
            Load::Weight(weight) => positive("weight [N]", weight)?,
            Load::Sinkage(z) => within("sinkage [m]", z, f64::MIN_POSITIVE, self.body.deepest())?,
        };
        positive("resistance factor", self.resistance_factor)?;
        positive("thrust factor", self.thrust_factor)?;
        positive("gravity [m/s^2]", self.gravity)?;
        within("bow wave fraction", self.bow_wave_fraction, 0.0, 1.0)?;
        within("backfill [rad]", self.backfill, -10_f64.to_radians(), 25_f64.to_radians())?;
        if let (Some(assembly), Some(disc)) = (self.assembly, self.body.disc()) {
            assembly.check(disc)?;
        }
        if let Some(modulus) = self.elastic_modulus {
            positive("elastic modulus [Pa]", modulus)?;
        }
        Ok(())
    }

    /// Reference length d and width t [m] of the dimensionless groups.
    #[must_use]
    pub fn reference_lengths(&self) -> [f64; 2] {
        self.reference.unwrap_or_else(|| [self.body.length(), self.body.width()])
    }

    /// The force over which forces and weights are dimensionless [N]: γ t d² of each body; `None` for
    /// weightless soil.
    #[must_use]
    pub fn force_scale(&self) -> Option<f64> {
        let [d, t] = self.reference_lengths();
        let count = self.assembly.map_or(1.0, |assembly| f64::from(assembly.count));
        reference_force(self.soil.unit_weight, count * t, d)
    }

    /// The case with one parameter changed; the dilation angle is limited to the friction angle.
    #[must_use]
    pub fn with(&self, parameter: Parameter, value: f64) -> Self {
        let mut case = self.clone();
        match parameter {
            Parameter::FrictionAngle => {
                case.soil.friction_angle = value;
                // So does K₀ where it is Jaky's 1 − sin φ.
                if (self.rest_pressure - (1.0 - self.soil.friction_angle.sin())).abs() < 1e-9 {
                    case.rest_pressure = 1.0 - value.sin();
                }
                // Associated flow stays associated; otherwise the dilation angle stays.
                let associated = self.soil.dilation_angle >= self.soil.friction_angle;
                case.soil.dilation_angle =
                    if associated { value } else { self.soil.dilation_angle.min(value) };
            }
            Parameter::DilationAngle => case.soil.dilation_angle = value,
            Parameter::Cohesion => case.soil.cohesion = value,
            Parameter::UnitWeight => case.soil.unit_weight = value,
            Parameter::BodyFriction => case.soil.body_friction = value,
            Parameter::Diameter => case.change_diameter(value),
            Parameter::Thickness => case.change_disc(|disc| disc.thickness = value),
            Parameter::Orientation => {
                if let Body::Block(block) = &mut case.body {
                    block.orientation = value;
                }
            }
            Parameter::Weight => case.load = Load::Weight(value),
            Parameter::Sinkage => case.load = Load::Sinkage(value),
            Parameter::Slip => case.drive = Drive::Slip(value),
            Parameter::BrakeTorque => case.drive = Drive::Braked(value),
            Parameter::BowWaveFraction => case.bow_wave_fraction = value,
            Parameter::Backfill => case.backfill = value,
            Parameter::ConeIndex => case.cone_index = Some(value),
            Parameter::PlateStiffness => case.plate_stiffness = Some(value),
            Parameter::PlateExponent => case.change_terrain(|t| t.exponent = value),
            Parameter::PlateCohesive => case.change_terrain(|t| t.cohesive = value),
            Parameter::PlateFrictional => case.change_terrain(|t| t.frictional = value),
            Parameter::ResistanceFactor => case.resistance_factor = value,
            Parameter::ThrustFactor => case.thrust_factor = value,
            Parameter::ShearModulus => case.change_terrain(|t| t.shear_modulus = value),
        }
        case
    }

    fn change_diameter(&mut self, diameter: f64) {
        match &mut self.body {
            Body::Disc(disc) => disc.diameter = diameter,
            Body::Plate(plate) if plate.outline == Outline::Circle => {
                (plate.width, plate.length) = (diameter, diameter);
                self.reference = self.reference.map(|_| [diameter; 2]);
            }
            Body::Pipe(pipe) => pipe.diameter = diameter,
            _ => {}
        }
    }

    fn change_disc(&mut self, change: impl FnOnce(&mut Disc)) {
        if let Body::Disc(disc) = &mut self.body {
            change(disc);
        }
    }

    fn change_terrain(&mut self, change: impl FnOnce(&mut PressureSinkage)) {
        if let Some(terrain) = &mut self.terrain {
            change(terrain);
        }
    }
}
