//! The soil: whether its parameters are in range and do not contradict each other, and whether it sustains the overburden.

use crate::case::at_rest;
use crate::case::numbers::in_range;
use crate::case::problem::Problems;
use crate::case::quantity::plain;
use crate::case::resolved::{Case, Domain, Ground, Law, Potential, Soil, Wall};
use crate::case::slope::Slope;

/// Reports what is wrong with the soil.
pub(in crate::case) fn soil(soil: &Soil, problems: &mut Problems) {
    let elastic = [
        ("young_modulus", soil.young_modulus),
        ("poisson_ratio", soil.poisson_ratio),
        ("unit_weight", soil.unit_weight),
        ("density", soil.density),
        ("k0", soil.k0),
    ];
    for (key, number) in elastic {
        in_range(&format!("soil.{key}"), number, problems);
    }
    law(&soil.law, problems);
    if let Some(relative_density) = soil.relative_density() {
        // It follows from the density: a limit that was typed comes back with a rounding error.
        in_range("soil.relative_density", (relative_density * 1e9).round() / 1e9, problems);
    }
    if let Law::MohrCoulomb { critical_density: Some(critical), .. } = soil.law
        && critical > soil.density
    {
        let message = format!(
            "the initial density of the soil, {:.1} kg/m³, is below its critical density",
            soil.density
        );
        let cure = "it must be at most the density; dense sand dilates by some per cent";
        problems.add("soil.critical_density", message, cure);
    }
}

/// Reports what is wrong with a yield law.
pub(in crate::case) fn law(law: &Law, problems: &mut Problems) {
    let before = problems.len();
    for (key, number) in law_numbers(law) {
        in_range(&format!("soil.{key}"), number, problems);
    }
    if problems.len() == before {
        plastic_flow(law, problems);
        densities(law, problems);
    }
}

/// The numbers of a yield law, by key.
fn law_numbers(law: &Law) -> Vec<(&'static str, f64)> {
    match *law {
        Law::Elastic => Vec::new(),
        Law::Tresca { shear_strength } => vec![("shear_strength", shear_strength)],
        Law::VonMises { yield_stress, hardening_modulus } => {
            vec![("yield_stress", yield_stress), ("hardening_modulus", hardening_modulus)]
        }
        Law::MohrCoulomb {
            friction_angle,
            dilation_angle,
            cohesion,
            tension_cutoff,
            potential,
            critical_density,
        } => {
            let mut numbers = vec![
                ("friction_angle", friction_angle),
                ("dilation_angle", dilation_angle),
                ("cohesion", cohesion),
                ("tension_cutoff", tension_cutoff),
            ];
            if let Potential::MenetreyWillam { meridional, deviatoric } = potential {
                numbers.push(("meridional_eccentricity", meridional));
                numbers.push(("deviatoric_eccentricity", deviatoric));
            }
            numbers.extend(critical_density.map(|density| ("critical_density", density)));
            numbers
        }
        Law::Sand {
            critical_friction_angle,
            minimum_density,
            maximum_density,
            bolton_q,
            bolton_r,
            reference_strain,
            compression_modulus,
            stiffness_limit,
            characteristic_length,
        } => {
            let mut numbers = vec![
                ("critical_friction_angle", critical_friction_angle),
                ("minimum_density", minimum_density),
                ("maximum_density", maximum_density),
                ("bolton_q", bolton_q),
                ("bolton_r", bolton_r),
                ("reference_strain", reference_strain),
                ("compression_modulus", compression_modulus),
                ("stiffness_limit", stiffness_limit),
            ];
            numbers.extend(characteristic_length.map(|length| ("characteristic_length", length)));
            numbers
        }
    }
}

/// Reports a densest state that is not denser than the loosest.
fn densities(law: &Law, problems: &mut Problems) {
    if let Law::Sand { minimum_density, maximum_density, .. } = *law
        && maximum_density <= minimum_density
    {
        let message = format!(
            "the densest state, {maximum_density:.1} kg/m³, is not denser than the loosest, {minimum_density:.1} kg/m³"
        );
        problems.add("soil.maximum_density", message, "it must be above minimum_density");
    }
}

