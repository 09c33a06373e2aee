//! The soil as typed: its law, and what follows from its weight.

use super::{COMMON, KEYS, Law, Soil, at_rest, law};
use crate::key::{checked, missing};
use crate::slope::Slope;
use input::key::read;
use input::problem::Problems;
use input::typed::Section;

/// Where soil lies.
#[derive(Clone, Copy)]
pub(crate) struct Conditions {
    /// Weight per mass of soil [m/s²], which water makes less.
    pub(crate) gravity: f64,
    /// Slope of the ground.
    pub(crate) slope: Slope,
}

/// The soil of a section, or `None` with problems added.
pub(crate) fn soil(section: &Section, conditions: Conditions, problems: &mut Problems) -> Option<Soil> {
    let Conditions { gravity, slope } = conditions;
    let elastic = read(COMMON, Soil::default(), section, problems);
    let before = problems.len();
    let law = typed_law(section, problems).filter(|law| {
        law.check(&section.path, problems);
        problems.len() == before
    });
    let weight = match section.has("relative_density") {
        true => law.and_then(|law| weight_of_sand(section, gravity, &law, problems)),
        false => weight(section, gravity, problems),
    };
    let (elastic, [unit_weight, density], law) = (elastic?, weight?, law?);
    let k0 = section.number_or("k0", at_rest::k0(&slope, law.level_k0(elastic.poisson_ratio), &law))?;
    let soil = Soil { law, density, unit_weight, k0, ..elastic };
    checked(soil, problems, |soil, problems| soil.check(&section.path, problems))
}

/// Unit weight [N/m³] and density [kg/m³]; one may follow from the other.
fn weight(section: &Section, gravity: f64, problems: &mut Problems) -> Option<[f64; 2]> {
    let (gamma, density) = (section.number("unit_weight"), section.number("density"));
    match (gamma, density) {
        (Some(gamma), Some(density)) => Some([gamma, density]),
        (None, Some(density)) if !section.has("unit_weight") => Some([density * gravity, density]),
        (Some(gamma), None) if !section.has("density") => {
            if gamma > 0.0 && gravity > 0.0 {
                return Some([gamma, gamma / gravity]);
            }
            let message = "weightless soil, or no gravity: the density does not follow from the unit weight";
            let cure = format!("add  density = \"2000 kg/m^3\"  to [{}]", section.path);
            problems.add(section.at("unit_weight"), message, cure);
            None
        }
        _ => {
            if !section.has("density") {
                missing(KEYS, section, "unit_weight", problems);
            }
            None
        }
    }
}

/// Unit weight [N/m³] and density [kg/m³] of sand at a relative density.
fn weight_of_sand(section: &Section, gravity: f64, law: &Law, problems: &mut Problems) -> Option<[f64; 2]> {
    for key in ["unit_weight", "density"].iter().filter(|key| section.has(key)) {
        let message = format!("`{key}` follows from relative_density");
        problems.add(section.at(key), message, "give one of the two");
    }
    let density = law.density_at(section.number("relative_density")?)?;
    Some([density * gravity, density])
}

/// The law with its parameters; those that only other laws have are reported, since they would have no
/// effect.
fn typed_law(section: &Section, problems: &mut Problems) -> Option<Law> {
    missing(KEYS, section, "law", problems);
    let word = section.text("law")?;
    for key in law::KEYS.iter().filter(|key| section.has(key.name) && !law::has_key(&word, key.name)) {
        let message = format!("`{}` does not apply to law = \"{word}\"", key.name);
        problems.add(section.at(key.name), message, "remove it, or choose another law");
    }
    law::typed(&word, section, problems)
}
