//! The case in a few words, for the top of a report.

use case::resolved::{Attitude, Body, Case, Change, GROUND, Layer, Motion, Part, Soil, Stage, Until};
use input::readable::{Unit, degrees, digits, quantity, stress};

/// Soil and bodies, each as a name and a description.
pub(super) fn describe(case: &Case) -> Vec<[String; 2]> {
    let mut lines = vec![["Soil".to_owned(), soil(&case.soil)]];
    let depth = |layer: &Layer| quantity(layer.top, Unit::length(layer.top));
    let layer = |layer: &Layer| {
        [format!("Layer {}", layer.name), format!("from a depth of {}: {}", depth(layer), soil(&layer.soil))]
    };
    lines.extend(case.layers.iter().map(layer));
    lines.extend(case.soil_bodies.iter().map(|body| {
        let shape = body.shape.describe(&|value: f64| quantity(value, Unit::length(value)));
        [format!("Soil body {}", body.name), format!("{shape}: {}", soil(&body.soil))]
    }));
    lines.extend(relief(case));
    lines.extend(water(case));
    if !case.slope.is_level() {
        let [along, across] = case.slope.angles().map(degrees);
        lines.push([
            "Slope".to_owned(),
            format!("{along} along x, {across} along y, uphill; z is normal to the surface"),
        ]);
    }
    let several = case.bodies.len() > 1;
    for body in &case.bodies {
        let title = if several { body.name.clone() } else { "Body".to_owned() };
        lines.push([title, describe_body(case, body)]);
        let length = |value: f64| quantity(value, Unit::length(value));
        let part = |part: &Part| {
            [part.name.clone(), format!("{}, welded to {}", part.shape.describe(&length), body.name)]
        };
        lines.extend(body.parts.iter().map(part));
    }
    for stage in &case.stages {
        lines.push([format!("Stage {}", stage.name), describe_stage(case, stage)]);
    }
    for joint in &case.joints {
        let name = |body: usize| &*case.bodies[body].name;
        let first = joint.first.map_or(GROUND, name);
        let text = format!("{} between {first} and {}", joint.kind.word(), name(joint.second));
        lines.push([joint.name.clone(), text]);
    }
    lines
}

/// The relief of the ground.
fn relief(case: &Case) -> Option<[String; 2]> {
    let length = |value: f64| quantity(value, Unit::length(value));
    let map = case.relief.map.as_ref().map(|map| {
        let [low, high] = map.heights().range();
        format!("height map {}, from {} to {}", map.file, length(low), length(high))
    });
    let furrows = case.relief.furrows.map(|furrows| {
        format!(
            "furrows {} deep, {} apart, at {} from x",
            length(furrows.depth),
            length(furrows.spacing),
            degrees(furrows.direction)
        )
    });
    let parts: Vec<String> = map.into_iter().chain(furrows).collect();
    (!parts.is_empty()).then(|| ["Surface".to_owned(), parts.join("; ")])
}

/// The water, and whether it drains from the soil.
fn water(case: &Case) -> Option<[String; 2]> {
    let water = case.water?;
    let depth = water.level - case.ground.surface();
    let mut text =
        format!("{} deep, ρ_w = {} kg/m³", quantity(depth, Unit::length(depth)), digits(water.density));
    if let Some((permeability, strain)) = water.permeability.zip(case.volume_strain()) {
        text += &format!(", k = {} m/s, ε = {}", digits(permeability), digits(strain));
    }
    if let Some(number) = case.drainage_number() {
        text += &format!(", drainage number {}", digits(number));
    }
    text += if water.pore_pressure { "; pore pressure computed" } else { "; drained" };
    Some(["Water".to_owned(), text])
}

fn soil(soil: &Soil) -> String {
    let weight = if soil.unit_weight > 0.0 {
        format!("γ = {} kN/m³", digits(soil.unit_weight / 1e3))
    } else {
        format!("weightless, ρ = {} kg/m³", digits(soil.density))
    };
    let [modulus, ratio] = [stress(soil.young_modulus), digits(soil.poisson_ratio)];
    format!("{}, E = {modulus}, ν = {ratio}, {weight}", soil.summary())
}