/// Reports angles and a tension cut-off of frictional soil that contradict each other, and an end of dilation where there is none.
fn plastic_flow(law: &Law, problems: &mut Problems) {
    if law.friction_angle().is_some_and(|friction_angle| law.dilation_angle() > friction_angle) {
        let message =
            "the dilation angle ψ is larger than the friction angle φ: plastic flow would create energy";
        problems.add("soil.dilation_angle", message, "it must be from 0 deg to the friction angle");
    }
    let Law::MohrCoulomb { friction_angle, cohesion, tension_cutoff, critical_density, .. } = *law else {
        return;
    };
    // The apex of the cone; for φ = 0 there is none.
    let apex = if friction_angle > 0.0 { cohesion / friction_angle.tan() } else { f64::INFINITY };
    if tension_cutoff > apex {
        let message =
            format!("the tension cut-off is beyond the apex of the yield cone, c cot φ = {apex:.4} Pa");
        problems.add("soil.tension_cutoff", message, "lower it, or remove it for no tension at all");
    }
    if law.dilation_angle() == 0.0 && critical_density.is_some() {
        let message = "soil with a dilation angle of 0 does not dilate";
        problems.add("soil.critical_density", message, "remove it, or set  dilation_angle");
    }
}

/// Reports an overburden [Pa] that is no pressure.
pub(super) fn overburden_number(overburden: f64, problems: &mut Problems) {
    in_range(OVERBURDEN, overburden, problems);
}

const OVERBURDEN: &str = "ground.overburden";

/// Reports an overburden [Pa] under which the soil, with its surface at a height [m], does not reach up to the lid or yields
/// at once.
pub(in crate::case) fn overburden(
    overburden: f64,
    soil: &Soil,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) {
    if overburden == 0.0 {
        return;
    }
    if surface < domain.high.z {
        let message = format!(
            "an overburden needs a lid: the soil ends at z = {} m, the box at {} m",
            plain(surface),
            plain(domain.high.z)
        );
        let cure = "let domain.z end at ground.surface, or remove `overburden`";
        problems.add(OVERBURDEN, message, cure);
        return;
    }
    let ratio = soil.k0;
    let is_sustained = at_rest::sustains(&soil.law, [1.0, ratio, ratio].map(|r| r * overburden));
    if !is_sustained {
        let message =
            format!("the soil cannot sustain this overburden with K₀ = {ratio:.3}: it would fail at once");
        problems.add(OVERBURDEN, message, "add  k0 = 1  to [soil], or lower the overburden");
    }
}

/// Reports a slope on which the soil does not rest, or that its boundaries contradict.
pub(super) fn slope(case: &Case, problems: &mut Problems) {
    let slope = case.slope;
    if slope.is_level() {
        return;
    }
    let Domain { symmetric, symmetric_x, plane_strain, walls, .. } = case.domain;
    let planes = [(SLOPE, symmetric_x), (CROSS_SLOPE, symmetric || plane_strain)];
    let opened = |axis: usize| case.grid.follow.is_some_and(|follow| follow.axes[axis]);
    for (axis, ((key, is_plane), angle)) in planes.into_iter().zip(slope.angles()).enumerate() {
        if angle == 0.0 {
            continue;
        }
        if is_plane {
            let message = "gravity acts across a plane of symmetry or of plane strain";
            problems.add(key, message, "model the whole width, or remove the slope");
        } else if walls[axis].contains(&Wall::Smooth) && !opened(axis) {
            let path = ["domain.x_walls", "domain.y_walls"][axis];
            let message = "a smooth wall across a slope cannot bear the shear stress of the soil beside it";
            problems.add(path, message, "remove it: walls across a slope are fixed");
        }
    }
    if case.soil.unit_weight == 0.0 || !matches!(case.ground, Ground::Level { .. }) {
        return;
    }
    let depth = case.ground.surface() - case.domain.low.z;
    let normal = case.soil.unit_weight * slope.cosine() * depth + case.overburden;
    let stresses = slope.principal_stresses(case.soil.k0).map(|ratio| ratio * normal);
    if !at_rest::sustains(&case.soil.law, stresses) {
        let message =
            format!("the soil does not rest on a slope of {:.1}°: it would slide at once", steepest(&slope));
        let cure = "make the slope gentler than the friction angle, or, with cohesion or undrained strength, the soil less deep";
        problems.add(if slope.along == 0.0 { CROSS_SLOPE } else { SLOPE }, message, cure);
    }
}

fn steepest(slope: &Slope) -> f64 {
    slope.tangent().atan().to_degrees()
}

/// Reports angles of a slope that are out of range.
pub(super) fn slope_numbers(slope: &Slope, problems: &mut Problems) {
    in_range(SLOPE, slope.along, problems);
    in_range(CROSS_SLOPE, slope.across, problems);
}

const SLOPE: &str = "ground.slope";
const CROSS_SLOPE: &str = "ground.cross_slope";
