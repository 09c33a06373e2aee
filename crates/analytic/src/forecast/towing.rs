//! One body under tow, as the forecast takes it.

use super::Body;
use crate::bearing::Method;
use crate::disc::{Assembly, Disc, Drive};
use crate::error::{Answer, positive, within};
use crate::soil::Soil;
use crate::wheel::PressureSinkage;

/// What presses the body into the soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// It carries this weight [N] and sinks as it must.
    Weight(f64),
    /// It is held at this sinkage [m].
    Sinkage(f64),
}

/// A body under tow.
#[derive(Clone, Debug, PartialEq)]
pub struct Towing {
    /// The soil.
    pub soil: Soil,
    /// The body.
    pub body: Body,
    /// Weight (of the whole assembly) or sinkage.
    pub load: Load,
    /// What happens at the axle.
    pub drive: Drive,
    /// Gravity [m/s²]; only to turn weights into masses.
    pub gravity: f64,
    /// Fraction of the swept soil that heaps up before the disc, 0 to 1.
    pub heap_fraction: f64,
    /// Rise of the ground before the disc [rad].
    pub backfill: f64,
    /// Correction factors of the bearing model.
    pub method: Method,
    /// Several discs on one axle, if so.
    pub assembly: Option<Assembly>,
    /// Young's modulus of the soil [Pa], for the group Ē only.
    pub elastic_modulus: Option<f64>,
    /// Plate constants, for Bekker and Wong–Reece; their c and φ are replaced by those of the soil.
    pub terrain: Option<PressureSinkage>,
    /// Cone index [Pa], for Wismer–Luth and Brixius.
    pub cone_index: Option<f64>,
    /// Pressure over depth under a level plate [N/m³], for 2-D RFT; otherwise 3D-RFT's own is used.
    pub plate_stiffness: Option<f64>,
}

/// A number of the case that a curve or an uncertainty may change; units as in [`Towing`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Parameter {
    /// φ [rad]; the dilation angle is kept, but never above φ.
    FrictionAngle,
    /// ψ [rad].
    DilationAngle,
    /// c [Pa].
    Cohesion,
    /// γ [N/m³].
    UnitWeight,
    /// μ.
    BodyFriction,
    /// d [m]; of a disc alone, as the thickness.
    Diameter,
    /// t [m].
    Thickness,
    /// Angle by which a block is turned about y [rad], its top towards the tow if positive.
    Orientation,
    /// W [N]; releases a held sinkage.
    Weight,
    /// z [m]; holds the body.
    Sinkage,
    /// The [`crate::slip`]; replaces the drive.
    Slip,
    /// Torque that brakes the axle [N m]; replaces the drive.
    BrakeTorque,
    /// Heap fraction χ.
    HeapFraction,
    /// β [rad].
    Backfill,
    /// Cone index [Pa].
    ConeIndex,
    /// Pressure over depth under a level plate [N/m³].
    PlateStiffness,
    /// Sinkage exponent n; as the other plate constants it changes only a case that has plate constants.
    PlateExponent,
    /// k_c [N/m^{n+1}].
    PlateCohesive,
    /// k_φ [N/m^{n+2}].
    PlateFrictional,
    /// K [m].
    ShearModulus,
}

impl Towing {
    /// A single body on level ground, Earth gravity, nothing measured beyond the soil.
    #[must_use]
    pub fn new(soil: Soil, body: impl Into<Body>, load: Load, drive: Drive) -> Self {
        Self {
            soil,
            body: body.into(),
            load,
            drive,
            gravity: 9.81,
            heap_fraction: 0.0,
            backfill: 0.0,
            method: Method::default(),
            assembly: None,
            elastic_modulus: None,
            terrain: None,
            cone_index: None,
            plate_stiffness: None,
        }
    }

    /// Refuses a case that no model can take.
    ///
    /// # Errors
    /// Naming the first input out of range, with its valid range.
    pub fn check(&self) -> Answer<()> {
        self.soil.check()?;
        self.body.check()?;
        self.drive.check()?;
        match self.load {
            Load::Weight(weight) => positive("weight [N]", weight)?,
            Load::Sinkage(z) => within("sinkage [m]", z, f64::MIN_POSITIVE, self.body.deepest())?,
        };
        positive("gravity [m/s^2]", self.gravity)?;
        within("heap fraction", self.heap_fraction, 0.0, 1.0)?;
        within("backfill [rad]", self.backfill, -10_f64.to_radians(), 25_f64.to_radians())?;
        if let (Some(assembly), Some(disc)) = (self.assembly, self.body.disc()) {
            assembly.check(disc)?;
        }
        if let Some(modulus) = self.elastic_modulus {
            positive("elastic modulus [Pa]", modulus)?;
        }
        Ok(())
    }

    /// The same case with one number changed; the dilation angle is kept at or below the friction angle.
    #[must_use]
    pub fn with(&self, parameter: Parameter, value: f64) -> Self {
        let mut case = self.clone();
        match parameter {
            Parameter::FrictionAngle => {
                case.soil.friction_angle = value;
                // An associated soil stays associated, any other keeps its dilation.
                let associated = self.soil.dilation_angle >= self.soil.friction_angle;
                case.soil.dilation_angle =
                    if associated { value } else { self.soil.dilation_angle.min(value) };
            }
            Parameter::DilationAngle => case.soil.dilation_angle = value,
            Parameter::Cohesion => case.soil.cohesion = value,
            Parameter::UnitWeight => case.soil.unit_weight = value,
            Parameter::BodyFriction => case.soil.body_friction = value,
            Parameter::Diameter => case.change_disc(|disc| disc.diameter = value),
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
            Parameter::HeapFraction => case.heap_fraction = value,
            Parameter::Backfill => case.backfill = value,
            Parameter::ConeIndex => case.cone_index = Some(value),
            Parameter::PlateStiffness => case.plate_stiffness = Some(value),
            Parameter::PlateExponent => case.change_terrain(|t| t.exponent = value),
            Parameter::PlateCohesive => case.change_terrain(|t| t.cohesive = value),
            Parameter::PlateFrictional => case.change_terrain(|t| t.frictional = value),
            Parameter::ShearModulus => case.change_terrain(|t| t.shear_modulus = value),
        }
        case
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
