//! The numbers of a case that can be varied or be uncertain, with their names in the case file.

use super::model_input::ModelInput;
use analytic::Towing;
use analytic::forecast::{Body, Outline, Parameter};
use case::keys::Kind;
use input::quantity::{ANGLE, FORCE, LENGTH, STRESS, TORQUE, UNIT_WEIGHT};

/// A number that can be varied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variable {
    /// The parameter of the models.
    pub parameter: Parameter,
    /// Section of the variable in the case file; empty where it is not a key there.
    pub section: &'static str,
    /// Key of the variable in that section.
    pub key: &'static str,
    /// What values the variable may take.
    pub kind: Kind,
    /// Name of the variable in charts.
    pub label: &'static str,
    /// Unit in which the variable is shown.
    pub unit: &'static str,
    /// Size of that unit in SI units.
    pub size: f64,
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

const fn variable(
    parameter: Parameter,
    names: (&'static str, &'static str),
    kind: Kind,
    label: &'static str,
    unit: (&'static str, f64),
) -> Variable {
    Variable { parameter, section: names.0, key: names.1, kind, label, unit: unit.0, size: unit.1 }
}

/// Keys of the strength of undrained clay: s_u of Tresca's law, σ_y = √3 s_u of von Mises'.
const SHEAR_STRENGTH: &str = "shear_strength";
const YIELD_STRESS: &str = "yield_stress";
const BARE: (&str, f64) = ("-", 1.0);
const ALL: [Variable; 22] = [
    variable(Parameter::Sinkage, ("", "z"), Kind::Quantity(LENGTH), "sinkage z", ("m", 1.0)),
    variable(
        Parameter::FrictionAngle,
        ("soil", "friction_angle"),
        Kind::Quantity(ANGLE),
        "friction angle φ",
        ("deg", DEGREE),
    ),
    variable(
        Parameter::DilationAngle,
        ("soil", "dilation_angle"),
        Kind::Quantity(ANGLE),
        "dilation angle ψ",
        ("deg", DEGREE),
    ),
    variable(Parameter::Cohesion, ("soil", "cohesion"), Kind::Quantity(STRESS), "cohesion c", ("Pa", 1.0)),
    variable(
        Parameter::Cohesion,
        ("soil", SHEAR_STRENGTH),
        Kind::Quantity(STRESS),
        "undrained shear strength s_u",
        ("kPa", 1e3),
    ),
    variable(
        Parameter::Cohesion,
        ("soil", YIELD_STRESS),
        Kind::Quantity(STRESS),
        "yield stress σ_y",
        ("kPa", 1e3),
    ),
    variable(
        Parameter::UnitWeight,
        ("soil", "unit_weight"),
        Kind::Quantity(UNIT_WEIGHT),
        "unit weight γ",
        ("kN/m^3", 1e3),
    ),
    variable(Parameter::BodyFriction, ("body", "friction"), Kind::Number, "friction μ", BARE),
    variable(Parameter::Diameter, ("body", "diameter"), Kind::Quantity(LENGTH), "diameter d", ("m", 1.0)),
    variable(Parameter::Thickness, ("body", "thickness"), Kind::Quantity(LENGTH), "thickness t", ("m", 1.0)),
    variable(Parameter::Orientation, ("body", "pitch"), Kind::Quantity(ANGLE), "pitch", ("deg", DEGREE)),
    variable(Parameter::Weight, ("body", "weight"), Kind::Quantity(FORCE), "weight W", ("N", 1.0)),
    variable(Parameter::Slip, ("", "slip"), Kind::Number, "slip s", BARE),
    variable(
        Parameter::BrakeTorque,
        ("", "brake_torque"),
        Kind::Quantity(TORQUE),
        "brake torque M",
        ("N m", 1.0),
    ),
    variable(Parameter::BowWaveFraction, ("forecast", "bow_wave"), Kind::Number, "bow wave fraction χ", BARE),
    variable(
        Parameter::Backfill,
        ("forecast", "backfill"),
        Kind::Quantity(ANGLE),
        "rise of the ground β",
        ("deg", DEGREE),
    ),
    variable(
        Parameter::ConeIndex,
        ("forecast", "cone_index"),
        Kind::Quantity(STRESS),
        "cone index CI",
        ("kPa", 1e3),
    ),
    variable(
        Parameter::PlateStiffness,
        ("forecast", "plate_stiffness"),
        Kind::Quantity(UNIT_WEIGHT),
        "plate stiffness p/z",
        ("kN/m^3", 1e3),
    ),
    variable(
        Parameter::PlateExponent,
        ("forecast", "sinkage_exponent"),
        Kind::Number,
        "sinkage exponent n",
        BARE,
    ),
    variable(
        Parameter::PlateCohesive,
        ("forecast", "cohesive_modulus"),
        Kind::Modulus(1),
        "cohesive modulus k_c",
        ("kN/m^(n+1)", 1e3),
    ),
    variable(
        Parameter::PlateFrictional,
        ("forecast", "frictional_modulus"),
        Kind::Modulus(2),
        "frictional modulus k_φ",
        ("kN/m^(n+2)", 1e3),
    ),
    variable(
        Parameter::ShearModulus,
        ("forecast", "shear_deformation_modulus"),
        Kind::Quantity(LENGTH),
        "shear deformation modulus K",
        ("mm", 1e-3),
    ),
];

/// Every variable.
#[must_use]
pub fn variables() -> &'static [Variable] {
    &ALL
}

