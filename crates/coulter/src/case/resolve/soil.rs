//! The soil: its law and its parameters.

use crate::case::problem::Problems;
use crate::case::quantity::plain;
use crate::case::ranges::{self, ACUTE, BELOW_HALF, ECCENTRICITY, NOT_NEGATIVE, POSITIVE};
use crate::case::resolved::{Domain, Law, Potential, Soil};
use crate::case::typed::Section;
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
const UNDRAINED: [&str; 1] = ["shear_strength"];
const METAL: [&str; 2] = ["yield_stress", "hardening_modulus"];

/// The soil under `gravity` [m/s²].
pub(super) fn soil(section: &Section, gravity: f64, problems: &mut Problems) -> Option<Soil> {
    let young_modulus = ranges::required(section, "young_modulus", &POSITIVE, problems);
    let poisson_ratio = ranges::or(section, "poisson_ratio", 0.3, &BELOW_HALF, problems);
    let weight = weight(section, gravity, problems);
    let law = law(section, weight.map(|(_, density)| density), problems);
    let (young_modulus, poisson_ratio, (unit_weight, density), law) =
        (young_modulus?, poisson_ratio?, weight?, law?);
    let elastic = poisson_ratio / (1.0 - poisson_ratio);
    let at_rest = law.friction_angle().map_or(elastic, |friction_angle| 1.0 - friction_angle.sin());
    let k0 = ranges::or(section, "k0", at_rest, &NOT_NEGATIVE, problems)?;
    Some(Soil { law, density, unit_weight, young_modulus, poisson_ratio, k0 })
}

/// Initial vertical pressure of the lid on the soil [Pa]. The soil must reach up to the lid and must not yield under the
/// initial stresses.
pub(super) fn overburden(
    section: &Section,
    soil: &Soil,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) -> Option<f64> {
    let overburden = ranges::or(section, "overburden", 0.0, &NOT_NEGATIVE, problems)?;
    if overburden == 0.0 {
        return Some(0.0);
    }
    if surface < domain.high.z {
        let message = format!(
            "an overburden needs a lid: the soil ends at z = {} m, the box at {} m",
            plain(surface),
            plain(domain.high.z)
        );
        let cure = "let domain.z end at ground.surface, or remove `overburden`";
        problems.add(section.location_of("overburden"), message, cure);
        return None;
    }
    let ratio = soil.k0;
    let [max, min] = [ratio.max(1.0) * overburden, ratio.min(1.0) * overburden];
    let is_sustained = match soil.law {
        Law::Elastic => true,
        Law::Tresca { shear_strength } => max - min <= 2.0 * shear_strength,
        Law::VonMises { yield_stress, .. } => max - min <= yield_stress,
        Law::MohrCoulomb { friction_angle, cohesion, .. } => {
            let (sin, cos) = friction_angle.sin_cos();
            max - min <= (max + min) * sin + 2.0 * cohesion * cos
        }
    };
    if !is_sustained {
        let message =
            format!("the soil cannot sustain this overburden with K₀ = {ratio:.3}: it would fail at once");
        let cure = "add  k0 = 1  to [soil], or lower the overburden";
        problems.add(section.location_of("overburden"), message, cure);
        return None;
    }
    Some(overburden)
}

/// Unit weight [N/m³] and density [kg/m³]; one may follow from the other.
fn weight(section: &Section, gravity: f64, problems: &mut Problems) -> Option<(f64, f64)> {
    let gamma = ranges::given(section, "unit_weight", &NOT_NEGATIVE, problems);
    let density = ranges::given(section, "density", &POSITIVE, problems);
    match (gamma, density) {
        (Some(gamma), Some(density)) => Some((gamma, density)),
        (None, Some(density)) if !section.has("unit_weight") => Some((density * gravity, density)),
        (Some(gamma), None) if !section.has("density") => {
            if gamma > 0.0 && gravity > 0.0 {
                return Some((gamma, gamma / gravity));
            }
            let message = "weightless soil, or no gravity: the density does not follow from the unit weight";
            problems.add(
                section.location_of("unit_weight"),
                message,
                "add  density = \"2000 kg/m^3\"  to [soil]",
            );
            None
        }
        _ => {
            if !section.has("unit_weight") && !section.has("density") {
                ranges::missing(section, "unit_weight", problems);
            }
            None
        }
    }
}

