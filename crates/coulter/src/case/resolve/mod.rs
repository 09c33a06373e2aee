//! From what was typed to what it means: defaults filled in, everything checked, SI units.

mod body;
mod checks;
pub(super) mod clearance;
mod context;
mod domain;
mod fitting;
mod forecast;
mod grading;
mod ground;
mod mesh;
mod motion;
mod soil;
mod timing;

use super::names::is_device;
use super::problem::Problems;
use super::ranges::{self, ANY, NOT_NEGATIVE, POSITIVE, POSITIVE_FRACTION};
use super::resolved::{Body, Case, Contact, Law, Numerics, Precision};
use super::shapes::surroundings::Slab;
use super::typed::{Schema, Section};
use context::Context;

/// The case that was typed, or `None` with problems added.
pub(super) fn resolve(schema: &Schema, source_name: &str, problems: &mut Problems) -> Option<Case> {
    let gravity = ranges::or(&schema.top, "gravity", 9.81, &NOT_NEGATIVE, problems);
    let soil = gravity.and_then(|g| soil::soil(&schema.soil, g, problems));
    let numerics = numerics(&schema.numerics, soil.as_ref().map(|s| s.law), problems);
    let context = gravity.and_then(|g| context(schema, g, soil.as_ref().map(|s| s.law), problems));
    let bodies = context.as_ref().and_then(|context| bodies(schema, context, problems));
    let name = name(&schema.top, source_name, problems);
    let duration = bodies.as_ref().and_then(|b| timing::duration(&schema.run, b, problems));
    let forecast = forecast::measured(&schema.forecast, problems);
    let output = duration.and_then(|d| timing::output(&schema.output, d, problems));
    let (context, bodies, duration) = (context?, bodies?, duration?);
    let domain = domain::domain(&schema.domain, &context, &bodies, duration, problems)?;
    let ground = ground::ground(&schema.ground, context.surface, &domain, problems)?;
    let soil = soil?;
    let velocity = ground::velocity(&schema.ground, &domain, problems)?;
    let overburden = soil::overburden(&schema.ground, &soil, ground.surface(), &domain, problems)?;
    checks::bodies_fit(schema, &bodies, &domain, duration, problems);
    let fine_zone = mesh::default_fine_zone(&context, &domain, &bodies, duration);
    let grid = mesh::grid(&schema.grid, &context, (&domain, &ground), &bodies, fine_zone, problems)?;
    let name = name?;
    let case = Case {
        title: schema.top.text("title").map_or_else(|| name.clone(), |t| t.value),
        name,
        gravity: gravity?,
        soil,
        ground,
        overburden,
        velocity,
        domain,
        grid,
        bodies,
        duration,
        output: output?,
        numerics: numerics?,
        forecast: forecast?,
    };
    checks::contact_points_remain(schema, &case, problems);
    checks::can_be_computed(schema, &case, problems);
    checks::contact_points_are_not_too_many(schema, &case, problems);
    checks::fits_into_memory(schema, &case, problems);
    Some(case)
}

fn context(schema: &Schema, gravity: f64, law: Option<Law>, problems: &mut Problems) -> Option<Context> {
    let cell = ranges::required(&schema.grid, "cell", &POSITIVE, problems);
    let surface = ranges::or(&schema.ground, "surface", 0.0, &ANY, problems);
    let symmetric = schema.domain.flag("symmetric").is_some_and(|f| f.value);
    let symmetric_x = schema.domain.flag("symmetric_x").is_some_and(|f| f.value);
    let plane_strain = schema.domain.flag("plane_strain").is_some_and(|f| f.value);
    if symmetric && plane_strain {
        let message = "symmetric = true cannot be combined with plane_strain = true";
        problems.add(schema.domain.location_of("symmetric"), message, "remove `symmetric`");
        return None;
    }
    let cell = cell?;
    let inset = schema.numerics.number("edge_inset").map_or(EDGE_INSET, |n| n.value);
    let slab = if plane_strain {
        let [low, high] = ranges::range(&schema.domain, "y", Some([0.0, cell]), problems)?;
        Some(Slab { width: high - low, middle: 0.5 * (low + high), inset: inset * (high - low) })
    } else {
        None
    };
    let velocity = ground::typed_velocity(&schema.ground);
    let surface = surface?;
    Some(Context { gravity, cell, surface, symmetric, symmetric_x, law, velocity, slab })
}

