//! From what was typed to what it means: what is derived from other keys is filled in. Only problems of form
//! are found here, such as keys that are missing or contradict each other; each part is then given to
//! `validate` before anything is derived from it.

use super::body::{self, Body, Others};
use super::context::Context;
use super::grid::Cells;
use super::joint::{self, Joint};
use super::key::{all, checked, missing, range};
use super::layer::Layer;
use super::path::Paths;
use super::relief::Relief;
use super::resolved::{Case, Law, MOTIONS, Measured, MotionTable, Numerics, Output, Soil, SoilBody, Water};
use super::shapes::slab::Slab;
use super::slope::Slope;
use super::soil::{Conditions, soil};
use super::soil_body::soil_body;
use super::stage::{self, Stage};
use super::typed_case::Schema;
use super::{domain, grid, ground, run, top, validate};
use glam::DVec3;
use input::problem::Problems;
use input::typed::Section;

/// The case that was typed, or `None` with problems added.
pub(super) fn resolve(schema: &Schema, source_name: &str, problems: &mut Problems) -> Option<Case> {
    let gravity = schema.top.number("gravity");
    let slope = Slope::typed(&schema.ground, problems);
    let water = Water::typed(schema.water.as_ref(), problems);
    let given = gravity.zip(water);
    let conditions =
        given.map(|(g, water)| Conditions { gravity: on_soil(g, water), slope: slope.unwrap_or_default() });
    let soil = conditions.and_then(|conditions| soil(&schema.soil, conditions, problems));
    let layers = conditions.and_then(|conditions| Layer::all(&schema.layers, conditions, problems));
    let numerics = Numerics::typed(&schema.numerics, &schema.soil, problems);
    let relief = Relief::typed(schema.height_map.as_ref(), schema.furrows.as_ref(), problems);
    let law = soil.as_ref().map(|s| s.law);
    let about = given.map(|(gravity, water)| About { gravity, water, law, relief: relief.as_ref() });
    let cells = about.and_then(|about| cells(schema, about, soil.as_ref(), problems));
    let mut context = about.zip(cells).and_then(|(about, cells)| context(schema, about, cells, problems));
    let soil_bodies = context.as_mut().and_then(|context| soil_bodies(schema, context, problems));
    let parts = context.as_ref().and_then(|context| parts(schema, context, problems));
    let (bodies, joints, stages) = parts.map_or((None, None, None), |(b, j, s)| (Some(b), Some(j), Some(s)));
    let name = top::name(&schema.top, source_name, problems);
    let duration = bodies.as_ref().and_then(|bodies| duration(schema, bodies, stages.as_deref(), problems));
    let forecast = Measured::typed(&schema.forecast, problems);
    let output = duration.and_then(|d| Output::typed(&schema.output, d, problems));
    let (context, bodies) = (context?, bodies?);
    let follow = grid::follow(&schema.grid, &bodies, problems)?;
    let duration = duration?;
    let paths = Paths { bodies: &bodies, follow, duration };
    let domain = domain::domain(&schema.domain, &context, &paths, problems)?;
    let ground = ground::ground(&schema.ground, context.surface, &domain, problems)?;
    let (soil, velocity) = (soil?, ground::velocity(&schema.ground, &domain, problems)?);
    let overburden = ground::overburden(&schema.ground, &soil, ground.surface(), &domain, problems)?;
    validate::fit::bodies_fit(&paths, &domain, problems);
    let grid = grid::grid(&schema.grid, &context, &domain, &ground, &paths, problems)?;
    let name = name?;
    Some(Case {
        title: schema.top.text("title").unwrap_or_else(|| name.clone()),
        name,
        gravity: gravity?,
        slope: slope?,
        water: water?,
        soil,
        layers: layers?,
        soil_bodies: soil_bodies?,
        ground,
        relief: relief?,
        overburden,
        velocity,
        domain,
        grid,
        bodies,
        joints: joints?,
        stages: stages?,
        tables: tables(schema),
        remarks: problems.remarks().to_vec(),
        duration,
        output: output?,
        numerics: numerics?,
        forecast: forecast?,
    })
}

/// The name of the case and its soil alone, or `None` with problems added.
pub(super) fn soil_alone(
    schema: &Schema,
    source_name: &str,
    problems: &mut Problems,
) -> Option<(String, Soil)> {
    let gravity = schema.top.number("gravity");
    let gravity = gravity.filter(|g| top::check_gravity(*g, problems));
    let water = Water::typed(schema.water.as_ref(), problems);
    let gravity = gravity.zip(water).map(|(g, water)| on_soil(g, water));
    let soil = gravity
        .and_then(|g| soil(&schema.soil, Conditions { gravity: g, slope: Slope::default() }, problems));
    Some((top::name(&schema.top, source_name, problems)?, soil?))
}

/// Weight per mass of soil [m/s²], which water makes less.
fn on_soil(gravity: f64, water: Option<Water>) -> f64 {
    water.map_or(gravity, |water| water.soil_gravity(gravity))
}

/// What is known of the case before its bodies.
#[derive(Clone, Copy)]
struct About<'a> {
    /// Acceleration of gravity [m/s²].
    gravity: f64,
    water: Option<Water>,
    /// Yield law of the soil, if it could be read.
    law: Option<Law>,
    relief: Option<&'a Relief>,
}

