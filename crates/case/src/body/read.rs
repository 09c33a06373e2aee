//! A rigid body: shape, mass, position and motion.

use super::check;
use super::keys::KEYS;
use super::motion::{self, Rolling};
use super::{Attitude, Body, MOTIONS, planes_forbid};
use crate::context::Context;
use crate::key::{checked, required};
use crate::shapes::{self, Shape};
use glam::DVec3;
use input::problem::Problems;
use input::typed::Section;

/// Density of a body whose mass is not given because it never moves freely [kg/m³]: solid steel. Nothing
/// depends on it.
const NOMINAL_DENSITY: f64 = 7850.0;

/// What other sections say of the bodies.
pub(crate) struct Others<'a> {
    /// Names of the bodies that joints carry.
    pub(crate) carried: &'a [String],
    /// The stages.
    pub(crate) stages: &'a [Section],
}

/// One body of the case; the motions of one that a joint carries are free unless they are given.
pub(crate) fn body(
    section: &Section,
    others: &Others,
    context: &Context,
    problems: &mut Problems,
) -> Option<Body> {
    let is_carried = others.carried.iter().any(|name| section.path.strip_prefix("body.") == Some(name));
    let shape = shape(section, context, problems);
    let friction = friction(section, shape.as_ref(), problems);
    let adhesion_factor = adhesion_factor(section, context, problems);
    let displaced = shape.as_ref().map_or(0.0, |shape| context.displaced_by(shape.solid().as_ref()));
    let mass = mass(section, context, displaced, problems);
    let attitude = attitude(section);
    let may_move = |n| !planes_forbid(context.symmetric || context.slab.is_some(), context.symmetric_x, n);
    let typed: [_; 6] =
        std::array::from_fn(|n| motion::typed(section, MOTIONS[n], is_carried && may_move(n)));
    let freed = motion::freed(section, others.stages);
    let free: [bool; 6] = std::array::from_fn(|n| freed[n] || motion::is_free(typed[n].as_ref()));
    let mass = mass?;
    if free[..3].contains(&true) && mass.is_none() {
        let carried = if is_carried { ", for a joint carries it," } else { "" };
        let message = format!("[{}] moves freely{carried} but its weight is not given", section.path);
        problems.add(&section.path, message, "add  weight = \"40 N\"  or  mass = \"4 kg\"");
    }
    let [along, across, normal] = context.support(mass.map_or(0.0, |mass| mass - displaced)).to_array();
    let support = [along, across, normal, 0.0, 0.0];
    let mut freedom = |n: usize| motion::freedom(section, n, typed[n].as_ref(), support[n], problems);
    let [forward, lateral, heave, yaw, tilt] = std::array::from_fn(&mut freedom);
    let radius = shape.as_ref().and_then(|shape| shape.rolling_diameter()).map(|diameter| 0.5 * diameter);
    let ways = [forward.as_ref(), lateral.as_ref()];
    let rolling = Rolling { ways, radius, yaw: attitude.map_or(0.0, |attitude| attitude.yaw) };
    let spin = motion::spin(section, typed[5].as_ref(), &rolling, problems);
    let shape = shape?;
    let turns = MOTIONS[3..].iter().zip(&free[3..]).find(|(_, free)| **free).map(|(key, _)| *key);
    let inertia = axle_inertia(section, &shape, mass, turns, problems);
    let mut body = Body {
        name: section.path.trim_start_matches("body.").to_owned(),
        position: DVec3::ZERO,
        attitude: attitude?,
        mass: mass.unwrap_or_else(|| nominal_mass(&shape)),
        axle_inertia: inertia?,
        shape,
        friction: friction?,
        adhesion_factor: adhesion_factor?,
        translation: [forward?, lateral?, heave?],
        rotation: [yaw?, tilt?, spin?],
        parts: Vec::new(),
        guide: None,
        staged: None,
    };
    body.position = position(section, &body, context, problems)?;
    checked(body, problems, |body, problems| check::check(body, context.fine_cells(), problems))
}

/// The mass of a body that never moves freely [kg].
fn nominal_mass(shape: &Shape) -> f64 {
    if shape.has_surface() { NOMINAL_DENSITY * shape.solid().mass_properties().volume } else { 1.0 }
}

