//! Bodies that are welded together become one, with parts.

use super::{Body, MOTIONS, Part};
use glam::{DQuat, DVec3};
use input::names::nearest;
use input::problem::Problems;
use input::typed::Section;

/// Reports motions of a welded body, and a mass that is missing: it counts for the whole.
pub(crate) fn sections(sections: &[Section], problems: &mut Problems) {
    for section in sections.iter().filter(|section| section.has("welded_to")) {
        for key in MOTIONS.into_iter().filter(|key| section.has(key)) {
            let message =
                format!("[{}] is welded to another body and has no motions of its own", section.path);
            problems.add(section.at(key), message, format!("remove `{key}`, or give it to that body"));
        }
        if !section.has("weight") && !section.has("mass") {
            let message = format!("the mass of [{}] counts for the whole, but is not given", section.path);
            problems.add(&section.path, message, "add  weight = \"40 N\"  or  mass = \"4 kg\"");
        }
    }
}

/// For each body the one that moves for it, by number: itself, or the end of the chain of welds.
pub(crate) fn roots(sections: &[Section], bodies: &[Body], problems: &mut Problems) -> Option<Vec<usize>> {
    let roots: Vec<_> = (0..bodies.len()).map(|n| root(sections, bodies, n, problems)).collect();
    roots.into_iter().collect()
}

/// The bodies that move for themselves, with those that are welded to them as their parts.
pub(crate) fn joined(bodies: &[Body], roots: &[usize], problems: &mut Problems) -> Vec<Body> {
    let members =
        |n: usize| bodies.iter().zip(roots).enumerate().filter(move |(m, (_, root))| **root == n && *m != n);
    let of = |n: usize| members(n).map(|(_, (body, _))| body).collect();
    let whole = (0..bodies.len()).filter(|n| roots[*n] == *n);
    whole.map(|n| with_parts(&bodies[n], of(n), problems)).collect()
}

/// The body at the end of a chain of welds.
fn root(sections: &[Section], bodies: &[Body], start: usize, problems: &mut Problems) -> Option<usize> {
    let section = |n: usize| sections.iter().find(|s| s.path.strip_prefix("body.") == Some(&bodies[n].name));
    let mut at = start;
    for _ in 0..=bodies.len() {
        let Some(own) = section(at).filter(|section| section.has("welded_to")) else { return Some(at) };
        let name = own.text("welded_to")?;
        let Some(next) = bodies.iter().position(|body| body.name == name) else {
            let cure = nearest(&name, bodies.iter().map(|body| &*body.name)).map_or_else(
                || "name one of the bodies".to_owned(),
                |near| format!("did you mean \"{near}\"?"),
            );
            if at == start {
                problems.add(own.at("welded_to"), format!("there is no body \"{name}\""), cure);
            }
            return None;
        };
        at = next;
    }
    let path = format!("body.{}.welded_to", bodies[start].name);
    problems.add(path, "bodies are welded to each other in a ring", "remove `welded_to` from one of them");
    None
}

/// A body with its parts.
fn with_parts(body: &Body, members: Vec<&Body>, problems: &mut Problems) -> Body {
    let frame = body.attitude.of_axle().inverse();
    let aligned = |rotation: DQuat| {
        // Two frames that are rotated alike differ by round-off.
        if rotation.xyz().length() < 1e-14 { DQuat::IDENTITY } else { rotation }
    };
    let mut whole = body.clone();
    for (n, member) in members.into_iter().enumerate() {
        if member.shape.has_surface() {
            if n == 0 && !body.shape.has_surface() {
                (whole.friction, whole.adhesion_factor) = (member.friction, member.adhesion_factor);
            }
            if [member.friction, member.adhesion_factor] != [whole.friction, whole.adhesion_factor] {
                let message =
                    format!("`{}` is welded to `{}`, but its friction differs", member.name, body.name);
                let cure = "bodies that are welded together have one coefficient of friction; use a hinge for different ones";
                problems.add(format!("body.{}.friction", member.name), message, cure);
            }
        }
        let offset: DVec3 = member.position - body.position;
        whole.parts.push(Part {
            name: member.name.clone(),
            shape: member.shape.clone(),
            offset: if body.attitude.axle_is_across() { offset } else { frame * offset },
            rotation: aligned(frame * member.attitude.of_axle()),
            pitch: member.attitude.pitch,
            mass: member.mass,
            axle_inertia: member.axle_inertia,
        });
    }
    whole
}
