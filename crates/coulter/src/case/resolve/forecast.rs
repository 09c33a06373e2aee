//! The parameters of the closed-form models.

use crate::case::missing::required;
use crate::case::problem::Problems;
use crate::case::resolved::{Factors, Measured, Plate, Plough};
use crate::case::typed::Section;
use analytic::wheel::{CMU_SAND, TERRAINS, Terrain};

/// The section `[forecast]`, or `None` with problems added.
pub(super) fn measured(section: &Section, problems: &mut Problems) -> Option<Measured> {
    let before = problems.len();
    let plate = plate(section, problems);
    let factors = match section.text("factors")?.as_str() {
        "hansen-vesic" => Factors::HansenVesic,
        "lyamin" => Factors::Lyamin,
        _ => Factors::Meyerhof,
    };
    let measured = Measured {
        plate,
        cone_index: section.number("cone_index"),
        plate_stiffness: section.number("plate_stiffness"),
        bow_wave: section.number("bow_wave")?,
        backfill: section.number("backfill")?,
        factors,
        plough: plough(section, problems),
    };
    (problems.len() == before).then_some(measured)
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
            let cure = "add  terrain = \"LETE sand\"  or another published soil, or sinkage_exponent, cohesive_modulus and \
                 frictional_modulus";
            problems.add(section.at("shear_deformation_modulus"), message, cure);
        }
        return None;
    }
    let exponent = required(section, "sinkage_exponent", problems);
    let cohesive = required(section, "cohesive_modulus", problems);
    let frictional = required(section, "frictional_modulus", problems);
    Some(Plate {
        name: None,
        exponent: exponent?,
        cohesive: cohesive?,
        frictional: frictional?,
        shear_deformation_modulus: section.number("shear_deformation_modulus")?,
    })
}
