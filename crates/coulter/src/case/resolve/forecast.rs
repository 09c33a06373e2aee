//! The parameters of the closed-form models.

use crate::case::problem::Problems;
use crate::case::ranges::{self, Allowed, BACKFILL, EXPONENT, FRACTION, NOT_NEGATIVE, POSITIVE};
use crate::case::resolved::{Factors, Measured, Plate};
use crate::case::typed::Section;
use analytic::wheel::{CMU_SAND, TERRAINS, Terrain};

/// Default shear deformation modulus [m]; recalled for sand: 10 to 25 mm.
const SHEAR_DEFORMATION_MODULUS: f64 = 0.015;

/// The section `[forecast]`, or `None` with problems added.
pub(super) fn measured(section: &Section, problems: &mut Problems) -> Option<Measured> {
    let before = problems.len();
    let plate = plate(section, problems);
    let mut given = |key, allowed: &Allowed| ranges::given(section, key, allowed, problems);
    let (cone_index, plate_stiffness) = (given("cone_index", &POSITIVE), given("plate_stiffness", &POSITIVE));
    let (bow_wave, backfill) = (given("bow_wave", &FRACTION), given("backfill", &BACKFILL));
    let factors = match section.text("factors") {
        Some(typed) if typed.value == "hansen-vesic" => Factors::HansenVesic,
        Some(typed) if typed.value == "lyamin" => Factors::Lyamin,
        _ => Factors::Meyerhof,
    };
    let (bow_wave, backfill) = (bow_wave.unwrap_or(0.0), backfill.unwrap_or(0.0));
    (problems.len() == before).then_some(Measured {
        plate,
        cone_index,
        plate_stiffness,
        bow_wave,
        backfill,
        factors,
    })
}

const CONSTANTS: [&str; 3] = ["sinkage_exponent", "cohesive_modulus", "frictional_modulus"];

/// Pressure–sinkage parameters, by the name of a published soil or as typed.
fn plate(section: &Section, problems: &mut Problems) -> Option<Plate> {
    let shear_deformation_modulus = ranges::given(section, "shear_deformation_modulus", &POSITIVE, problems);
    if let Some(name) = section.text("terrain") {
        for key in CONSTANTS.iter().filter(|key| section.has(key)) {
            let message = format!("`{key}` is given, and `terrain` provides one too");
            problems.add(section.location_of(key), message, "remove one of them");
        }
        let Terrain { name, soil } = *TERRAINS.iter().chain([&CMU_SAND]).find(|t| t.name == name.value)?;
        return Some(Plate {
            name: Some(name.to_owned()),
            exponent: soil.exponent,
            cohesive: soil.cohesive,
            frictional: soil.frictional,
            shear_deformation_modulus: shear_deformation_modulus.unwrap_or(soil.shear_modulus),
        });
    }
    if !CONSTANTS.iter().any(|key| section.has(key)) {
        if section.has("shear_deformation_modulus") {
            let message = "`shear_deformation_modulus` does nothing without the other plate constants";
            let cure = "add  terrain = \"LETE sand\"  or another published soil, or sinkage_exponent, cohesive_modulus and \
                 frictional_modulus";
            problems.add(section.location_of("shear_deformation_modulus"), message, cure);
        }
        return None;
    }
    let exponent = ranges::required(section, "sinkage_exponent", &EXPONENT, problems);
    let cohesive = ranges::required(section, "cohesive_modulus", &NOT_NEGATIVE, problems);
    let frictional = ranges::required(section, "frictional_modulus", &POSITIVE, problems);
    Some(Plate {
        name: None,
        exponent: exponent?,
        cohesive: cohesive?,
        frictional: frictional?,
        shear_deformation_modulus: shear_deformation_modulus.unwrap_or(SHEAR_DEFORMATION_MODULUS),
    })
}
