//! The soil: its law and its parameters.

use super::context::checked;
use crate::case::at_rest;
use crate::case::missing::{missing, required};
use crate::case::problem::Problems;
use crate::case::resolved::{ClaySoftening, Law, Layer, Potential, Soil};
use crate::case::slope::Slope;
use crate::case::typed::Section;
use crate::case::validate;
use physics::menetrey_willam::Eccentricity;

const FRICTIONAL: [&str; 8] = [
    "friction_angle",
    "dilation_angle",
    "cohesion",
    "tension_cutoff",
    "flow_potential",
    "meridional_eccentricity",
    "deviatoric_eccentricity",
    "critical_density",
];
const SMOOTH: [&str; 2] = ["meridional_eccentricity", "deviatoric_eccentricity"];
const SAND: [&str; 12] = [
    "critical_friction_angle",
    "minimum_density",
    "maximum_density",
    "relative_density",
    "relative_density_gradient",
    "bolton_q",
    "bolton_r",
    "reference_strain",
    "compression_modulus",
    "preconsolidation_pressure",
    "stiffness_limit",
    "characteristic_length",
];
const UNDRAINED: [&str; 6] = [
    "shear_strength",
    "strength_gradient",
    "sensitivity",
    "remoulding_strain",
    "rate_strengthening",
    "reference_rate",
];
const METAL: [&str; 2] = ["yield_stress", "hardening_modulus"];

/// The soil under gravity [m/s²] on a slope.
pub(super) fn soil(
    section: &Section,
    (gravity, slope): (f64, Slope),
    problems: &mut Problems,
) -> Option<Soil> {
    let young_modulus = required(section, "young_modulus", problems);
    let poisson_ratio = section.number("poisson_ratio");
    let path = &*section.path;
    let law = law(section, problems)
        .and_then(|law| checked(law, problems, |law, problems| validate::soil::law(path, law, problems)));
    let weight = match section.has("relative_density") {
        true => law.and_then(|law| weight_of_sand(section, gravity, &law, problems)),
        false => weight(section, gravity, problems),
    };
    let (young_modulus, poisson_ratio, (unit_weight, density), law) =
        (young_modulus?, poisson_ratio?, weight?, law?);
    let elastic = poisson_ratio / (1.0 - poisson_ratio);
    let level = law.friction_angle().map_or(elastic, |friction_angle| 1.0 - friction_angle.sin());
    let k0 = section.number_or("k0", at_rest::k0(&slope, level, &law))?;
    let soil = Soil { law, density, unit_weight, young_modulus, poisson_ratio, k0 };
    checked(soil, problems, |soil, problems| validate::soil::soil(path, soil, problems))
}

/// The layers from the top down.
pub(super) fn layers(
    sections: &[Section],
    conditions: (f64, Slope),
    problems: &mut Problems,
) -> Option<Vec<Layer>> {
    let layer = |section: &Section| {
        let top = required(section, "top", problems);
        let soil = soil(section, conditions, problems);
        let name = section.path.trim_start_matches("layer.").to_owned();
        Some(Layer { name, top: top?, soil: soil? })
    };
    let all: Vec<_> = sections.iter().map(layer).collect();
    let mut layers: Vec<Layer> = all.into_iter().collect::<Option<_>>()?;
    layers.sort_by(|a, b| a.top.total_cmp(&b.top));
    Some(layers)
}

/// Unit weight [N/m³] and density [kg/m³]; one may follow from the other.
fn weight(section: &Section, gravity: f64, problems: &mut Problems) -> Option<(f64, f64)> {
    let (gamma, density) = (section.number("unit_weight"), section.number("density"));
    match (gamma, density) {
        (Some(gamma), Some(density)) => Some((gamma, density)),
        (None, Some(density)) if !section.has("unit_weight") => Some((density * gravity, density)),
        (Some(gamma), None) if !section.has("density") => {
            if gamma > 0.0 && gravity > 0.0 {
                return Some((gamma, gamma / gravity));
            }
            let message = "weightless soil, or no gravity: the density does not follow from the unit weight";
            let cure = format!("add  density = \"2000 kg/m^3\"  to [{}]", section.path);
            problems.add(section.at("unit_weight"), message, cure);
            None
        }
        _ => {
            if !section.has("unit_weight") && !section.has("density") {
                missing(section, "unit_weight", problems);
            }
            None
        }
    }
}

/// The same for sand at a relative density.
fn weight_of_sand(section: &Section, gravity: f64, law: &Law, problems: &mut Problems) -> Option<(f64, f64)> {
    for key in ["unit_weight", "density"].iter().filter(|key| section.has(key)) {
        let message = format!("`{key}` follows from relative_density");
        problems.add(section.at(key), message, "give one of the two");
    }
    let density = law.density_at(section.number("relative_density")?)?;
    Some((density * gravity, density))
}