fn law(section: &Section, density: Option<f64>, problems: &mut Problems) -> Option<Law> {
    if !section.has("law") {
        ranges::missing(section, "law", problems);
    }
    let law = section.text("law")?.value;
    match law.as_str() {
        "mohr-coulomb" => {
            refuse(section, &UNDRAINED, &law, problems);
            refuse(section, &METAL, &law, problems);
            mohr_coulomb(section, density, problems)
        }
        "tresca" => {
            refuse(section, &FRICTIONAL, &law, problems);
            refuse(section, &METAL, &law, problems);
            let shear_strength = ranges::required(section, "shear_strength", &POSITIVE, problems)?;
            Some(Law::Tresca { shear_strength })
        }
        "von-mises" => {
            refuse(section, &FRICTIONAL, &law, problems);
            refuse(section, &UNDRAINED, &law, problems);
            let yield_stress = ranges::required(section, "yield_stress", &POSITIVE, problems);
            let hardening = ranges::or(section, "hardening_modulus", 0.0, &NOT_NEGATIVE, problems);
            Some(Law::VonMises { yield_stress: yield_stress?, hardening_modulus: hardening? })
        }
        _ => {
            refuse(section, &FRICTIONAL, &law, problems);
            refuse(section, &UNDRAINED, &law, problems);
            refuse(section, &METAL, &law, problems);
            Some(Law::Elastic)
        }
    }
}

fn mohr_coulomb(section: &Section, density: Option<f64>, problems: &mut Problems) -> Option<Law> {
    let friction = ranges::required(section, "friction_angle", &ACUTE, problems);
    let dilation = ranges::or(section, "dilation_angle", 0.0, &ACUTE, problems);
    let cohesion = ranges::or(section, "cohesion", 0.0, &NOT_NEGATIVE, problems);
    let tension = ranges::or(section, "tension_cutoff", 0.0, &NOT_NEGATIVE, problems);
    let critical_density = critical_density(section, density, dilation, problems);
    let (friction_angle, dilation_angle, cohesion, tension_cutoff) =
        (friction?, dilation?, cohesion?, tension?);
    let potential = potential(section, friction_angle, problems);
    if dilation_angle > friction_angle {
        let message =
            "the dilation angle ψ is larger than the friction angle φ: plastic flow would create energy";
        problems.add(
            section.location_of("dilation_angle"),
            message,
            "it must be from 0 deg to the friction angle",
        );
        return None;
    }
    // The apex of the cone; for φ = 0 there is none.
    let apex = if friction_angle > 0.0 { cohesion / friction_angle.tan() } else { f64::INFINITY };
    if tension_cutoff > apex {
        let message =
            format!("the tension cut-off is beyond the apex of the yield cone, c cot φ = {apex:.4} Pa");
        problems.add(
            section.location_of("tension_cutoff"),
            message,
            "lower it, or remove it for no tension at all",
        );
        return None;
    }
    Some(Law::MohrCoulomb {
        friction_angle,
        dilation_angle,
        cohesion,
        tension_cutoff,
        potential: potential?,
        critical_density: critical_density?,
    })
}

/// The plastic flow potential.
fn potential(section: &Section, friction_angle: f64, problems: &mut Problems) -> Option<Potential> {
    let typed = section.text("flow_potential").map(|t| t.value);
    if typed.as_deref() != Some("menetrey-willam") {
        for key in SMOOTH.iter().filter(|key| section.has(key)) {
            let message = format!("`{key}` applies only to the smooth potential");
            let cure = "remove it, or set  flow_potential = \"menetrey-willam\"";
            problems.add(section.location_of(key), message, cure);
        }
        return Some(Potential::MohrCoulomb);
    }
    let usual = Eccentricity::usual(friction_angle);
    let meridional =
        ranges::or(section, "meridional_eccentricity", usual.meridional, &NOT_NEGATIVE, problems);
    let deviatoric =
        ranges::or(section, "deviatoric_eccentricity", usual.deviatoric, &ECCENTRICITY, problems);
    Some(Potential::MenetreyWillam { meridional: meridional?, deviatoric: deviatoric? })
}

/// The density at which dilation ends, if it does: at most the initial density.
fn critical_density(
    section: &Section,
    density: Option<f64>,
    dilation: Option<f64>,
    problems: &mut Problems,
) -> Option<Option<f64>> {
    if !section.has("critical_density") {
        return Some(None);
    }
    let critical = ranges::given(section, "critical_density", &POSITIVE, problems)?;
    let location = section.location_of("critical_density");
    if dilation == Some(0.0) {
        let message = "soil with a dilation angle of 0 does not dilate";
        problems.add(location, message, "remove it, or set  dilation_angle");
        return None;
    }
    if critical > density? {
        let message =
            format!("the initial density of the soil, {:.1} kg/m³, is below its critical density", density?);
        problems.add(
            location,
            message,
            "it must be at most the density; dense sand dilates by some per cent",
        );
        return None;
    }
    Some(Some(critical))
}

/// Reports parameters of other laws, which would have no effect.
fn refuse(section: &Section, keys: &[&str], law: &str, problems: &mut Problems) {
    for key in keys.iter().filter(|key| section.has(key)) {
        let message = format!("`{key}` does not apply to law = \"{law}\"");
        problems.add(section.location_of(key), message, "remove it, or choose another law");
    }
}