/// The cells: as typed, or such that they resolve the bodies, which are read for it on cells of any size
/// first.
fn cells(schema: &Schema, about: About, soil: Option<&Soil>, problems: &mut Problems) -> Option<Cells> {
    const ANY: f64 = 1e-3;
    let (size, aspect) = grid::cells(&schema.grid, problems)?;
    let of_size = |size: f64| Cells { size, aspect: aspect.unwrap_or(DVec3::ONE) };
    if size.is_some() {
        return size.map(of_size);
    }
    let mut found = Problems::without_resolution();
    let mut on_any = || {
        let mut context = context(schema, about, of_size(ANY), &mut found)?;
        soil_bodies(schema, &mut context, &mut found)?;
        let (bodies, _, stages) = parts(schema, &context, &mut found)?;
        let duration = duration(schema, &bodies, Some(&stages), &mut found)?;
        Some((context, bodies, duration))
    };
    let read = on_any();
    problems.append(found);
    let (context, bodies, duration) = read?;
    let Some((cells, why)) = grid::usual(&bodies, aspect, soil?, &context, duration) else {
        missing(grid::KEYS, &schema.grid, "cell", problems);
        return None;
    };
    problems.remark(why);
    Some(cells)
}

fn context(schema: &Schema, about: About, cells: Cells, problems: &mut Problems) -> Option<Context> {
    let About { gravity, water, law, relief } = about;
    let Cells { size: cell, aspect } = cells;
    let surface = schema.ground.number("surface");
    let [symmetric, symmetric_x, plane_strain] =
        ["symmetric", "symmetric_x", "plane_strain"].map(|key| schema.domain.flag(key).unwrap_or_default());
    checked((), problems, |(), problems| domain::planes(symmetric, plane_strain, problems))?;
    let slab = if plane_strain {
        let [low, high] = range(domain::KEYS, &schema.domain, "y", Some([0.0, cell * aspect.y]), problems)?;
        let inset = schema.numerics.number("edge_inset")?;
        Some(Slab { width: high - low, middle: 0.5 * (low + high), inset: inset * (high - low) })
    } else {
        None
    };
    let velocity = ground::typed_velocity(&schema.ground);
    let surface = surface?;
    let between = match relief.filter(|relief| !relief.is_level()) {
        Some(relief) => relief.of_solver().range().map(|rise| surface + rise),
        None => [surface; 2],
    };
    let slope = Slope::typed(&schema.ground, problems)?;
    let mut soils = std::iter::once(&schema.soil).chain(&schema.layers).chain(&schema.soil_bodies);
    let has_undrained_soil = soils.any(|soil| soil.text("law").as_deref() == Some("tresca"));
    Some(Context {
        gravity,
        water,
        slope,
        cell,
        aspect,
        surface,
        between,
        symmetric,
        symmetric_x,
        law,
        has_undrained_soil,
        velocity,
        slab,
    })
}

/// All soil bodies, or `None` if any of them is wrong; heaps raise the highest surface.
fn soil_bodies(schema: &Schema, context: &mut Context, problems: &mut Problems) -> Option<Vec<SoilBody>> {
    let gravity = on_soil(context.gravity, context.water);
    let bodies = all(&schema.soil_bodies, |section| soil_body(section, context, gravity, problems))?;
    let tops = bodies.iter().map(|body| body.solver_body(0).bounds[1].z);
    context.between[1] = tops.fold(context.between[1], f64::max);
    Some(bodies)
}

/// All bodies, or `None` if any of them is wrong.
fn bodies(schema: &Schema, context: &Context, problems: &mut Problems) -> Option<Vec<Body>> {
    let others = Others { carried: &joint::carried(&schema.joints), stages: &schema.stages };
    all(&schema.bodies, |section| body::body(section, &others, context, problems))
}

/// The files of tables that motions follow.
fn tables(schema: &Schema) -> Vec<MotionTable> {
    let in_stages = schema.stages.iter().flat_map(|stage| &stage.inner);
    let of_section = |section: &Section| {
        let table = |key: &str| {
            let file = section.motion(key)?.table?;
            let keys = section.path.split('.').chain([key]).map(str::to_owned).collect();
            Some(MotionTable { keys, path: section.folder.join(file) })
        };
        MOTIONS.into_iter().filter_map(table).collect::<Vec<_>>()
    };
    schema.bodies.iter().chain(in_stages).flat_map(of_section).collect()
}

/// When the run ends [s].
fn duration(
    schema: &Schema,
    bodies: &[Body],
    stages: Option<&[Stage]>,
    problems: &mut Problems,
) -> Option<f64> {
    run::duration(&schema.run, bodies, &schema.stages, stages, problems)
}

/// The bodies that move for themselves, the joints between them, and the stages.
fn parts(
    schema: &Schema,
    context: &Context,
    problems: &mut Problems,
) -> Option<(Vec<Body>, Vec<Joint>, Vec<Stage>)> {
    let bodies = bodies(schema, context, problems)?;
    body::sections(&schema.bodies, problems);
    let joints = all(&schema.joints, |section| joint::typed(section, &bodies, context.surface, problems))?;
    let before = problems.len();
    let roots = body::roots(&schema.bodies, &bodies, problems)?;
    let mut joints = joint::between_wholes(joints, &bodies, &roots, problems);
    // As a mechanism has them.
    joints.sort_by_key(Joint::is_contact);
    let mut bodies = body::joined(&bodies, &roots, problems);
    if problems.len() > before {
        return None;
    }
    let stages = stage::stages(&schema.stages, &bodies, context, problems)?;
    stage::guide(&stages, &mut bodies, context.surface);
    let bodies = joint::guide_all(&joints, bodies, problems)?;
    Some((bodies, joints, stages))
}
