//! Parameters of the closed-form models: what was measured of a soil.

use crate::key::allowed::{BACKFILL, EXPONENT, FRACTION, NOT_NEGATIVE, POSITIVE};
use crate::key::words::{FACTORS, PUBLISHED_SOILS};
use DefaultValue::{Number, Otherwise, Quantity, Word};
use analytic::wheel::{CMU_SAND, TERRAINS, Terrain};
use input::key::{DefaultValue, Key, KeyOf, Kind, Place, declared, in_ranges, numbers, read, required};
use input::problem::Problems;
use input::quantity::{ANGLE, LENGTH, RATE_RESISTANCE, STRESS, UNIT_WEIGHT};
use input::typed::Section;
use serde::Serialize;

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

/// Pressure–sinkage parameters of Bekker, p = (k_c/b + k_φ) zⁿ, and shear deformation modulus of Janosi and
/// Hanamoto.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Plate {
    /// The published soil that the constants belong to, if any.
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

/// Keys of the closed-form models, and where their values lie.
type Field = KeyOf<Measured>;

const FIELDS: &[Field] = &[
    Field::new("terrain", Kind::Choice(&PUBLISHED_SOILS), Place::Elsewhere).derived("none").means(
        "Soil whose published pressure–sinkage parameters n, k_c, k_φ and K are used (Bekker, \
             Wong–Reece).",
    ),
    Field::new(
        "sinkage_exponent",
        Kind::Number,
        Place::Derived(|own| Some(&mut own.plate.as_mut()?.exponent)),
    )
    .derived("none")
    .within(EXPONENT)
    .means("Bekker's sinkage exponent n of p = (k_c/b + k_φ) zⁿ."),
    Field::new(
        "cohesive_modulus",
        Kind::Modulus(1),
        Place::Derived(|own| Some(&mut own.plate.as_mut()?.cohesive)),
    )
    .derived("none")
    .within(NOT_NEGATIVE)
    .means("Bekker's cohesive modulus k_c."),
    Field::new(
        "frictional_modulus",
        Kind::Modulus(2),
        Place::Derived(|own| Some(&mut own.plate.as_mut()?.frictional)),
    )
    .derived("none")
    .within(POSITIVE)
    .means("Bekker's frictional modulus k_φ."),
    Field::new(
        "shear_deformation_modulus",
        Kind::Quantity(LENGTH),
        Place::Derived(|own| Some(&mut own.plate.as_mut()?.shear_deformation_modulus)),
    )
    .default(Otherwise { derived: "that of `terrain`", quantity: "15 mm" })
    .within(POSITIVE)
    .means("Janosi and Hanamoto's shear deformation modulus K (Wong–Reece); sand: 10 to 25 mm."),
    Field::new("cone_index", Kind::Quantity(STRESS), Place::Optional(|own| &mut own.cone_index))
        .derived("none")
        .within(POSITIVE)
        .means("Cone index CI (Wismer–Luth, Brixius)."),
    Field::new(
        "plate_stiffness",
        Kind::Quantity(UNIT_WEIGHT),
        Place::Optional(|own| &mut own.plate_stiffness),
    )
    .derived("that of 3D-RFT")
    .within(POSITIVE)
    .means("Pressure over depth under a level plate pushed down (2-D RFT)."),
    Field::new("bow_wave", Kind::Number, Place::Number(|own| &mut own.bow_wave))
        .default(Number(0.0))
        .within(FRACTION)
        .means("Bow wave: fraction χ of the displaced soil that accumulates in front of the disc."),
    Field::new("backfill", Kind::Quantity(ANGLE), Place::Number(|own| &mut own.backfill))
        .default(Quantity("0 deg"))
        .within(BACKFILL)
        .means("Inclination β of the ground in front of the disc, positive when it rises (PW)."),
    Field::new("plough_weight_coefficient", Kind::Interval, Place::Elsewhere)
        .derived("none")
        .within(NOT_NEGATIVE)
        .means(
            "C_w of the tow force of a plough under water, C_w W′ + C_s γ′ D³ + C_d v D²: friction over its \
             weight in water, least and most.",
        ),
    Field::new("plough_slow_coefficient", Kind::Interval, Place::Elsewhere)
        .derived("none")
        .within(NOT_NEGATIVE)
        .means("C_s of the same: slow resistance over γ′ D³, D the depth, least and most."),
    Field::new("plough_rate_coefficient", Kind::Range(RATE_RESISTANCE), Place::Elsewhere)
        .derived("none")
        .within(NOT_NEGATIVE)
        .means("C_d of the same: growth of the resistance with the speed over D², least and most."),
    Field::new(
        "factors",
        Kind::Choice(&FACTORS),
        Place::Word(|own, word| {
            own.factors = match word {
                "hansen-vesic" => Factors::HansenVesic,
                "lyamin" => Factors::Lyamin,
                _ => Factors::Meyerhof,
            };
        }),
    )
    .default(Word("meyerhof"))
    .means("Shape, depth and inclination factors of the bearing capacity (BC)."),
];

