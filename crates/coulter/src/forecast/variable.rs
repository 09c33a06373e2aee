//! The numbers of a case that a curve or a spread may change, by the names that the case file has for them.

use super::Setting;
use crate::case::quantity::{ANGLE, FORCE, LENGTH, Measure, STRESS, TORQUE, UNIT_WEIGHT};
use analytic::Towing;
use analytic::forecast::Parameter;

/// One of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variable {
    /// Which.
    pub parameter: Parameter,
    /// Its section in the case file; nothing where the case file does not know it.
    pub section: &'static str,
    /// Its name there.
    pub key: &'static str,
    /// What it measures; none for a bare number.
    pub measure: Option<Measure>,
    /// What a chart calls it, with the unit that it is shown in.
    pub label: &'static str,
    /// Name of the unit that it is shown in.
    pub unit: &'static str,
    /// That unit in SI units.
    pub size: f64,
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

const fn variable(
    parameter: Parameter,
    names: (&'static str, &'static str),
    measure: Option<Measure>,
    label: &'static str,
    unit: (&'static str, f64),
) -> Variable {
    Variable { parameter, section: names.0, key: names.1, measure, label, unit: unit.0, size: unit.1 }
}

const BARE: (&str, f64) = ("-", 1.0);
const ALL: [Variable; 13] = [
    variable(Parameter::Sinkage, ("", "z"), Some(LENGTH), "sinkage z", ("m", 1.0)),
    variable(
        Parameter::FrictionAngle,
        ("soil", "friction_angle"),
        Some(ANGLE),
        "friction angle φ",
        ("deg", DEGREE),
    ),
    variable(
        Parameter::DilationAngle,
        ("soil", "dilation_angle"),
        Some(ANGLE),
        "dilation angle ψ",
        ("deg", DEGREE),
    ),
    variable(Parameter::Cohesion, ("soil", "cohesion"), Some(STRESS), "cohesion c", ("Pa", 1.0)),
    variable(
        Parameter::UnitWeight,
        ("soil", "unit_weight"),
        Some(UNIT_WEIGHT),
        "unit weight γ",
        ("kN/m^3", 1e3),
    ),
    variable(Parameter::BodyFriction, ("body", "friction"), None, "friction μ", BARE),
    variable(Parameter::Diameter, ("body", "diameter"), Some(LENGTH), "diameter d", ("m", 1.0)),
    variable(Parameter::Thickness, ("body", "thickness"), Some(LENGTH), "thickness t", ("m", 1.0)),
    variable(Parameter::Weight, ("body", "weight"), Some(FORCE), "weight W", ("N", 1.0)),
    variable(Parameter::Slip, ("", "slip"), None, "slip ωr/v − 1", BARE),
    variable(Parameter::BrakeTorque, ("", "brake_torque"), Some(TORQUE), "brake torque M", ("N m", 1.0)),
    variable(Parameter::HeapFraction, ("", "heap"), None, "heap fraction χ", BARE),
    variable(Parameter::Backfill, ("", "backfill"), Some(ANGLE), "rise of the ground β", ("deg", DEGREE)),
];

/// Every variable.
#[must_use]
pub fn variables() -> &'static [Variable] {
    &ALL
}

/// The variable that `key` names: `Z`, `soil.friction_angle`, `body.disc.weight`, or the last part alone.
#[must_use]
pub fn find(key: &str, discs: &[String]) -> Option<Variable> {
    if matches!(key, "Z" | "z" | "sinkage") {
        return Some(ALL[0]);
    }
    let parts: Vec<&str> = key.split('.').collect();
    let fits = |v: &&Variable| match parts[..] {
        [name] => name == v.key,
        ["soil", name] => v.section == "soil" && name == v.key,
        ["body", body, name] => v.section == "body" && name == v.key && discs.iter().any(|d| d == body),
        _ => false,
    };
    ALL.iter().find(fits).copied()
}

impl Variable {
    /// The case with this number changed. A weight is that of one disc, without loads besides it.
    #[must_use]
    pub fn set(&self, setting: &Setting, value: f64) -> Towing {
        setting.towing.with(self.parameter, self.model_value(setting, value))
    }

    /// The value that the models know it by.
    pub(super) fn model_value(&self, setting: &Setting, value: f64) -> f64 {
        if self.parameter == Parameter::Weight {
            value * setting.discs.len() as f64 + setting.extra_load
        } else {
            value
        }
    }

    /// Its value in the case; none for what the case leaves open.
    #[must_use]
    pub fn value(&self, setting: &Setting) -> Option<f64> {
        use analytic::Load;
        let towing = &setting.towing;
        match self.parameter {
            Parameter::FrictionAngle => Some(towing.soil.friction_angle),
            Parameter::DilationAngle => Some(towing.soil.dilation_angle),
            Parameter::Cohesion => Some(towing.soil.cohesion),
            Parameter::UnitWeight => Some(towing.soil.unit_weight),
            Parameter::BodyFriction => Some(towing.soil.body_friction),
            Parameter::Diameter => Some(towing.disc.diameter),
            Parameter::Thickness => Some(towing.disc.thickness),
            Parameter::HeapFraction => Some(towing.heap_fraction),
            Parameter::Backfill => Some(towing.backfill),
            Parameter::Weight => match towing.load {
                Load::Weight(weight) => Some((weight - setting.extra_load) / setting.discs.len() as f64),
                Load::Sinkage(_) => None,
            },
            Parameter::Sinkage => match towing.load {
                Load::Sinkage(z) => Some(z),
                Load::Weight(_) => None,
            },
            Parameter::Slip | Parameter::BrakeTorque => None,
        }
    }
}
