//! The case as understood, in words.

use coulter::case::Case;
use coulter::case::mesh_file::MeshReport;
use coulter::case::quantity::{short, short_stress};
use coulter::case::resolved::{Attitude, GROUND, Joint, JointKind, Measured, Motion, Soil, Until, Water};
use coulter::case::{told_of_body, told_of_stage};
use coulter::history::reference::Groups;
use glam::DVec3;
use std::fmt::Write;

/// Soil and bodies of a case.
pub(super) fn describe(text: &mut String, case: &Case) -> std::fmt::Result {
    writeln!(text, "{} ({})", case.title, case.name)?;
    describe_soil(text, &case.soil)?;
    for layer in &case.layers {
        writeln!(text, "layer    {}, from a depth of {} m", layer.name, short(layer.top))?;
        describe_soil(text, &layer.soil)?;
    }
    describe_relief(text, case)?;
    describe_water(text, case)?;
    if !case.slope.is_level() {
        let [along, across] = case.slope.angles().map(f64::to_degrees);
        writeln!(
            text,
            "slope    {}° along x, {}° along y, uphill; z is normal to the surface",
            short(along),
            short(across)
        )?;
    }
    for (number, body) in case.bodies.iter().enumerate() {
        describe_body(text, case, number)?;
        for part in &body.parts {
            let shape = part.shape.describe(&|x: f64| format!("{} m", short(x)));
            writeln!(
                text,
                "part     {}: {shape}, m = {} kg, welded to {}",
                part.name,
                short(part.mass),
                body.name
            )?;
        }
    }
    for number in 0..case.stages.len() {
        describe_stage(text, case, number)?;
    }
    for joint in &case.joints {
        describe_joint(text, case, joint)?;
    }
    if case.forecast != Measured::default() {
        writeln!(
            text,
            "note     the keys of [forecast] are used by `coulter forecast` only; a run ignores them"
        )?;
    }
    Ok(())
}

/// The relief of the ground, and the soil bodies in it.
fn describe_relief(text: &mut String, case: &Case) -> std::fmt::Result {
    for body in &case.soil_bodies {
        let shape = body.shape.describe(&|x: f64| format!("{} m", short(x)));
        let [x, y, z] = body.position.to_array().map(short);
        writeln!(text, "inside   soil body {}: {shape}, at ({x}, {y}, {z}) m", body.name)?;
        describe_soil(text, &body.soil)?;
    }
    if let Some(map) = &case.relief.map {
        let ([columns, rows], [low, high]) = (map.heights().size(), map.heights().range().map(short));
        writeln!(
            text,
            "surface  height map {}, {columns} × {rows} points, from {low} to {high} m",
            map.file
        )?;
    }
    if let Some(furrows) = case.relief.furrows {
        writeln!(
            text,
            "surface  furrows {} m deep, {} m apart, at {}° from x, up to {}° steep",
            short(furrows.depth),
            short(furrows.spacing),
            degrees(furrows.direction),
            degrees(furrows.steepest().atan())
        )?;
    }
    Ok(())
}

/// The water, and whether it drains from the soil.
fn describe_water(text: &mut String, case: &Case) -> std::fmt::Result {
    let Some(water) = case.water else { return Ok(()) };
    write!(
        text,
        "water    up to {} m, ρ_w = {} kg/m³, C_d = {}",
        short(water.level),
        short(water.density),
        short(water.drag_coefficient)
    )?;
    let (Some(permeability), Some(strain)) = (water.permeability, case.volume_strain()) else {
        return writeln!(text);
    };
    write!(text, ", k = {} m/s, ε = {}", short(permeability), short(strain))?;
    match case.drainage_number() {
        Some(number) => writeln!(
            text,
            "\n         drainage number (γ_w/γ′) v ε/k = {} at {} m/s: {}",
            short(number),
            short(case.largest_speed()),
            match number {
                n if n <= Water::DRAINED[0] => "drained",
                n if n <= Water::DRAINED[1] => "partly drained, doubtful",
                _ => "does not drain",
            }
        ),
        None => writeln!(text),
    }
}

/// The soil of a case.
pub(crate) fn describe_soil(text: &mut String, soil: &Soil) -> std::fmt::Result {
    writeln!(text, "soil     {}", soil.spelled_out())?;
    writeln!(
        text,
        "         γ = {} kN/m³, ρ = {} kg/m³, E = {}, ν = {}, K₀ = {}",
        short(soil.unit_weight / 1e3),
        short(soil.density),
        short_stress(soil.young_modulus),
        short(soil.poisson_ratio),
        short(soil.k0)
    )
}

/// An angle [rad] in degrees.
fn degrees(angle: f64) -> String {
    short(angle.to_degrees())
}

