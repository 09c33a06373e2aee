//! Surfaces of triangles: from the elements of a rigid body, and from a profile that turns about an axis.

use deck::Deck;
use deck::model::{Id, Surface};
use std::collections::{BTreeMap, HashMap};

/// A surface of triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Hull {
    /// Corners.
    pub(super) points: Vec<[f64; 3]>,
    /// Triangles, by their corners.
    pub(super) triangles: Vec<[usize; 3]>,
}

/// Faces of a solid by the places of its corners, outwards; nodes at the middles of edges come after these.
fn solid_faces(nodes: usize) -> &'static [&'static [usize]] {
    match nodes {
        8 | 20 => &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]],
        6 | 15 => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
        _ => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
    }
}

/// The surface of elements: of solids their outer faces, of others themselves.
pub(super) fn of_elements(deck: &Deck, ids: &[Id]) -> Result<Hull, String> {
    let mut faces: BTreeMap<Vec<Id>, (usize, Vec<Id>)> = BTreeMap::new();
    for id in ids {
        let element = deck.element(*id).ok_or_else(|| format!("there is no element {}", id.label))?;
        let nodes = &element.nodes;
        let own: Vec<Vec<Id>> = match element.kind.as_str() {
            kind if kind.starts_with("C3D") => {
                solid_faces(nodes.len()).iter().map(|face| face.iter().map(|n| nodes[*n]).collect()).collect()
            }
            kind if nodes.len() == 3 || nodes.len() == 4 && !kind.starts_with("EC3D") => vec![nodes.clone()],
            kind => return Err(format!("element {} of type {kind} is no face of a rigid body", id.label)),
        };
        for mut face in own {
            face.dedup();
            let mut key = face.clone();
            key.sort_unstable();
            faces.entry(key).and_modify(|(count, _)| *count += 1).or_insert((1, face));
        }
    }
    let mut hull = Hull::default();
    let mut numbers: HashMap<Id, usize> = HashMap::new();
    for (_, face) in faces.into_values().filter(|(count, _)| *count == 1) {
        let mut corners = Vec::with_capacity(4);
        for id in face {
            let point = deck.node(id).ok_or_else(|| format!("there is no node {}", id.label))?;
            corners.push(*numbers.entry(id).or_insert_with(|| {
                hull.points.push(point);
                hull.points.len() - 1
            }));
        }
        (1..corners.len().saturating_sub(1))
            .for_each(|n| hull.triangles.push([corners[0], corners[n], corners[n + 1]]));
    }
    hull.welded()
}

impl Hull {
    /// Nodes in one place made one: tied or merged parts of a shell.
    fn welded(self) -> Result<Self, String> {
        if self.triangles.is_empty() {
            return Err("it has no faces".to_owned());
        }
        let size = self.size();
        let key = |point: &[f64; 3]| point.map(|x| (x / (1e-7 * size)).round() as i64);
        let mut places: HashMap<[i64; 3], usize> = HashMap::new();
        let mut points = Vec::new();
        let new: Vec<usize> = (self.points.iter())
            .map(|point| {
                *places.entry(key(point)).or_insert_with(|| {
                    points.push(*point);
                    points.len() - 1
                })
            })
            .collect();
        let triangles = self.triangles.iter().map(|corners| corners.map(|n| new[n]));
        let triangles = triangles.filter(|[a, b, c]| a != b && b != c && c != a).collect();
        Ok(Self { points, triangles })
    }

    /// Low and high along each axis.
    pub(super) fn bounds(&self) -> [[f64; 2]; 3] {
        [0, 1, 2].map(|axis| {
            let along = self.points.iter().map(|point| point[axis]);
            [along.clone().fold(f64::INFINITY, f64::min), along.fold(f64::NEG_INFINITY, f64::max)]
        })
    }

    /// Its largest extent.
    pub(super) fn size(&self) -> f64 {
        self.bounds().iter().map(|[low, high]| high - low).fold(0.0, f64::max)
    }

    /// Six times the volume that a triangle encloses with the origin.
    pub(super) fn sixfold(&self, [a, b, c]: [usize; 3]) -> f64 {
        let [a, b, c] = [a, b, c].map(|n| self.points[n]);
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    }

    /// The volume inside a closed surface.
    pub(super) fn volume(&self) -> f64 {
        self.triangles.iter().map(|triangle| self.sixfold(*triangle)).sum::<f64>() / 6.0
    }
}

/// Pieces of a surface of revolution around its axis.
const AROUND: usize = 72;

/// A profile turned about its axis, its ends closed by flat faces.
pub(super) fn of_revolution(surface: &Surface) -> Option<Hull> {
    let Surface::Revolution { origin, axis, profile } = surface else { return None };
    let helper = if axis[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let first = cross(*axis, helper);
    let length = first.iter().map(|x| x * x).sum::<f64>().sqrt();
    let first = first.map(|x| x / length);
    let second = cross(*axis, first);
    let at = |radius: f64, height: f64, n: usize| {
        let (sin, cos) = (std::f64::consts::TAU * n as f64 / AROUND as f64).sin_cos();
        [0, 1, 2].map(|k| origin[k] + axis[k] * height + radius * (first[k] * cos + second[k] * sin))
    };
    let mut hull = Hull::default();
    let mut rings: Vec<Vec<usize>> = Vec::new();
    for [radius, height] in closed_profile(profile) {
        let start = hull.points.len();
        let count = if radius == 0.0 { 1 } else { AROUND };
        hull.points.extend((0..count).map(|n| at(radius, height, n)));
        rings.push((0..AROUND).map(|n| start + n % count).collect());
    }
    for pair in rings.windows(2) {
        for n in 0..AROUND {
            let next = (n + 1) % AROUND;
            let (a, b, c, d) = (pair[0][n], pair[0][next], pair[1][next], pair[1][n]);
            let both = [[a, b, c], [a, c, d]];
            hull.triangles.extend(both.into_iter().filter(|[p, q, r]| p != q && q != r && r != p));
        }
    }
    Some(hull)
}

/// A profile that begins and ends on its axis, without points twice.
pub(super) fn closed_profile(profile: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut points = profile.to_vec();
    if let (Some(first), Some(last)) = (profile.first(), profile.last()) {
        if first[0] > 0.0 {
            points.insert(0, [0.0, first[1]]);
        }
        if last[0] > 0.0 {
            points.push([0.0, last[1]]);
        }
    }
    points.dedup();
    points
}
