//! A rigid body: shape, mass, position and motion.

use super::context::Context;
use super::motion::{freedom, is_free};
use crate::case::problem::Problems;
use crate::case::ranges::{self, ANY, FRACTION, NOT_NEGATIVE, POSITIVE};
use crate::case::resolved::{Axis, Body, Law, Shape};
use crate::case::typed::Section;
use glam::DVec3;

/// Density of a body whose mass is not given because it never moves freely [kg/m³]: solid steel. Nothing depends on it.
const NOMINAL_DENSITY: f64 = 7850.0;
/// Least number of cells across a body: with fewer, soil fits between its contact points unnoticed.
const MIN_CELLS_ACROSS: f64 = 2.0;

/// Keys that describe a shape; each shape has its own.
const MEASURES: [&str; 6] = ["diameter", "thickness", "size", "orientation", "length", "axis"];

/// One body of the case.
pub(super) fn body(section: &Section, context: &Context, problems: &mut Problems) -> Option<Body> {
    let shape = shape(section, context, problems);
    let friction = friction(section, problems);
    let shear_limit = shear_limit(section, context, problems);
    let mass = mass(section, context.gravity, problems);
    let position = position(section, shape.as_ref(), context, problems);
    let motions = [("forward", 0.0), ("lateral", 0.0), ("heave", -context.gravity)];
    let needs_mass = motions.iter().any(|(key, _)| is_free(section, key));
    let mass = mass?;
    if needs_mass && mass.is_none() {
        let message = format!("[{}] moves freely, but its weight is not given", section.path);
        problems.add(&section.location, message, "add  weight = \"40 N\"  or  mass = \"4 kg\"");
    }
    let translation = motions
        .map(|(key, acceleration)| freedom(section, key, acceleration * mass.unwrap_or(0.0), problems));
    let spin = freedom(section, "spin", 0.0, problems);
    let shape = shape?;
    let inertia = axle_inertia(section, &shape, mass, problems);
    let [Some(forward), Some(lateral), Some(heave)] = translation else { return None };
    Some(Body {
        name: section.path.trim_start_matches("body.").to_owned(),
        position: position?,
        mass: mass.unwrap_or_else(|| NOMINAL_DENSITY * shape.solid().mass_properties().volume),
        axle_inertia: inertia?,
        shape,
        friction: friction?,
        shear_limit: shear_limit?,
        translation: [forward, lateral, heave],
        spin: spin?,
    })
}

fn shape(section: &Section, context: &Context, problems: &mut Problems) -> Option<Shape> {
    if !section.has("shape") {
        ranges::missing(section, "shape", problems);
    }
    let kind = section.text("shape")?.value;
    let allowed: &[&str] = match kind.as_str() {
        "disc" => &["diameter", "thickness"],
        "block" => &["size", "orientation"],
        "cylinder" => &["diameter", "length", "axis"],
        _ => &["diameter"],
    };
    for key in MEASURES.iter().filter(|key| section.has(key) && !allowed.contains(key)) {
        let message = format!("`{key}` does not apply to shape = \"{kind}\"");
        problems.add(section.location_of(key), message, "remove it, or choose another shape");
    }
    match kind.as_str() {
        "disc" => disc(section, context, problems),
        "block" => block(section, context, problems),
        "cylinder" => cylinder(section, context, problems),
        _ => sphere(section, context, problems),
    }
}

/// A cylinder. In plane strain it lies across the slab and is as long as the slab is wide.
fn cylinder(section: &Section, context: &Context, problems: &mut Problems) -> Option<Shape> {
    let diameter = ranges::required(section, "diameter", &POSITIVE, problems);
    if !section.has("axis") {
        ranges::missing(section, "axis", problems);
    }
    let length = match context.slab {
        None => ranges::required(section, "length", &POSITIVE, problems),
        Some(slab) if !section.has("length") => Some(slab.covering_width()),
        Some(_) => {
            let message = "in plane strain a cylinder is as long as the slab is wide";
            problems.add(section.location_of("length"), message, "remove `length`");
            None
        }
    };
    let axis = match section.text("axis")?.value.as_str() {
        "x" => Axis::X,
        "y" => Axis::Y,
        _ => Axis::Z,
    };
    if context.slab.is_some() && axis != Axis::Y {
        let message = "in plane strain a cylinder lies across the slab";
        problems.add(section.location_of("axis"), message, "write axis = \"y\", or model it in 3D");
        return None;
    }
    let (diameter, length) = (diameter?, length?);
    let mut enough = wide_enough(section, "diameter", diameter, context, problems);
    if context.slab.is_none() {
        enough &= wide_enough(section, "length", length, context, problems);
    }
    enough.then_some(Shape::Cylinder { diameter, length, axis })
}

fn sphere(section: &Section, context: &Context, problems: &mut Problems) -> Option<Shape> {
    let diameter = ranges::required(section, "diameter", &POSITIVE, problems)?;
    if context.slab.is_some() {
        let message = "shape = \"sphere\" cannot be combined with plane_strain = true";
        problems.add(section.location_of("shape"), message, "remove plane_strain, or choose a disc");
        return None;
    }
    wide_enough(section, "diameter", diameter, context, problems).then_some(Shape::Sphere { diameter })
}