/// The variable that `key` names: `Z`, `soil.friction_angle`, `body.disc.weight`, or the last name alone.
#[must_use]
pub fn find(key: &str, bodies: &[String]) -> Option<Variable> {
    if matches!(key, "Z" | "z" | "sinkage") {
        return Some(ALL[0]);
    }
    let names: Vec<&str> = key.split('.').collect();
    let fits = |v: &&Variable| match names[..] {
        // The length of a roller across the tow is what the thickness is for a disc.
        ["length"] => v.parameter == Parameter::Thickness,
        ["body", body, "length"] => v.parameter == Parameter::Thickness && bodies.iter().any(|b| b == body),
        [name] => name == v.key,
        [section @ ("soil" | "forecast"), name] => v.section == section && name == v.key,
        ["body", body, name] => v.section == "body" && name == v.key && bodies.iter().any(|b| b == body),
        _ => false,
    };
    ALL.iter().find(fits).copied()
}

impl Variable {
    /// The input with the variable set to a value. A weight is that of one disc, without additional loads.
    #[must_use]
    pub fn set(&self, input: &ModelInput, value: f64) -> Towing {
        input.towing.with(self.parameter, self.model_value(input, value))
    }

    /// Key of the variable with its section, as in the case.
    #[must_use]
    pub fn dotted(&self, input: &ModelInput) -> String {
        match self.section {
            "" => self.key.to_owned(),
            "body" => format!("body.{}.{}", input.bodies.first().map_or("disc", String::as_str), self.key),
            section => format!("{section}.{}", self.key),
        }
    }

