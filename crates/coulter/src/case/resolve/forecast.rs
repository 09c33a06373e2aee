//! What the closed forms know of the soil besides its strength.

use crate::case::problem::Problems;
use crate::case::ranges::{self, Allowed, BACKFILL, EXPONENT, FRACTION, NOT_NEGATIVE, POSITIVE};
use crate::case::resolved::{Factors, Measured, Plate};
use crate::case::schema::Section;
use analytic::wheel::{CMU_SAND, TERRAINS, Terrain};

/// Shear displacement modulus where none is given [m]; recalled for sand: 10 to 25 mm.
const SHEAR_DISPLACEMENT: f64 = 0.015;

/// The section `[forecast]`, or `None` with problems added.
pub(super) fn measured(section: &Section, problems: &mut Problems) -> Option<Measured> {
    let before = problems.len();
    let plate = plate(section, problems);
    let mut given = |key, allowed: &Allowed| ranges::given(section, key, allowed, problems);
    let (cone_index, plate_stiffness) = (given("cone_index", &POSITIVE), given("plate_stiffness", &POSITIVE));
    let (heap, backfill) = (given("heap", &FRACTION), given("backfill", &BACKFILL));
    let factors = match section.text("factors") {
        Some(typed) if typed.value == "hansen-vesic" => Factors::HansenVesic,
        Some(typed) if typed.value == "lyamin" => Factors::Lyamin,
        _ => Factors::Meyerhof,
    };
    let (heap, backfill) = (heap.unwrap_or(0.0), backfill.unwrap_or(0.0));
    (problems.len() == before).then_some(Measured {
        plate,
        cone_index,
        plate_stiffness,
        heap,
        backfill,
        factors,
    })
}

const CONSTANTS: [&str; 3] = ["plate_exponent", "plate_cohesive", "plate_frictional"];

/// Plate constants, by the name of a published soil or typed.
fn plate(section: &Section, problems: &mut Problems) -> Option<Plate> {
    let shear_displacement = ranges::given(section, "shear_displacement", &POSITIVE, problems);
    if let Some(name) = section.text("plate") {
        for key in CONSTANTS.iter().filter(|key| section.has(key)) {
            let message = format!("`{key}` is given, and `plate` has one too");
            problems.add(section.place_of(key), message, "take one of them out");
        }
        let Terrain { name, soil } = *TERRAINS.iter().chain([&CMU_SAND]).find(|t| t.name == name.value)?;
        return Some(Plate {
            name: Some(name.to_owned()),
            exponent: soil.exponent,
            cohesive: soil.cohesive,
            frictional: soil.frictional,
            shear_displacement: shear_displacement.unwrap_or(soil.shear_modulus),
        });
    }
    if !CONSTANTS.iter().any(|key| section.has(key)) {
        if section.has("shear_displacement") {
            let message = "`shear_displacement` does nothing without plate constants";
            let cure =
                "add  plate = \"LETE sand\"  or another published soil, or plate_exponent and its companions";
            problems.add(section.place_of("shear_displacement"), message, cure);
        }
        return None;
    }
    let exponent = ranges::required(section, "plate_exponent", &EXPONENT, problems);
    let cohesive = ranges::required(section, "plate_cohesive", &NOT_NEGATIVE, problems);
    let frictional = ranges::required(section, "plate_frictional", &POSITIVE, problems);
    Some(Plate {
        name: None,
        exponent: exponent?,
        cohesive: cohesive?,
        frictional: frictional?,
        shear_displacement: shear_displacement.unwrap_or(SHEAR_DISPLACEMENT),
    })
}
