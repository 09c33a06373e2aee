//! Joints: their numbers, and the planes that they must keep to.

use super::keys::{FIELDS, KEYS};
use super::{Joint, JointKind};
use crate::body::{Body, Guide};
use crate::domain::Domain;
use crate::key::in_range;
use glam::DVec3;
use input::key::{in_ranges, numbers as placed};
use input::problem::Problems;
use mechanics::Motion;

/// Reports joints that name bodies which are not there, with numbers out of range, or off a plane of
/// symmetry.
pub(crate) fn joints(joints: &[Joint], bodies: &[Body], domain: &Domain, problems: &mut Problems) {
    for (number, joint) in joints.iter().enumerate() {
        let path = joint.path();
        let exists = |body: usize| body < bodies.len();
        if !exists(joint.second) || joint.first.is_some_and(|n| !exists(n) || n == joint.second) {
            let message = "it does not connect two bodies of the case";
            problems.add(format!("{path}.bodies"), message, "name two bodies, or the ground and a body");
            continue;
        }
        if joint.is_contact() {
            let surfaceless = |n: Option<usize>| n.is_none_or(|n| !bodies[n].has_surface());
            if surfaceless(joint.first) || surfaceless(Some(joint.second)) {
                let message = "a body without a surface touches nothing";
                problems.add(format!("{path}.bodies"), message, "name two bodies with a shape");
                continue;
            }
            contact(joint, &joints[..number], bodies, problems);
        }
        if numbers(&path, joint, problems) {
            keeps_to_the_planes(joint, bodies[joint.second].position.y, domain, problems);
        }
    }
}

/// Reports contact that is there already, and contact of bodies of which neither can give way.
fn contact(joint: &Joint, before: &[Joint], bodies: &[Body], problems: &mut Problems) {
    let path = format!("{}.bodies", joint.path());
    let pair = |joint: &Joint| {
        let first = joint.first.unwrap_or(joint.second);
        [first.min(joint.second), first.max(joint.second)]
    };
    let is_same = |other: &&Joint| other.is_contact() && pair(other) == pair(joint);
    if let Some(same) = before.iter().find(is_same) {
        let message = format!("they are in contact by [{}] already", same.path());
        problems.add(&*path, message, "remove one of the two");
    }
    let gives_way = |n: usize| {
        let Guide { translation, rotation, .. } = bodies[n].guided();
        let mut motions = translation.iter().chain(&rotation).chain([bodies[n].spin()]);
        motions.any(Motion::is_free)
    };
    if !pair(joint).into_iter().any(gives_way) {
        let message = "neither of the two can give way: they would move through each other";
        problems.add(path, message, "give one of them a free motion, such as heave = \"free\"");
    }
}

/// Whether the numbers of a joint are in range; reported if not.
fn numbers(path: &str, joint: &Joint, problems: &mut Problems) -> bool {
    let before = problems.len();
    let mut vector = |name: &str, vector: DVec3| in_range(KEYS, path, name, &vector.to_array(), problems);
    vector("at", joint.position);
    match joint.kind {
        JointKind::Hinge { axis, .. } | JointKind::Slider { axis } => vector("axis", axis),
        JointKind::Spring { from, .. } => vector("from", from),
        JointKind::Ball | JointKind::Contact { .. } => true,
    };
    in_ranges(path, &placed(FIELDS, joint), problems);
    problems.len() == before
}

/// In a symmetric or a plane strain case a joint lies in the plane of the body, at y = `middle` [m], and
/// moves it in this plane.
fn keeps_to_the_planes(joint: &Joint, middle: f64, domain: &Domain, problems: &mut Problems) {
    let path = joint.path();
    if domain.symmetric_x {
        let message = "a case that is symmetric about x = 0 allows no joints";
        problems.add(path, message, "remove the joint, or symmetric_x = true");
        return;
    }
    if !(domain.symmetric || domain.plane_strain) {
        return;
    }
    let (key, is_across) = match joint.kind {
        JointKind::Hinge { axis, .. } => ("axis", axis.x == 0.0 && axis.z == 0.0),
        JointKind::Ball | JointKind::Contact { .. } => ("kind", true),
        JointKind::Slider { axis } => ("axis", axis.y == 0.0),
        JointKind::Spring { from, .. } => ("from", from.y == middle),
    };
    let message = "in a symmetric or a plane strain case a joint moves a body in the plane of the tow only";
    if !is_across {
        problems.add(format!("{path}.{key}"), message, "change it, or model the whole width");
    } else if joint.position.y != middle {
        problems.add(format!("{path}.at"), message, "put it in this plane, or model the whole width");
    }
}
