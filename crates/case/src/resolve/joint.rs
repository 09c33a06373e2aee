//! Joints, and what they mean for the motion of the bodies that they carry.

use super::context::Context;
use crate::missing::{missing, required};
use crate::resolved::{Body, GROUND, Joint, JointKind, Motion};
use crate::rigid_body::Guide;
use glam::DVec3;
use input::names::nearest;
use input::problem::Problems;
use input::typed::Section;

/// Keys that only some joints have, for each kind.
const KEYS: [(&str, &[&str]); 5] = [
    ("hinge", &["axis", "friction_torque", "drive_torque"]),
    ("ball", &[]),
    ("slider", &["axis"]),
    ("spring", SPRING),
    ("cable", SPRING),
];
const SPRING: &[&str] = &["from", "stiffness", "damping", "length"];

/// Names of the bodies that joints carry.
pub(super) fn carried(sections: &[Section]) -> Vec<String> {
    let carries = |section: &&Section| {
        section.text("kind").is_some_and(|kind| ["hinge", "ball", "slider"].contains(&&*kind))
    };
    let second = |section: &Section| section.words("bodies").and_then(|names| names.into_iter().nth(1));
    sections.iter().filter(carries).filter_map(second).collect()
}

/// The joints between these bodies.
pub(super) fn joints(
    sections: &[Section],
    bodies: &[Body],
    context: &Context,
    problems: &mut Problems,
) -> Option<Vec<Joint>> {
    let all: Vec<_> = sections.iter().map(|section| joint(section, bodies, context, problems)).collect();
    all.into_iter().collect()
}

/// The bodies as the joints guide them.
pub(super) fn guide_all(
    joints: &[Joint],
    mut bodies: Vec<Body>,
    problems: &mut Problems,
) -> Option<Vec<Body>> {
    for joint in from_carrier_to_carried(joints, bodies.len(), problems)? {
        guide(joint, &mut bodies);
    }
    Some(bodies)
}

fn joint(section: &Section, bodies: &[Body], context: &Context, problems: &mut Problems) -> Option<Joint> {
    for key in ["kind", "bodies"].into_iter().filter(|key| !section.has(key)) {
        missing(section, key, problems);
    }
    let (kind, names) = (section.text("kind")?, section.words("bodies")?);
    let allowed = KEYS.iter().find(|(word, _)| *word == kind).map_or(&[][..], |(_, keys)| keys);
    let others = ["axis", "friction_torque", "drive_torque"].iter().chain(SPRING);
    for key in others.filter(|key| section.has(key) && !allowed.contains(key)) {
        let message = format!("`{key}` does not apply to kind = \"{kind}\"");
        problems.add(section.at(key), message, "remove it, or choose another kind of joint");
    }
    let [first, second] = connected(section, &names, bodies, problems)?;
    let Some(second) = second else {
        let message = "the ground can only be the first of the two bodies";
        let cure = format!("write  bodies = [\"{GROUND}\", \"{}\"]", names[0]);
        problems.add(section.at("bodies"), message, cure);
        return None;
    };
    let position = place(section, "at", context, problems)?.unwrap_or(bodies[second].position);
    let kind = match kind.as_str() {
        "hinge" => {
            let axle = bodies[second].attitude.of_axle() * DVec3::Y;
            let axis = axis(section, Some(axle), problems)?;
            let [friction_torque, drive_torque] =
                ["friction_torque", "drive_torque"].map(|key| section.number(key));
            JointKind::Hinge { axis, friction_torque: friction_torque?, drive_torque: drive_torque? }
        }
        "ball" => JointKind::Ball,
        "slider" => JointKind::Slider { axis: axis(section, None, problems)? },
        word => {
            let stiffness = required(section, "stiffness", problems);
            let from = match (place(section, "from", context, problems)?, first) {
                (Some(from), _) => from,
                (None, Some(first)) => bodies[first].position,
                (None, None) => {
                    missing(section, "from", problems);
                    return None;
                }
            };
            let length = section.number_or("length", from.distance(position))?;
            let (stiffness, damping) = (stiffness?, section.number("damping")?);
            JointKind::Spring { from, stiffness, damping, length, is_cable: word == "cable" }
        }
    };
    let name = section.path.trim_start_matches("joint.").to_owned();
    Some(Joint { name, first, second, position, kind })
}

/// The numbers of the two bodies; the ground has none.
fn connected(
    section: &Section,
    names: &[String],
    bodies: &[Body],
    problems: &mut Problems,
) -> Option<[Option<usize>; 2]> {
    let path = section.at("bodies");
    let mut number = |n: usize| {
        let name = names.get(n)?;
        if name == GROUND {
            return Some(None);
        }
        let found = bodies.iter().position(|body| body.name == *name);
        if found.is_none() {
            let known = bodies.iter().map(|body| &*body.name);
            let cure = nearest(name, known.clone()).map_or_else(
                || format!("the bodies are {}", known.collect::<Vec<_>>().join(", ")),
                |near| format!("did you mean \"{near}\"?"),
            );
            problems.add(format!("{path}[{n}]"), format!("there is no body \"{name}\""), cure);
        }
        found.map(Some)
    };
    let (first, second) = (number(0), number(1));
    let (first, second) = (first?, second?);
    if first == second {
        problems.add(path, "a joint connects two different bodies", "name the other one");
        return None;
    }
    Some([first, second])
}