    /// Whether a model of such a body uses the variable.
    #[must_use]
    pub fn belongs(&self, input: &ModelInput) -> bool {
        let is_clay = input.towing.soil.is_undrained();
        let is_strength_of_clay = matches!(self.key, SHEAR_STRENGTH | YIELD_STRESS);
        match self.parameter {
            Parameter::FrictionAngle | Parameter::DilationAngle => !is_clay,
            Parameter::Cohesion => is_strength_of_clay == is_clay,
            Parameter::Sinkage | Parameter::UnitWeight | Parameter::BodyFriction | Parameter::Weight => true,
            Parameter::PlateStiffness => !is_clay,
            _ => match input.towing.body {
                Body::Disc(_) if input.towing.pressed => {
                    matches!(self.parameter, Parameter::Diameter | Parameter::Thickness)
                }
                Body::Disc(_) => self.parameter != Parameter::Orientation,
                Body::Block(_) => matches!(self.parameter, Parameter::Orientation | Parameter::Backfill),
                Body::Faceted(_) => matches!(self.parameter, Parameter::Slip | Parameter::BrakeTorque),
                Body::Plate(plate) if self.parameter == Parameter::Diameter => {
                    plate.outline == Outline::Circle
                }
                Body::Pipe(_) => self.parameter == Parameter::Diameter,
                Body::Cone(_) => false,
                Body::Plate(_) => matches!(
                    self.parameter,
                    Parameter::PlateExponent | Parameter::PlateCohesive | Parameter::PlateFrictional
                ),
            },
        }
    }

    /// Whether varying the number has an effect: a plate constant needs the others to be given.
    #[must_use]
    pub fn has_effect(&self, input: &ModelInput) -> bool {
        let of_plate = matches!(
            self.parameter,
            Parameter::PlateExponent
                | Parameter::PlateCohesive
                | Parameter::PlateFrictional
                | Parameter::ShearModulus
        );
        !of_plate || input.towing.terrain.is_some()
    }

    /// The value in the input of the models.
    pub(super) fn model_value(&self, input: &ModelInput, value: f64) -> f64 {
        match self.parameter {
            Parameter::Weight => value * input.bodies.len() as f64 + input.extra_load,
            Parameter::Orientation if input.mirrored => -value,
            _ if self.key == YIELD_STRESS => value / 3_f64.sqrt(),
            _ => value,
        }
    }

    /// Value of the variable in the case; `None` where the case does not define it.
    #[must_use]
    pub fn value(&self, input: &ModelInput) -> Option<f64> {
        use analytic::Load;
        let towing = &input.towing;
        match self.parameter {
            Parameter::FrictionAngle => Some(towing.soil.friction_angle),
            Parameter::DilationAngle => Some(towing.soil.dilation_angle),
            Parameter::Cohesion if self.key == YIELD_STRESS => Some(towing.soil.cohesion * 3_f64.sqrt()),
            Parameter::Cohesion => Some(towing.soil.cohesion),
            Parameter::UnitWeight => Some(towing.soil.unit_weight),
            Parameter::BodyFriction => Some(towing.soil.body_friction),
            Parameter::Diameter => match &towing.body {
                Body::Disc(disc) => Some(disc.diameter),
                Body::Plate(plate) if plate.outline == Outline::Circle => Some(plate.width),
                Body::Pipe(pipe) => Some(pipe.diameter),
                _ => None,
            },
            Parameter::Thickness => towing.body.disc().map(|disc| disc.thickness),
            Parameter::Orientation => {
                towing.body.block().map(|block| self.model_value(input, block.orientation))
            }
            Parameter::BowWaveFraction => Some(towing.bow_wave_fraction),
            Parameter::Backfill => Some(towing.backfill),
            Parameter::Weight => match towing.load {
                Load::Weight(weight) => Some((weight - input.extra_load) / input.bodies.len() as f64),
                Load::Sinkage(_) => None,
            },
            Parameter::Sinkage => match towing.load {
                Load::Sinkage(z) => Some(z),
                Load::Weight(_) => None,
            },
            Parameter::Slip
            | Parameter::BrakeTorque
            | Parameter::ResistanceFactor
            | Parameter::ThrustFactor => None,
            Parameter::ConeIndex => towing.cone_index,
            Parameter::PlateStiffness => towing.plate_stiffness,
            Parameter::PlateExponent => towing.terrain.map(|t| t.exponent),
            Parameter::PlateCohesive => towing.terrain.map(|t| t.cohesive),
            Parameter::PlateFrictional => towing.terrain.map(|t| t.frictional),
            Parameter::ShearModulus => towing.terrain.map(|t| t.shear_modulus),
        }
    }
}
