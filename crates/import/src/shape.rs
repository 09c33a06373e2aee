//! Whether a surface is one of the shapes that a case knows: block, cylinder, disc, cone, sphere.

use crate::case_text::quantity;
use crate::hull::{Hull, closed_profile};
use std::f64::consts::PI;

/// A shape of a case: its keys, where its middle is, and what was taken for it.
pub(super) struct Native {
    /// Keys and values.
    pub(super) keys: Vec<(&'static str, String)>,
    /// Its reference point [m].
    pub(super) centre: [f64; 3],
    /// What differs.
    pub(super) differs: Option<String>,
}

/// A profile in radius and height [m] along an axis of the case through a point.
pub(super) struct Profile {
    pub(super) origin: [f64; 3],
    /// The axis, and whether heights count in its sense.
    pub(super) axis: (usize, bool),
    pub(super) points: Vec<[f64; 2]>,
}

fn metres(value: f64) -> String {
    quantity(value, "m")
}

/// The shape of a profile.
pub(super) fn of_profile(profile: &Profile, in_plane_strain: bool) -> Option<Native> {
    let (axis, same) = profile.axis;
    let mut points = closed_profile(&profile.points);
    let is_open = points.len() != profile.points.len();
    points.iter_mut().for_each(|point| point[1] = if same { point[1] } else { -point[1] });
    if points.first()?[1] > points.last()?[1] {
        points.reverse();
    }
    let radius = points.iter().map(|point| point[0]).fold(0.0, f64::max);
    let (low, high) = (points.first()?[1], points.last()?[1]);
    let mut centre = profile.origin;
    centre[axis] += 0.5 * (low + high);
    let same = |a: f64, b: f64| (a - b).abs() <= 1e-6 * radius;
    let differs = is_open.then(|| "its open ends are closed by flat faces".to_owned());
    let keys = match points[..] {
        [_, [r1, h1], [r2, h2], _] if same(h1, low) && same(h2, high) && same(r1, r2) => {
            cylinder(axis, 2.0 * r1, high - low, in_plane_strain)?
        }
        [[_, tip], [r1, h1], [r2, h2], [_, top]]
            if axis == 2 && same(r1, r2) && same(h2, top) && h1 > tip =>
        {
            cone(2.0 * r1, h1 - tip, top - tip)
        }
        [[_, tip], [r1, h1], [_, top]] if axis == 2 && same(h1, top) => cone(2.0 * r1, h1 - tip, top - tip),
        _ => {
            let middle = 0.5 * (low + high);
            let is_round = points.len() > 8 && same(high - low, 2.0 * radius);
            let all = points.iter().all(|[r, h]| same(r.hypot(h - middle), 0.5 * (high - low)));
            if !(is_round && all) {
                return None;
            }
            vec![("shape", "\"sphere\"".to_owned()), ("diameter", metres(high - low))]
        }
    };
    Some(Native { keys, centre, differs })
}

fn cone(diameter: f64, tip: f64, length: f64) -> Vec<(&'static str, String)> {
    let angle = 2.0 * (0.5 * diameter / tip).atan().to_degrees();
    vec![
        ("shape", "\"cone\"".to_owned()),
        ("diameter", metres(diameter)),
        ("cone_angle", quantity(angle, "deg")),
        ("length", metres(length)),
    ]
}

/// A cylinder, a disc where it is shorter than wide along y.
fn cylinder(
    axis: usize,
    diameter: f64,
    length: f64,
    in_plane_strain: bool,
) -> Option<Vec<(&'static str, String)>> {
    let mut keys = vec![("diameter", metres(diameter))];
    if axis == 1 && length < diameter && !in_plane_strain {
        keys.insert(0, ("shape", "\"disc\"".to_owned()));
        keys.push(("thickness", metres(length)));
        return Some(keys);
    }
    keys.insert(0, ("shape", "\"cylinder\"".to_owned()));
    keys.push(("axis", format!("\"{}\"", ["x", "y", "z"][axis])));
    match (in_plane_strain, axis) {
        (false, _) => keys.push(("length", metres(length))),
        (true, 1) => {}
        (true, _) => return None,
    }
    Some(keys)
}

/// The shape of a closed surface [m]: a block along the axes, or a cylinder along one.
pub(super) fn of_hull(hull: &Hull, in_plane_strain: bool) -> Option<Native> {
    let bounds = hull.bounds();
    let size = bounds.map(|[low, high]| high - low);
    let centre = bounds.map(|[low, high]| 0.5 * (low + high));
    let box_volume = size.iter().product::<f64>();
    if (hull.volume() / box_volume - 1.0).abs() < 1e-6 {
        let edges: Vec<String> =
            if in_plane_strain { vec![metres(size[0]), metres(size[2])] } else { size.map(metres).to_vec() };
        let keys = vec![("shape", "\"block\"".to_owned()), ("size", format!("[{}]", edges.join(", ")))];
        return Some(Native { keys, centre, differs: None });
    }
    let axis = (0..3).find(|axis| is_round(hull, centre, size, *axis))?;
    let diameter = size[(axis + 1) % 3];
    let exact = PI * (0.5 * diameter).powi(2) * size[axis];
    let off = 100.0 * (1.0 - hull.volume() / exact);
    Some(Native {
        keys: cylinder(axis, diameter, size[axis], in_plane_strain)?,
        centre,
        differs: Some(format!("its flat faces are taken for the circle around them, {off:.1} % more volume")),
    })
}

fn is_round(hull: &Hull, centre: [f64; 3], size: [f64; 3], axis: usize) -> bool {
    let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
    let radius = 0.5 * size[b];
    let at_end = |p: &[f64; 3]| ((p[axis] - centre[axis]).abs() - 0.5 * size[axis]).abs() < 1e-6 * size[axis];
    let far = |p: &[f64; 3]| (p[b] - centre[b]).hypot(p[c] - centre[c]) / radius;
    let ratio = hull.volume() / (PI * radius * radius * size[axis]);
    (size[b] / size[c] - 1.0).abs() < 0.01
        && hull.points.iter().all(|p| far(p) < 1.001 && (at_end(p) || far(p) > 0.99))
        && (0.97..=1.001).contains(&ratio)
}
