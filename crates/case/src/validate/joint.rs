//! Joints: their numbers, and the planes that they must keep to.

use crate::numbers::in_range;
use crate::resolved::{Case, Joint, JointKind};
use input::problem::Problems;

/// Reports joints that name bodies which are not there, with numbers out of range, or off a plane of
/// symmetry.
pub(super) fn joints(case: &Case, problems: &mut Problems) {
    for joint in &case.joints {
        let path = format!("joint.{}", joint.name);
        let exists = |body: usize| body < case.bodies.len();
        if !exists(joint.second) || joint.first.is_some_and(|n| !exists(n) || n == joint.second) {
            let message = "it does not connect two bodies of the case";
            problems.add(format!("{path}.bodies"), message, "name two bodies, or the ground and a body");
            continue;
        }
        if numbers(&path, joint, problems) {
            keeps_to_the_planes(&path, joint, case, problems);
        }
    }
}

/// Whether its numbers are in range; reported if not.
fn numbers(path: &str, joint: &Joint, problems: &mut Problems) -> bool {
    let before = problems.len();
    let mut check = |key: &str, number| {
        in_range(&format!("{path}.{key}"), number, problems);
    };
    joint.position.to_array().into_iter().for_each(|x| check("at", x));
    match joint.kind {
        JointKind::Hinge { axis, friction_torque, drive_torque } => {
            axis.to_array().into_iter().for_each(|x| check("axis", x));
            check("friction_torque", friction_torque);
            check("drive_torque", drive_torque);
        }
        JointKind::Ball => {}
        JointKind::Slider { axis } => axis.to_array().into_iter().for_each(|x| check("axis", x)),
        JointKind::Spring { from, stiffness, damping, length, .. } => {
            from.to_array().into_iter().for_each(|x| check("from", x));
            check("stiffness", stiffness);
            check("damping", damping);
            check("length", length);
        }
    }
    problems.len() == before
}

/// In a symmetric or a plane strain case a joint lies in the plane of the body, and moves it in this plane.
fn keeps_to_the_planes(path: &str, joint: &Joint, case: &Case, problems: &mut Problems) {
    let domain = &case.domain;
    if domain.symmetric_x {
        let message = "a case that is symmetric about x = 0 allows no joints";
        problems.add(path, message, "remove the joint, or symmetric_x = true");
        return;
    }
    if !(domain.symmetric || domain.plane_strain) {
        return;
    }
    let middle = case.bodies[joint.second].position.y;
    let (key, is_across) = match joint.kind {
        JointKind::Hinge { axis, .. } => ("axis", axis.x == 0.0 && axis.z == 0.0),
        JointKind::Ball => ("kind", true),
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