fn disc(section: &Section, context: &Context, problems: &mut Problems) -> Option<Shape> {
    let diameter = ranges::required(section, "diameter", &POSITIVE, problems);
    let thickness = match context.slab {
        None => ranges::required(section, "thickness", &POSITIVE, problems),
        Some(slab) if !section.has("thickness") => Some(slab.covering_width()),
        Some(_) => {
            let message = "in plane strain a disc is as thick as the slab is wide";
            problems.add(section.location_of("thickness"), message, "remove `thickness`");
            None
        }
    };
    let (diameter, thickness) = (diameter?, thickness?);
    let mut enough = wide_enough(section, "diameter", diameter, context, problems);
    if context.slab.is_none() {
        enough &= wide_enough(section, "thickness", thickness, context, problems);
    }
    enough.then_some(Shape::Disc { diameter, thickness })
}

fn block(section: &Section, context: &Context, problems: &mut Problems) -> Option<Shape> {
    if !section.has("size") {
        ranges::missing(section, "size", problems);
    }
    let size = section.list("size")?;
    if let Some(edge) = size.value.iter().find(|edge| edge.value <= 0.0) {
        let message = format!("an edge of {} is impossible", problems.typed(&edge.location));
        problems.add(&edge.location, message, "every edge must be above 0");
        return None;
    }
    let edges: Vec<f64> = size.value.iter().map(|edge| edge.value).collect();
    let size_3d = match (edges.as_slice(), context.slab) {
        (&[x, z], Some(slab)) => DVec3::new(x, slab.covering_width(), z),
        (&[x, y, z], None) => DVec3::new(x, y, z),
        (_, slab) => {
            let cure = if slab.is_some() {
                "in plane strain give two edges, along x and z"
            } else {
                "give three edges, along x, y and z (two only with plane_strain = true)"
            };
            problems.add(&size.location, format!("{} edges are not possible here", edges.len()), cure);
            return None;
        }
    };
    let orientation = ranges::or(section, "orientation", 0.0, &ANY, problems)?;
    let narrowest = edges.iter().copied().fold(f64::INFINITY, f64::min);
    let enough = wide_enough(section, "size", narrowest, context, problems);
    enough.then_some(Shape::Block { size: size_3d, orientation })
}

/// Refuses a body with too few cells across it to resolve contact.
fn wide_enough(section: &Section, key: &str, width: f64, context: &Context, problems: &mut Problems) -> bool {
    let cells = width / context.cell;
    if cells >= MIN_CELLS_ACROSS * (1.0 - 1e-9) {
        return true;
    }
    let message =
        format!("only {cells:.2} cells across {}: too few to resolve contact", ranges::dotted(section, key));
    let cure = format!(
        "make grid.cell at most {:.4} mm for 2 cells across; 4 or more are advisable",
        1e3 * width / MIN_CELLS_ACROSS
    );
    problems.add(section.location_of(key), message, cure);
    false
}

fn friction(section: &Section, problems: &mut Problems) -> Option<f64> {
    ranges::required(section, "friction", &NOT_NEGATIVE, problems)
}

/// Largest frictional traction [Pa]: the adhesion factor times the undrained shear strength.
fn shear_limit(section: &Section, context: &Context, problems: &mut Problems) -> Option<f64> {
    if !section.has("adhesion_factor") {
        return Some(f64::INFINITY);
    }
    let factor = ranges::given(section, "adhesion_factor", &FRACTION, problems);
    let Some(Law::Tresca { shear_strength }) = context.law else {
        let message = "`adhesion_factor` applies only to soil with an undrained shear strength";
        let cure = "remove it, or choose law = \"tresca\"";
        problems.add(section.location_of("adhesion_factor"), message, cure);
        return None;
    };
    Some(factor? * shear_strength)
}

/// The mass, if it is known; the outer `None` if it was given wrongly.
#[allow(clippy::option_option)]
fn mass(section: &Section, gravity: f64, problems: &mut Problems) -> Option<Option<f64>> {
    let weight = ranges::given(section, "weight", &POSITIVE, problems);
    let mass = ranges::given(section, "mass", &POSITIVE, problems);
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
            problems.add(section.location_of("weight"), message, cure);
            None
        }
        (_, Some(mass)) => Some(Some(mass)),
        (Some(weight), None) if gravity > 0.0 => Some(Some(weight / gravity)),
        (Some(_), None) => {
            let message = "without gravity the mass does not follow from the weight";
            problems.add(
                section.location_of("weight"),
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
        return ranges::given(section, "axle_inertia", &POSITIVE, problems);
    }
    let solid = shape.solid();
    if mass.is_none() && is_free(section, "spin") {
        let message = format!("[{}] rotates freely, but its moment of inertia is not known", section.path);
        problems.add(
            section.location_of("spin"),
            message,
            "add  axle_inertia = \"0.02 kg*m^2\", or a weight or a mass",
        );
        return None;
    }
    let properties = solid.mass_properties();
    Some(mass.unwrap_or(NOMINAL_DENSITY * properties.volume) * properties.about_axle())
}

fn position(
    section: &Section,
    shape: Option<&Shape>,
    context: &Context,
    problems: &mut Problems,
) -> Option<DVec3> {
    let x = ranges::or(section, "x", 0.0, &ANY, problems);
    let y = ranges::or(section, "y", 0.0, &ANY, problems);
    let sinkage = ranges::or(section, "sinkage", 0.0, &ANY, problems);
    let lowest = shape?.solid().bounds().0.z;
    let y = match context.slab {
        Some(slab) if !section.has("y") => slab.middle,
        _ => y?,
    };
    Some(DVec3::new(x?, y, context.surface - sinkage? - lowest))
}
