//! A rigid body: shape, mass, position and motion.

use super::context::{Context, checked};
use super::motion::{freedom, is_free, spin};
use crate::case::missing::{missing, required};
use crate::case::problem::Problems;
use crate::case::resolved::{Attitude, Body, Law, MOTIONS};
use crate::case::shapes::{self, Shape};
use crate::case::typed::Section;
use crate::case::validate;
use glam::DVec3;

/// Density of a body whose mass is not given because it never moves freely [kg/m³]: solid steel. Nothing depends on it.
const NOMINAL_DENSITY: f64 = 7850.0;
/// One body of the case.
pub(super) fn body(section: &Section, context: &Context, problems: &mut Problems) -> Option<Body> {
    let shape = shape(section, context, problems);
    let friction = required(section, "friction", problems);
    let shear_limit = shear_limit(section, context, problems);
    let mass = mass(section, context.gravity, problems);
    let attitude = attitude(section);
    let needs_mass = MOTIONS[..3].iter().any(|key| is_free(section, key));
    let mass = mass?;
    if needs_mass && mass.is_none() {
        let message = format!("[{}] moves freely, but its weight is not given", section.path);
        problems.add(&section.path, message, "add  weight = \"40 N\"  or  mass = \"4 kg\"");
    }
    let support = [0.0, 0.0, context.gravity * mass.unwrap_or(0.0)];
    let translation = [0, 1, 2].map(|axis| freedom(section, MOTIONS[axis], support[axis], problems));
    let turns = [3, 4].map(|axis| freedom(section, MOTIONS[axis], 0.0, problems));
    let radius = shape.as_ref().and_then(|shape| shape.rolling_diameter()).map(|diameter| 0.5 * diameter);
    let yaw = attitude.map_or(0.0, |attitude| attitude.yaw);
    let spin = spin(section, [translation[0], translation[1]], (radius, yaw), problems);
    let shape = shape?;
    let inertia = axle_inertia(section, &shape, mass, problems);
    let [Some(forward), Some(lateral), Some(heave)] = translation else { return None };
    let [Some(yaw), Some(tilt)] = turns else { return None };
    let mut body = Body {
        name: section.path.trim_start_matches("body.").to_owned(),
        position: DVec3::ZERO,
        attitude: attitude?,
        mass: mass.unwrap_or_else(|| NOMINAL_DENSITY * shape.solid().mass_properties().volume),
        axle_inertia: inertia?,
        shape,
        friction: friction?,
        shear_limit: shear_limit?,
        translation: [forward, lateral, heave],
        rotation: [yaw, tilt, spin?],
    };
    body.position = position(section, &body, context)?;
    let plane_strain = context.slab.is_some();
    checked(body, problems, |body, problems| {
        validate::body::body(body, (context.fine_cell(), plane_strain), problems)
    })
}

fn shape(section: &Section, context: &Context, problems: &mut Problems) -> Option<Shape> {
    if !section.has("shape") {
        missing(section, "shape", problems);
    }
    let shape = shapes::read(section, context.slab, problems)?;
    let around = (context.fine_cell(), context.slab.is_some());
    checked(shape, problems, |shape, problems| validate::body::shape(&section.path, shape, around, problems))
}

/// Largest frictional traction [Pa]: the adhesion factor times the undrained shear strength.
fn shear_limit(section: &Section, context: &Context, problems: &mut Problems) -> Option<f64> {
    if !section.has("adhesion_factor") {
        return Some(f64::INFINITY);
    }
    let factor = section.number("adhesion_factor");
    let Some(Law::Tresca { shear_strength }) = context.law else {
        let message = "`adhesion_factor` applies only to soil with an undrained shear strength";
        let cure = "remove it, or choose law = \"tresca\"";
        problems.add(section.at("adhesion_factor"), message, cure);
        return None;
    };
    Some(factor? * shear_strength)
}

/// The mass, if it is known; the outer `None` if it was given wrongly.
#[allow(clippy::option_option)]
fn mass(section: &Section, gravity: f64, problems: &mut Problems) -> Option<Option<f64>> {
    let (weight, mass) = (section.number("weight"), section.number("mass"));
    if weight.is_none() && section.has("weight") || mass.is_none() && section.has("mass") {
        return None;
    }
    match (weight, mass) {
        (Some(weight), Some(mass)) if (weight - mass * gravity).abs() > 0.01 * weight => {
            let message = format!(
                "the weight and the mass contradict each other: mass × gravity = {:.4} N",
                mass * gravity
            );
            let cure =
                "give only one of them; a load in addition to the weight is heave = { load = \"-10 N\" }";
            problems.add(section.at("weight"), message, cure);
            None
        }
        (_, Some(mass)) => Some(Some(mass)),
        (Some(weight), None) if gravity > 0.0 => Some(Some(weight / gravity)),
        (Some(_), None) => {
            let message = "without gravity the mass does not follow from the weight";
            problems.add(
                section.at("weight"),
                message,
                "give the mass, and the load as heave = { load = \"-40 N\" }",
            );
            None
        }
        (None, None) => Some(None),
    }
}

fn axle_inertia(section: &Section, shape: &Shape, mass: Option<f64>, problems: &mut Problems) -> Option<f64> {
    if section.has("axle_inertia") {
        return section.number("axle_inertia");
    }
    let solid = shape.solid();
    if let Some(key) = MOTIONS[3..].iter().find(|key| mass.is_none() && is_free(section, key)) {
        let message = format!("[{}] rotates freely, but its moment of inertia is not known", section.path);
        problems.add(section.at(key), message, "add a weight or a mass, or axle_inertia = \"0.02 kg*m^2\"");
        return None;
    }
    let properties = solid.mass_properties();
    Some(mass.unwrap_or(NOMINAL_DENSITY * properties.volume) * properties.about_axle())
}

fn attitude(section: &Section) -> Option<Attitude> {
    let [yaw, tilt, pitch] = ["yaw", "tilt", "pitch"].map(|key| section.number(key));
    Some(Attitude { yaw: yaw?, tilt: tilt?, pitch: pitch? })
}

/// Where a body of this shape and attitude stands.
fn position(section: &Section, body: &Body, context: &Context) -> Option<DVec3> {
    let (x, y, sinkage) = (section.number("x"), section.number("y"), section.number("sinkage"));
    let lowest = body.bounds().0.z;
    let y = match context.slab {
        Some(slab) if !section.has("y") => slab.middle,
        _ => y?,
    };
    Some(DVec3::new(x?, y, context.surface - sinkage? - lowest))
}
