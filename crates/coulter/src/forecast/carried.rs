//! The bodies of a case that touch the soil, each as if it moved by itself: what joints and frames mean for the closed forms.

use crate::case::resolved::{Body, Case, Motion};

/// The bodies with a surface. One that joints guide moves as its carrier does, and the weight of all that is joined together is
/// shared equally among the bodies that carry it.
pub(super) fn touching(case: &Case, remarks: &mut Vec<String>) -> Vec<Body> {
    let groups = groups(case);
    let mut shared = Vec::new();
    let each = case.bodies.iter().enumerate().filter(|(_, body)| body.shape.has_surface());
    let bodies = each.map(|(n, body)| {
        let Some(guide) = body.guide else { return body.clone() };
        let members: Vec<&Body> = case
            .bodies
            .iter()
            .zip(&groups)
            .filter(|(_, group)| **group == groups[n])
            .map(|(b, _)| b)
            .collect();
        let bearing = members.iter().filter(|member| member.shape.has_surface()).count() as f64;
        let load = |member: &&Body| match member.translation[2] {
            Motion::Free { load, .. } => load,
            _ => 0.0,
        };
        let mut moved = body.clone();
        moved.guide = None;
        moved.translation = guide.translation;
        moved.rotation[..2].copy_from_slice(&guide.rotation);
        if guide.translation[2].is_free() {
            moved.mass = members.iter().map(|member| member.mass).sum::<f64>() / bearing;
            let load = members.iter().map(load).sum::<f64>() / bearing;
            moved.translation[2] = Motion::loaded(load);
            if members.len() > 1 && !shared.contains(&groups[n]) {
                shared.push(groups[n]);
                remarks.push(format!(
                    "{} are joined: their weight is shared equally among those that touch the soil",
                    members.iter().map(|member| format!("`{}`", member.name)).collect::<Vec<_>>().join(", ")
                ));
            }
        }
        moved
    });
    bodies.collect()
}

/// For each body the number of the group that joints hold together; springs and cables hold nothing together.
fn groups(case: &Case) -> Vec<usize> {
    let mut group: Vec<usize> = (0..case.bodies.len()).collect();
    for joint in case.joints.iter().filter(|joint| joint.kind.carries()) {
        let Some(first) = joint.first else { continue };
        let (kept, merged) = (group[first], group[joint.second]);
        group.iter_mut().filter(|number| **number == merged).for_each(|number| *number = kept);
    }
    group
}
