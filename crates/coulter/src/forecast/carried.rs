//! The bodies of a case that touch the soil, each as if it moved by itself: what joints, welds and frames
//! mean for the closed forms.

use case::resolved::{Body, Case, Motion};

/// The bodies with a surface, what is welded together one by one. One that joints guide moves as its carrier
/// does, and the weight of all that is connected is shared equally among the surfaces that bear it.
pub(super) fn touching(case: &Case, remarks: &mut Vec<String>) -> Vec<Body> {
    let groups = groups(case);
    let mut said = Vec::new();
    let mut all = Vec::new();
    for (n, body) in case.touching() {
        if !body.is_connected() {
            all.push(body.clone());
            continue;
        }
        let members: Vec<&Body> = case
            .bodies
            .iter()
            .zip(&groups)
            .filter(|(_, group)| **group == groups[n])
            .map(|(b, _)| b)
            .collect();
        let bearing = members.iter().map(|member| member.surfaces().len()).sum::<usize>() as f64;
        let mut moved = body.clone();
        let guide = body.guided();
        let is_free = guide.translation[2].is_free();
        (moved.guide, moved.translation) = (None, guide.translation);
        moved.rotation[..2].clone_from_slice(&guide.rotation);
        if is_free {
            moved.mass = members.iter().map(|member| member.whole_mass()).sum::<f64>() / bearing;
            moved.translation[2] =
                Motion::loaded(members.iter().map(|member| load(member)).sum::<f64>() / bearing);
        }
        if bearing > 1.0 && is_free && !said.contains(&groups[n]) {
            said.push(groups[n]);
            let names: Vec<String> = members.iter().map(|member| format!("`{}`", member.name)).collect();
            remarks.push(format!(
                "{}: the weight of all is shared equally among the {bearing} surfaces that bear it",
                names.join(", ")
            ));
        }
        all.extend(moved.surfaces());
    }
    all
}

/// Load on a free heave [N], upwards.
fn load(body: &Body) -> f64 {
    match body.translation[2] {
        Motion::Free { load, .. } => load,
        _ => 0.0,
    }
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