/// All bodies, or `None` if any of them is wrong.
fn bodies(schema: &Schema, context: &Context, problems: &mut Problems) -> Option<Vec<Body>> {
    let all: Vec<_> = schema.bodies.iter().map(|section| body::body(section, context, problems)).collect();
    all.into_iter().collect()
}

/// The name of the case, which becomes that of a folder.
fn name(top: &Section, source_name: &str, problems: &mut Problems) -> Option<String> {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if !top.has("name") {
        let stem = std::path::Path::new(source_name)
            .file_stem()
            .map_or_else(String::new, |s| s.to_string_lossy().into());
        let plain: String =
            stem.chars().map(|c| if is_plain(c) { c } else { '-' }).take(MAX_LETTERS).collect();
        let plain = if is_device(&plain) { format!("{plain}-case") } else { plain };
        return Some(if plain.is_empty() { "case".to_owned() } else { plain });
    }
    let typed = top.text("name")?;
    let fits = !typed.value.is_empty() && typed.value.len() <= MAX_LETTERS;
    if fits && typed.value.chars().all(is_plain) && !is_device(&typed.value) {
        return Some(typed.value);
    }
    let message = format!("\"{}\" is not a valid name for the results folder", typed.value);
    problems.add(
        &typed.location,
        message,
        "use 1 to 100 letters, digits, `-` and `_`, but not the name of a Windows device",
    );
    None
}

const MAX_LETTERS: usize = 100;

/// Default distance of contact points from sharp edges [cell widths].
const EDGE_INSET: f64 = 0.5;

fn numerics(section: &Section, law: Option<Law>, problems: &mut Problems) -> Option<Numerics> {
    // Undrained soil tolerates and needs more viscosity: its contact pressure does not vanish at the surface. So does metal.
    let viscosity = if matches!(law, Some(Law::Tresca { .. } | Law::VonMises { .. })) { 0.06 } else { 0.02 };
    let mut or = |key, default, allowed| ranges::or(section, key, default, allowed, problems);
    let courant = or("courant", 0.5, &POSITIVE_FRACTION);
    let remap_displacement = or("remap_displacement", 0.1, &POSITIVE_FRACTION);
    let hourglass = or("hourglass", 0.01, &NOT_NEGATIVE);
    let hourglass_yielding = or("hourglass_yielding", 1.0, &ranges::FRACTION);
    let bulk_viscosity_linear = or("bulk_viscosity_linear", viscosity, &NOT_NEGATIVE);
    let bulk_viscosity_quadratic = or("bulk_viscosity_quadratic", 1.2, &NOT_NEGATIVE);
    let edge_inset = or("edge_inset", EDGE_INSET, &NOT_NEGATIVE);
    let point_spacing = or("point_spacing", 0.25, &ranges::SPACING);
    let threads = or("threads", 0.0, &ranges::THREADS);
    let contact = match section.text("contact") {
        Some(typed) if typed.value == "penalty" => Contact::Penalty,
        _ => Contact::Impulse,
    };
    let precision = match section.text("precision") {
        Some(typed) if typed.value == "single" => Precision::Single,
        _ => Precision::Double,
    };
    Some(Numerics {
        courant: courant?,
        remap_displacement: remap_displacement?,
        hourglass: hourglass?,
        hourglass_yielding: hourglass_yielding?,
        bulk_viscosity_linear: bulk_viscosity_linear?,
        bulk_viscosity_quadratic: bulk_viscosity_quadratic?,
        contact,
        edge_inset: edge_inset?,
        point_spacing: point_spacing?,
        threads: threads? as usize,
        precision,
    })
}