fn law(section: &Section, problems: &mut Problems) -> Option<Law> {
    if !section.has("law") {
        missing(section, "law", problems);
    }
    let law = section.text("law")?;
    let own: &[&str] = match law.as_str() {
        "mohr-coulomb" => &FRICTIONAL,
        "sand" => &SAND,
        "tresca" => &UNDRAINED,
        "von-mises" => &METAL,
        _ => &[],
    };
    for others in [&FRICTIONAL[..], &SAND, &UNDRAINED, &METAL] {
        if others != own {
            refuse(section, others, &law, problems);
        }
    }
    match law.as_str() {
        "mohr-coulomb" => mohr_coulomb(section, problems),
        "sand" => sand(section, problems),
        "tresca" => {
            let shear_strength = required(section, "shear_strength", problems);
            let softening = softening(section, problems);
            let gradient = section.number("strength_gradient")?;
            Some(Law::Tresca { shear_strength: shear_strength?, gradient, softening: softening? })
        }
        "von-mises" => {
            let yield_stress = required(section, "yield_stress", problems);
            let hardening_modulus = section.number("hardening_modulus")?;
            Some(Law::VonMises { yield_stress: yield_stress?, hardening_modulus })
        }
        _ => Some(Law::Elastic),
    }
}

/// What remoulding and rate do to undrained clay; `None` for nothing.
#[allow(clippy::option_option)]
fn softening(section: &Section, problems: &mut Problems) -> Option<Option<ClaySoftening>> {
    let found = ClaySoftening {
        sensitivity: section.number("sensitivity")?,
        remoulding_strain: section.number("remoulding_strain")?,
        rate_strengthening: section.number("rate_strengthening")?,
        reference_rate: section.number("reference_rate")?,
    };
    let without = [
        ("remoulding_strain", "sensitivity", found.sensitivity == 1.0),
        ("reference_rate", "rate_strengthening", found.rate_strengthening == 0.0),
    ];
    for (key, needs, has_none) in without {
        if has_none && section.has(key) {
            let message = format!("`{key}` has no effect without `{needs}`");
            problems.add(section.at(key), message, format!("remove it, or give `{needs}`"));
        }
    }
    Some((found.sensitivity != 1.0 || found.rate_strengthening != 0.0).then_some(found))
}

fn sand(section: &Section, problems: &mut Problems) -> Option<Law> {
    let critical_friction_angle = required(section, "critical_friction_angle", problems);
    let minimum_density = required(section, "minimum_density", problems);
    let maximum_density = required(section, "maximum_density", problems);
    Some(Law::Sand {
        critical_friction_angle: critical_friction_angle?,
        minimum_density: minimum_density?,
        maximum_density: maximum_density?,
        bolton_q: section.number("bolton_q")?,
        bolton_r: section.number("bolton_r")?,
        reference_strain: section.number("reference_strain")?,
        compression_modulus: section.number("compression_modulus")?,
        preconsolidation: section.number("preconsolidation_pressure")?,
        stiffness_limit: section.number("stiffness_limit")?,
        characteristic_length: match section.has("characteristic_length") {
            true => Some(section.number("characteristic_length")?),
            false => None,
        },
        density_gradient: section.number("relative_density_gradient")?,
    })
}

fn mohr_coulomb(section: &Section, problems: &mut Problems) -> Option<Law> {
    let friction_angle = required(section, "friction_angle", problems);
    let potential = friction_angle.and_then(|friction_angle| potential(section, friction_angle, problems));
    let critical_density = match section.has("critical_density") {
        true => Some(section.number("critical_density")?),
        false => None,
    };
    Some(Law::MohrCoulomb {
        friction_angle: friction_angle?,
        dilation_angle: section.number("dilation_angle")?,
        cohesion: section.number("cohesion")?,
        tension_cutoff: section.number("tension_cutoff")?,
        potential: potential?,
        critical_density,
    })
}

/// The plastic flow potential.
fn potential(section: &Section, friction_angle: f64, problems: &mut Problems) -> Option<Potential> {
    if section.text("flow_potential")? != "menetrey-willam" {
        for key in SMOOTH.iter().filter(|key| section.has(key)) {
            let message = format!("`{key}` applies only to the smooth potential");
            let cure = "remove it, or set  flow_potential = \"menetrey-willam\"";
            problems.add(section.at(key), message, cure);
        }
        return Some(Potential::MohrCoulomb);
    }
    let usual = Eccentricity::usual(friction_angle).deviatoric;
    Some(Potential::MenetreyWillam {
        meridional: section.number("meridional_eccentricity")?,
        deviatoric: section.number_or("deviatoric_eccentricity", usual)?,
    })
}

/// Reports parameters of other laws, which would have no effect.
fn refuse(section: &Section, keys: &[&str], law: &str, problems: &mut Problems) {
    for key in keys.iter().filter(|key| section.has(key)) {
        let message = format!("`{key}` does not apply to law = \"{law}\"");
        problems.add(section.at(key), message, "remove it, or choose another law");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::keys;

    #[test]
    fn the_default_eccentricity_is_that_of_the_potential() {
        let default = keys::at("soil.meridional_eccentricity").unwrap().default.text();
        assert_eq!(default, Eccentricity::usual(0.5).meridional.to_string());
    }
}