impl Measured {
    pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    /// The parameters of the section `[forecast]`, or `None` with problems added.
    pub(crate) fn typed(section: &Section, problems: &mut Problems) -> Option<Self> {
        let before = problems.len();
        let start = Self { plate: plate(section, problems), ..Self::default() };
        let own = read(FIELDS, start, section, problems)?;
        let own = Self { plough: plough(section, problems), ..own };
        (problems.len() == before).then_some(own)
    }

    /// Reports numbers that are out of range.
    pub(crate) fn check(&self, problems: &mut Problems) {
        in_ranges("forecast", &numbers(FIELDS, self), problems);
    }
}

const COEFFICIENTS: [&str; 3] =
    ["plough_weight_coefficient", "plough_slow_coefficient", "plough_rate_coefficient"];

/// Coefficients of a plough: all three or none.
fn plough(section: &Section, problems: &mut Problems) -> Option<Plough> {
    if !COEFFICIENTS.iter().any(|key| section.has(key)) {
        return None;
    }
    let [weight, slow, rate] = COEFFICIENTS.map(|key| {
        if !section.has(key) {
            let message =
                format!("`{key}` is missing: the tow force of a plough needs all three coefficients");
            problems.add(section.at(key), message, "give its least and its most, equal if it is known");
        }
        let list = section.list(key)?;
        let ends: [f64; 2] = list.try_into().ok()?;
        if ends[0] > ends[1] {
            problems.add(section.at(key), format!("`{key}` starts above its end"), "write the least first");
        }
        Some(ends)
    });
    Some(Plough { weight: weight?, slow: slow?, rate: rate? })
}

const CONSTANTS: [&str; 3] = ["sinkage_exponent", "cohesive_modulus", "frictional_modulus"];

/// Pressure–sinkage parameters, by the name of a published soil or as typed.
fn plate(section: &Section, problems: &mut Problems) -> Option<Plate> {
    if let Some(name) = section.text("terrain") {
        for key in CONSTANTS.iter().filter(|key| section.has(key)) {
            let message = format!("`{key}` is given, and `terrain` provides one too");
            problems.add(section.at(key), message, "remove one of them");
        }
        let Terrain { name, soil } = *TERRAINS.iter().chain([&CMU_SAND]).find(|t| t.name == name)?;
        return Some(Plate {
            name: Some(name.to_owned()),
            exponent: soil.exponent,
            cohesive: soil.cohesive,
            frictional: soil.frictional,
            shear_deformation_modulus: section.number_or("shear_deformation_modulus", soil.shear_modulus)?,
        });
    }
    if !CONSTANTS.iter().any(|key| section.has(key)) {
        if section.has("shear_deformation_modulus") {
            let message = "`shear_deformation_modulus` does nothing without the other plate constants";
            let cure = "add  terrain = \"LETE sand\"  or another published soil, or sinkage_exponent, \
                        cohesive_modulus and frictional_modulus";
            problems.add(section.at("shear_deformation_modulus"), message, cure);
        }
        return None;
    }
    let exponent = required(FIELDS, "sinkage_exponent", section, problems);
    let cohesive = required(FIELDS, "cohesive_modulus", section, problems);
    let frictional = required(FIELDS, "frictional_modulus", section, problems);
    Some(Plate {
        name: None,
        exponent: exponent?,
        cohesive: cohesive?,
        frictional: frictional?,
        shear_deformation_modulus: section.number("shear_deformation_modulus")?,
    })
}