/// A point: x, y and the height above the surface [m]; the inner `None` where it is not given.
#[allow(clippy::option_option)]
fn place(section: &Section, key: &str, context: &Context, problems: &mut Problems) -> Option<Option<DVec3>> {
    if !section.has(key) {
        return Some(None);
    }
    let Ok([x, y, height]) = <[f64; 3]>::try_from(section.list(key)?) else {
        let message = "a point has three coordinates: x, y and the height above the surface";
        problems.add(section.at(key), message, "write [\"0 m\", \"0 m\", \"0.3 m\"]");
        return None;
    };
    Some(Some(DVec3::new(x, y, context.surface + height)))
}

/// Direction of the axis.
fn axis(section: &Section, default: Option<DVec3>, problems: &mut Problems) -> Option<DVec3> {
    if !section.has("axis") {
        if default.is_none() {
            missing(section, "axis", problems);
        }
        return default;
    }
    let axis = DVec3::from_slice(&section.list("axis")?).try_normalize();
    if axis.is_none() {
        problems.add(section.at("axis"), "the axis has no direction", "write such as [0, 1, 0]");
    }
    axis
}

/// The joints in an order in which a body is carried before it carries another.
fn from_carrier_to_carried<'a>(
    joints: &'a [Joint],
    bodies: usize,
    problems: &mut Problems,
) -> Option<Vec<&'a Joint>> {
    let carrying: Vec<&Joint> = joints.iter().filter(|joint| joint.kind.carries()).collect();
    // The number of carriers above each body.
    let mut level = vec![0; bodies];
    for _ in 0..=bodies {
        let mut is_settled = true;
        for joint in &carrying {
            let above = joint.first.map_or(0, |first| level[first] + 1);
            if level[joint.second] < above {
                (level[joint.second], is_settled) = (above, false);
            }
        }
        if is_settled {
            let mut ordered: Vec<&Joint> = joints.iter().collect();
            ordered.sort_by_key(|joint| level[joint.second]);
            return Some(ordered);
        }
    }
    let deepest = carrying.iter().max_by_key(|joint| level[joint.second]);
    let path = deepest.map_or_else(|| "joint".to_owned(), |joint| format!("joint.{}.bodies", joint.name));
    let cure = "name the body first that is towed or pressed, and then what it carries";
    problems.add(path, "bodies carry each other in a ring", cure);
    None
}

/// Tells a body how the one before it in the joint makes it move.
fn guide(joint: &Joint, bodies: &mut [Body]) {
    let carrier = joint.first.map_or(Guide::GROUND, |first| bodies[first].guided());
    let heave = joint.first.map(|first| bodies[first].translation[2].clone());
    let body = &mut bodies[joint.second];
    if body.guide.is_some() {
        return;
    }
    let mut guide = carrier.clone();
    let arm = joint.position - body.position;
    match joint.kind {
        JointKind::Hinge { axis, .. } => {
            let is_across = axis.x == 0.0 && axis.z == 0.0;
            if !is_across {
                guide.rotation = [const { Motion::FREE }; 2];
            }
            if arm.reject_from(axis).length() > 0.0 {
                guide.translation[2] = Motion::FREE;
            }
        }
        JointKind::Ball => {
            guide.rotation = [const { Motion::FREE }; 2];
            if arm.length() > 0.0 {
                guide.translation[2] = Motion::FREE;
            }
        }
        JointKind::Slider { axis } => {
            for n in (0..3).filter(|n| axis[*n] != 0.0) {
                guide.translation[n] = Motion::FREE;
            }
        }
        JointKind::Spring { .. } => {
            let own = body.guided();
            guide = Guide {
                translation: std::array::from_fn(|n| {
                    let follows = own.translation[n].is_free() && carrier.translation[n] != Motion::Fixed;
                    let leads = if follows && n < 2 { &carrier } else { &own };
                    leads.translation[n].clone()
                }),
                bounds: own.bounds.or(carrier.bounds),
                ..own
            };
        }
    }
    keep_own_motions(&body.own_guide(), &mut guide);
    body.guide = Some(guide);
    // It is released with its carrier.
    if let (true, Some(Motion::Free { start: from, ramp: over, .. })) = (joint.kind.carries(), heave)
        && let Motion::Free { start, ramp, load: 0.0, .. } = &mut body.translation[2]
    {
        (*start, *ramp) = (from, over);
    }
}

/// What a body is not free to do is up to itself, not to its carrier.
fn keep_own_motions(own: &Guide, guide: &mut Guide) {
    for n in (0..3).filter(|n| !own.translation[*n].is_free()) {
        guide.translation[n] = own.translation[n].clone();
        if let Some(bounds) = own.bounds {
            guide.bounds.get_or_insert([[0.0; 2]; 3])[n] = bounds[n];
        }
    }
    for n in (0..2).filter(|n| !own.rotation[*n].is_free()) {
        guide.rotation[n] = own.rotation[n].clone();
    }
}
