//! The joints of a case: `[joint.NAME]`.

use crate::case_text::{CaseText, digits, quantity};
use crate::connectors::{Joint, Kind};
use crate::facts::Facts;
use crate::notes::Notes;
use crate::springs::Spring;

/// Writes the joints; `surface` is the height of the ground [m].
pub(super) fn joints(notes: &mut Notes, text: &mut CaseText, facts: &Facts, surface: f64) {
    for joint in &facts.gear.joints {
        match one(notes, text, facts, joint, surface) {
            Ok(()) => notes.understood(joint.block, format!("joint {}", joint.name)),
            Err(message) => notes.refused(joint.block, message),
        }
    }
}

fn one(notes: &Notes, text: &mut CaseText, facts: &Facts, joint: &Joint, surface: f64) -> Result<(), String> {
    let setup = &facts.setup;
    if setup.symmetric[1] {
        return Err("a case that is symmetric about x = 0 has no joints: model both halves".to_owned());
    }
    let in_plane = setup.symmetric[0] || setup.is_plane_strain;
    let section = format!("joint.{}", joint.name);
    let comment = notes.origin(joint.block);
    let name = |end: Option<usize>| end.map_or("ground", |body| facts.bodies[body].name.as_str());
    let (kind, axis) = match &joint.kind {
        Kind::Hinge(axis) => ("hinge", Some(axis)),
        Kind::Slider(axis) => ("slider", Some(axis)),
        Kind::Ball | Kind::Weld => ("ball", None),
        Kind::Spring(spring) => (if spring.is_cable { "cable" } else { "spring" }, None),
    };
    text.set(&section, "kind", format!("\"{kind}\""), &comment);
    let [first, second] = joint.ends.map(name);
    text.set(&section, "bodies", format!("[\"{first}\", \"{second}\"]"), "");
    let points = if let Kind::Spring(_) = joint.kind { joint.at } else { [joint.pivot; 2] };
    let points = points.map(|point| setup.frame.point(point).map(|x| x * facts.units.length));
    let width = facts.units.length
        * facts
            .mesh
            .faces
            .iter()
            .flat_map(|planes| planes.windows(2))
            .map(|pair| pair[1] - pair[0])
            .fold(f64::INFINITY, f64::min);
    let is_off = setup.symmetric[0] && points.iter().any(|point| point[1].abs() > 1e-3 * width);
    if is_off || setup.is_plane_strain && (points[0][1] - points[1][1]).abs() > 1e-3 * width {
        return Err("it does not lie in the plane in which the bodies move".to_owned());
    }
    let written = |point: [f64; 3]| {
        let numbers = [point[0], if in_plane { 0.0 } else { point[1] }, point[2] - surface];
        format!("[{}]", numbers.map(|x| quantity(x, "m")).join(", "))
    };
    text.set(&section, "at", written(points[1]), "height over the soil");
    if let Some(axis) = axis {
        let axis = setup.frame.direction(*axis).map(|x| if x.abs() < 1e-9 { 0.0 } else { x });
        let is_across = axis[0] == 0.0 && axis[2] == 0.0;
        if in_plane && is_across != (kind == "hinge") {
            return Err("it moves a body out of the plane in which the bodies move".to_owned());
        }
        text.set(&section, "axis", format!("[{}]", axis.map(digits).join(", ")), "");
    }
    if let Some((torque, steps)) = joint.torque {
        if steps != facts.moves.len() {
            return Err("a torque between two bodies that both turn ends with its step: keep it to the end"
                .to_owned());
        }
        let unit = facts.units.force() * facts.units.length * facts.share();
        text.set(&section, "drive_torque", quantity(torque * unit, "N*m"), "");
    }
    if let Kind::Spring(spring) = &joint.kind {
        text.set(&section, "from", written(points[0]), "");
        spring_keys(text, &section, facts, spring, points);
    }
    Ok(())
}

fn spring_keys(text: &mut CaseText, section: &str, facts: &Facts, spring: &Spring, ends: [[f64; 3]; 2]) {
    let (units, share) = (&facts.units, facts.share());
    let stiffness = share * units.force() / units.length;
    text.set(section, "stiffness", quantity(spring.stiffness * stiffness, "N/m"), "");
    if spring.damping > 0.0 {
        text.set(section, "damping", quantity(spring.damping * stiffness * units.time, "N*s/m"), "");
    }
    let distance = (0..3).map(|n| (ends[1][n] - ends[0][n]).powi(2)).sum::<f64>().sqrt();
    let length = spring.length.map_or(distance, |length| length * units.length) + spring.slack * units.length;
    text.set(section, "length", quantity(length, "m"), "without force");
}