fn describe_body(case: &Case, body: &Body) -> String {
    let length = |value: f64| quantity(value, Unit::length(value));
    let shape = body.shape.describe(&length);
    if !body.shape.has_surface() {
        return format!("{shape}, mass {} kg; {}", digits(body.mass), motions(body));
    }
    let mut friction = if body.friction.is_finite() {
        format!("μ = {}", digits(body.friction))
    } else {
        "rough".to_owned()
    };
    if body.adhesion_factor.is_finite() {
        friction += &format!(", at most {} sᵤ", digits(body.adhesion_factor));
    }
    let weight = match body.translation[2] {
        Motion::Free { .. } => weight(case, body),
        _ => String::new(),
    };
    let Attitude { yaw, tilt, pitch } = body.attitude;
    let turned =
        [("yaw", yaw), ("tilt", tilt), ("pitch", pitch)].into_iter().filter(|(_, angle)| *angle != 0.0);
    let turned: String = turned.map(|(name, angle)| format!(", {name} {}", degrees(angle))).collect();
    format!("{shape}{turned}, {friction}{weight}; {}", motions(body))
}

/// Weight of a body with its parts, in air and in water.
fn weight(case: &Case, body: &Body) -> String {
    let mut text = format!(", weight {} N", digits(case.gravity * body.whole_mass()));
    if case.water.is_some() {
        text += &format!(" ({} N in water)", digits(case.weight(body)));
    }
    text
}

/// How long a stage lasts, and what changes in it.
fn describe_stage(case: &Case, stage: &Stage) -> String {
    let duration = format!("{} s", digits(stage.duration));
    let mut parts = vec![match stage.until {
        None => duration,
        Some(Until { body, quantity, value }) => {
            let [name, unit] = quantity.words();
            let body = &case.bodies[body].name;
            format!("until `{body}` has a {name} of {} {unit}, at most {duration}", digits(value))
        }
    }];
    for Change { body, motion: number, to } in &stage.changes {
        let [speed, load] = if *number < 3 { ["m/s", "N"] } else { ["rad/s", "N m"] };
        let name = format!("{} {}", case.bodies[*body].name, MOTION_NAMES[*number]);
        parts.push(motion(to, &name, speed, load));
    }
    parts.join("; ")
}

/// What the six motions are called in a report.
const MOTION_NAMES: [&str; 6] = ["tow", "lateral", "heave", "yaw", "tilt", "spin"];

/// How a body moves.
fn motions(body: &Body) -> String {
    if body.guide.is_some() && body.motions().iter().all(Motion::is_free) {
        return "guided by its joint".to_owned();
    }
    let [tow, lateral, heave] = &body.translation;
    let [yaw, tilt, spin] = &body.rotation;
    let motions = [
        (true, motion(tow, MOTION_NAMES[0], "m/s", "N")),
        (false, motion(lateral, MOTION_NAMES[1], "m/s", "N")),
        (true, motion(heave, MOTION_NAMES[2], "m/s", "N")),
        (false, motion(yaw, MOTION_NAMES[3], "rad/s", "N m")),
        (false, motion(tilt, MOTION_NAMES[4], "rad/s", "N m")),
        (true, motion(spin, MOTION_NAMES[5], "rad/s", "N m")),
    ];
    // Tow, heave and spin are always of interest, the others if they are not fixed.
    let shown = motions.into_iter().filter(|(always, text)| *always || !text.ends_with("fixed"));
    let motions: Vec<String> = shown.map(|(_, text)| text).collect();
    motions.join("; ")
}

fn motion(freedom: &Motion, name: &str, speed_unit: &str, load_unit: &str) -> String {
    match freedom {
        Motion::Fixed => format!("{name} fixed"),
        Motion::Prescribed { speed, .. } => format!("{name} {} {speed_unit}", digits(*speed)),
        Motion::Course(_) => format!("{name} by a given displacement"),
        Motion::Free { load: 0.0, .. } => format!("{name} free"),
        Motion::Free { load, .. } => format!("{name} free under {} {load_unit}", digits(*load)),
    }
}