/// The coefficient of friction; that of a body without a surface plays no role.
fn friction(section: &Section, shape: Option<&Shape>, problems: &mut Problems) -> Option<f64> {
    if shape.is_none_or(|shape| shape.has_surface()) {
        return required(KEYS, section, "friction", problems);
    }
    if let Some(key) = ["friction", "adhesion_factor"].into_iter().find(|key| section.has(key)) {
        let message = format!("a frame has no surface, and no `{key}`");
        problems.add(section.at(key), message, format!("remove `{key}`, or choose another shape"));
    }
    Some(0.0)
}

fn shape(section: &Section, context: &Context, problems: &mut Problems) -> Option<Shape> {
    let shape = shapes::read(section, context.slab, problems)?;
    checked(shape, problems, |shape, problems| {
        check::shape(&section.path, shape, context.fine_cells(), problems);
    })
}

/// The adhesion factor; infinite for no limit.
fn adhesion_factor(section: &Section, context: &Context, problems: &mut Problems) -> Option<f64> {
    if !section.has("adhesion_factor") {
        return Some(f64::INFINITY);
    }
    if !context.has_undrained_soil {
        let message = "`adhesion_factor` applies only to soil with an undrained shear strength";
        let cure = "remove it, or choose law = \"tresca\"";
        problems.add(section.at("adhesion_factor"), message, cure);
        return None;
    }
    section.number("adhesion_factor")
}

/// The mass, if it is known; the outer `None` if it was given wrongly. The body displaces this mass of water
/// [kg].
#[allow(clippy::option_option)]
fn mass(
    section: &Section,
    context: &Context,
    displaced: f64,
    problems: &mut Problems,
) -> Option<Option<f64>> {
    let gravity = context.gravity;
    if section.has("submerged_weight") {
        return submerged(section, context, displaced, problems).map(Some);
    }
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

/// The mass of a body of a given weight in water.
fn submerged(section: &Section, context: &Context, displaced: f64, problems: &mut Problems) -> Option<f64> {
    let path = section.at("submerged_weight");
    if context.water.is_none() {
        let cure = "add a section [water], or give the `weight`";
        problems.add(path, "without water there is no submerged weight", cure);
        return None;
    }
    if let Some(key) = ["weight", "mass"].into_iter().find(|key| section.has(key)) {
        let message = format!("`{key}` and `submerged_weight` both say what the body weighs");
        problems.add(path, message, "keep one of them");
        return None;
    }
    if context.gravity <= 0.0 {
        problems.add(path, "without gravity the mass does not follow from the weight", "give the mass");
        return None;
    }
    Some(section.number("submerged_weight")? / context.gravity + displaced)
}

/// The moment of inertia about the axle; `turns` is the key of a rotation that is free.
fn axle_inertia(
    section: &Section,
    shape: &Shape,
    mass: Option<f64>,
    turns: Option<&str>,
    problems: &mut Problems,
) -> Option<f64> {
    if section.has("axle_inertia") {
        return section.number("axle_inertia");
    }
    if let Some(key) = turns.filter(|_| mass.is_none() || !shape.has_surface()) {
        let message = format!("[{}] rotates freely, but its moment of inertia is not known", section.path);
        let cure = if shape.has_surface() {
            "add a weight or a mass, or axle_inertia = \"0.02 kg*m^2\""
        } else {
            "add axle_inertia = \"0.02 kg*m^2\""
        };
        problems.add(section.at(key), message, cure);
        return None;
    }
    if !shape.has_surface() {
        return Some(1.0);
    }
    Some(mass.unwrap_or_else(|| nominal_mass(shape)) * shape.solid().mass_properties().about_axle())
}

fn attitude(section: &Section) -> Option<Attitude> {
    let [yaw, tilt, pitch] = ["yaw", "tilt", "pitch"].map(|key| section.number(key));
    Some(Attitude { yaw: yaw?, tilt: tilt?, pitch: pitch? })
}

/// Where a body of this shape and attitude stands.
fn position(section: &Section, body: &Body, context: &Context, problems: &mut Problems) -> Option<DVec3> {
    let (x, y, sinkage) = (section.number("x"), section.number("y"), section.number("sinkage"));
    let y = match context.slab {
        Some(slab) if !section.has("y") => slab.middle,
        _ => y?,
    };
    let z = if section.has("elevation") {
        if section.has("sinkage") {
            let message = "`sinkage` and `elevation` both say how high the body stands";
            problems.add(section.at("elevation"), message, "keep one of them");
        }
        context.surface + section.number("elevation")?
    } else {
        context.surface - sinkage? - body.bounds().0.z
    };
    Some(DVec3::new(x?, y, z))
}
