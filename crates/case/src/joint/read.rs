//! Joints, and what they mean for the motion of the bodies that they carry.

use super::keys::{FIELDS, KEYS};
use super::{GROUND, Joint, JointKind};
use crate::body::{Body, Guide};
use crate::key::{missing, required};
use glam::DVec3;
use input::key::read;
use input::names::nearest;
use input::problem::Problems;
use input::typed::Section;
use mechanics::Motion;

/// Keys that only some joints have, for each kind.
const OWN: [(&str, &[&str]); 6] = [
    ("hinge", &["axis", "friction_torque", "drive_torque"]),
    ("ball", &[]),
    ("slider", &["axis"]),
    ("spring", OF_SPRING),
    ("cable", OF_SPRING),
    ("contact", OF_CONTACT),
];
const OF_SPRING: &[&str] = &["from", "stiffness", "damping", "length"];
const OF_CONTACT: &[&str] = &["friction", "restitution"];

/// Names of the bodies that joints carry.
pub(crate) fn carried(sections: &[Section]) -> Vec<String> {
    let carries = |section: &&Section| {
        section.text("kind").is_some_and(|kind| ["hinge", "ball", "slider"].contains(&&*kind))
    };
    let second = |section: &Section| section.words("bodies").and_then(|names| names.into_iter().nth(1));
    sections.iter().filter(carries).filter_map(second).collect()
}

/// The joints between the bodies that move for themselves, with their numbers among these; `roots` says which
/// body moves for each. Reports joints that carry another.
pub(crate) fn between_wholes(
    joints: Vec<Joint>,
    bodies: &[Body],
    roots: &[usize],
    problems: &mut Problems,
) -> Vec<Joint> {
    for joint in joints.iter().filter(|joint| roots[joint.second] != joint.second) {
        let [name, whole] = [joint.second, roots[joint.second]].map(|n| &bodies[n].name);
        let message = format!("`{name}` is welded to `{whole}`: what is carried is the whole");
        let cure = format!("name `{whole}` instead, and where the joint is by `at`");
        problems.add(format!("{}.bodies", joint.path()), message, cure);
    }
    let number = |n: usize| (0..roots[n]).filter(|m| roots[*m] == *m).count();
    let renumbered =
        |joint: Joint| Joint { first: joint.first.map(number), second: number(joint.second), ..joint };
    joints.into_iter().map(renumbered).collect()
}

/// The bodies as the joints guide them.
pub(crate) fn guide_all(
    joints: &[Joint],
    mut bodies: Vec<Body>,
    problems: &mut Problems,
) -> Option<Vec<Body>> {
    for joint in from_carrier_to_carried(joints, bodies.len(), problems)? {
        guide(joint, &mut bodies);
    }
    Some(bodies)
}

/// The joint of a section between these bodies, over ground with its surface at a height [m].
pub(crate) fn typed(
    section: &Section,
    bodies: &[Body],
    surface: f64,
    problems: &mut Problems,
) -> Option<Joint> {
    ["kind", "bodies"].iter().for_each(|key| missing(KEYS, section, key, problems));
    let (kind, names) = (section.text("kind")?, section.words("bodies")?);
    let allowed = OWN.iter().find(|(word, _)| *word == kind).map_or(&[][..], |(_, keys)| keys);
    let others = ["axis", "friction_torque", "drive_torque"].iter().chain(OF_SPRING).chain(OF_CONTACT);
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
    let position = place(section, "at", surface, problems)?.unwrap_or(bodies[second].position);
    let kind = match kind.as_str() {
        "hinge" => {
            let axle = bodies[second].attitude.of_axle() * DVec3::Y;
            let axis = axis(section, Some(axle), problems)?;
            JointKind::Hinge { axis, friction_torque: 0.0, drive_torque: 0.0 }
        }
        "ball" => JointKind::Ball,
        "contact" => {
            let friction = required(KEYS, section, "friction", problems);
            if first.is_none() {
                let message = format!("\"{GROUND}\" has no surface that another body could touch");
                problems.add(
                    section.at("bodies"),
                    message,
                    "name a body that does not move, such as a stone",
                );
                return None;
            }
            JointKind::Contact { friction: friction?, restitution: 0.0 }
        }
        "slider" => JointKind::Slider { axis: axis(section, None, problems)? },
        word => {
            let stiffness = required(KEYS, section, "stiffness", problems);
            let from = match (place(section, "from", surface, problems)?, first) {
                (Some(from), _) => from,
                (None, Some(first)) => bodies[first].position,
                (None, None) => {
                    missing(KEYS, section, "from", problems);
                    return None;
                }
            };
            let (stiffness, length, is_cable) = (stiffness?, from.distance(position), word == "cable");
            JointKind::Spring { from, stiffness, damping: 0.0, length, is_cable }
        }
    };
    let name = section.path.trim_start_matches("joint.").to_owned();
    read(FIELDS, Joint { name, first, second, position, kind }, section, problems)
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
fn place(section: &Section, key: &str, surface: f64, problems: &mut Problems) -> Option<Option<DVec3>> {
    if !section.has(key) {
        return Some(None);
    }
    let Ok([x, y, height]) = <[f64; 3]>::try_from(section.list(key)?) else {
        let message = "a point has three coordinates: x, y and the height above the surface";
        problems.add(section.at(key), message, "write [\"0 m\", \"0 m\", \"0.3 m\"]");
        return None;
    };
    Some(Some(DVec3::new(x, y, surface + height)))
}

/// Direction of the axis.
fn axis(section: &Section, default: Option<DVec3>, problems: &mut Problems) -> Option<DVec3> {
    if !section.has("axis") {
        if default.is_none() {
            missing(KEYS, section, "axis", problems);
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
    let path = deepest.map_or_else(|| "joint".to_owned(), |joint| format!("{}.bodies", joint.path()));
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
        JointKind::Contact { .. } => return,
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