fn describe_body(text: &mut String, case: &Case, number: usize) -> std::fmt::Result {
    let body = &case.bodies[number];
    let metres = |x: f64| format!("{} m", short(x));
    let shape = body.shape.describe(&metres);
    if !body.shape.has_surface() {
        writeln!(text, "body     {}: {shape}, m = {} kg", body.name, short(body.mass))?;
        return describe_motions(text, case, number);
    }
    let mut friction =
        if body.friction.is_finite() { format!("μ = {}", body.friction) } else { "rough".into() };
    if body.adhesion_factor.is_finite() {
        friction += &format!(", at most {} s_u", body.adhesion_factor);
    }
    let weight = match body.translation[2] {
        Motion::Free { .. } if case.water.is_some() => {
            let [dry, wet] = [case.gravity * body.mass, case.weight(body)].map(short);
            format!(", W = {dry} N, W′ = {wet} N in water")
        }
        Motion::Free { .. } => format!(", W = {} N", short(case.gravity * body.mass)),
        _ => String::new(),
    };
    writeln!(text, "body     {}: {shape}, {friction}, m = {} kg{weight}", body.name, short(body.mass))?;
    if let Some(report) = body.shape.mesh_report() {
        describe_mesh(text, report)?;
    }
    let Attitude { yaw, tilt, pitch } = body.attitude;
    if body.attitude != Attitude::default() {
        writeln!(
            text,
            "         attitude yaw {}°, tilt {}°, pitch {}°",
            degrees(yaw),
            degrees(tilt),
            degrees(pitch)
        )?;
    }
    describe_motions(text, case, number)?;
    let groups = Groups::of(case, body);
    let optional =
        [("W̄", groups.w_bar), ("Ē", groups.e_bar), ("c̄", groups.c_bar), ("v²/(gd)", groups.froude)];
    let mut list = format!("t̄ = {}", short(groups.t_bar));
    for (name, value) in optional {
        if let Some(value) = value {
            write!(list, ", {name} = {}", short(value))?;
        }
    }
    writeln!(text, "         {list}")
}

/// The degrees of freedom of a body, one a line.
fn describe_motions(text: &mut String, case: &Case, number: usize) -> std::fmt::Result {
    let body = &case.bodies[number];
    if body.guide.is_some() && body.motions().iter().all(Motion::is_free) {
        return writeln!(text, "         guided by its joint");
    }
    told_of_body(case, number).iter().try_for_each(|told| {
        let name = told.path.rsplit('.').next().unwrap_or_default();
        writeln!(text, "         {name:11} {}", told.words)
    })
}

/// A stage: how long it lasts, and the motions that change.
fn describe_stage(text: &mut String, case: &Case, number: usize) -> std::fmt::Result {
    let stage = &case.stages[number];
    match stage.until {
        None => writeln!(text, "stage    {}: {} s", stage.name, short(stage.duration))?,
        Some(Until { body, quantity, value }) => {
            let [name, unit] = quantity.words();
            writeln!(
                text,
                "stage    {}: until {} has a {name} of {} {unit}, at most {} s",
                stage.name,
                case.bodies[body].name,
                short(value),
                short(stage.duration)
            )?;
        }
    }
    told_of_stage(case, number).iter().try_for_each(|told| {
        let name = told.path.splitn(3, '.').last().unwrap_or_default();
        writeln!(text, "         {name:11} {}", told.words)
    })
}

fn describe_joint(text: &mut String, case: &Case, joint: &Joint) -> std::fmt::Result {
    let name = |body: usize| &*case.bodies[body].name;
    let first = joint.first.map_or(GROUND, name);
    write!(text, "joint    {}: {}, {first} – {}", joint.name, joint.kind.word(), name(joint.second))?;
    let direction = |axis: DVec3| axis.to_array().map(short).join(", ");
    match joint.kind {
        JointKind::Hinge { axis, friction_torque, drive_torque } => {
            write!(text, ", axis ({})", direction(axis))?;
            for (name, torque) in [("friction", friction_torque), ("drive", drive_torque)] {
                if torque != 0.0 {
                    write!(text, ", {name} {} N m", short(torque))?;
                }
            }
        }
        JointKind::Ball => {}
        JointKind::Contact { friction, restitution } => {
            return writeln!(text, ", friction {}, restitution {}", short(friction), short(restitution));
        }
        JointKind::Slider { axis } => write!(text, ", axis ({})", direction(axis))?,
        JointKind::Spring { stiffness, damping, length, .. } => {
            write!(text, ", {} N/m, {} N s/m, {} m long", short(stiffness), short(damping), short(length))?;
        }
    }
    let [x, y, z] = joint.position.to_array().map(short);
    writeln!(text, ", at ({x}, {y}, {z}) m")
}

/// What the surface of a body is like that was read from a file.
fn describe_mesh(text: &mut String, report: &MeshReport) -> std::fmt::Result {
    // Round-off of the sums is no offset.
    let round_off = 1e-12 * report.size.max_element();
    let [x, y, z] = report.centroid.to_array().map(|x| if x.abs() < round_off { 0.0 } else { x });
    let shells = if report.shells == 1 { "1 shell".to_owned() } else { format!("{} shells", report.shells) };
    let cavities = match report.cavities {
        0 => String::new(),
        count => format!(" ({count} of cavities)"),
    };
    writeln!(
        text,
        "         surface closed, {} points, {shells}{cavities}, V = {} m³, centroid at ({}, {}, {}) m",
        report.points,
        short(report.volume),
        short(x),
        short(y),
        short(z)
    )?;
    report.repairs.iter().try_for_each(|repair| writeln!(text, "         repaired {repair}"))
}
