//! A surface as a file has it, and where in the file its triangles stand.

use super::polygon::Divided;
use super::unit::Stated;
use geometry::Mesh;
use glam::DVec3;

/// The content of a file.
#[derive(Debug, Default)]
pub(super) struct Surface {
    /// Coordinates in the unit of the file.
    pub(super) mesh: Mesh,
    /// Line or number of each triangle in the file.
    origin: Vec<u32>,
    /// What the numbers of the triangles count: `line`, `facet` or `face`.
    pub(super) counted: &'static str,
    /// The unit that the file states.
    pub(super) unit: Option<Stated>,
    /// Faces that are not plane, how far at most [unit of the file], and the number of the first.
    pub(super) uneven: Option<(usize, f64, u32)>,
}

impl Surface {
    pub(super) fn counting(counted: &'static str) -> Self {
        Self { counted, ..Self::default() }
    }

    /// Adds a face from a line or with a number.
    pub(super) fn add(&mut self, face: Divided, number: u64) {
        let number = u32::try_from(number).unwrap_or(u32::MAX);
        self.origin.resize(self.origin.len() + face.triangles.len(), number);
        self.mesh.triangles.extend(face.triangles);
        if let Some(off) = face.off_plane {
            let (count, most, first) = self.uneven.unwrap_or((0, 0.0, number));
            self.uneven = Some((count + 1, most.max(off), first));
        }
    }

    /// Adds the last three points as a triangle.
    pub(super) fn add_last_three(&mut self, number: u64) {
        let next = self.mesh.points.len() as u32;
        self.add(Divided { triangles: vec![[next - 3, next - 2, next - 1]], off_plane: None }, number);
    }

    /// Lines or numbers of the first triangles at a place [unit of the file], in words.
    pub(super) fn named(&self, place: DVec3) -> String {
        const MOST: usize = 3;
        let points = &self.mesh.points;
        let size = points.iter().map(|x| x.abs().max_element()).fold(0.0, f64::max);
        let is_there = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|n| points[n as usize]);
            a.min(b).min(c).cmple(place + 1e-5 * size).all()
                && a.max(b).max(c).cmpge(place - 1e-5 * size).all()
                && distance(place, [a, b, c]) <= 1e-5 * size
        };
        let there = self.mesh.triangles.iter().zip(&self.origin).filter(|(corners, _)| is_there(corners));
        let mut numbers: Vec<u32> = there.map(|(_, number)| *number).take(2 * MOST).collect();
        numbers.dedup();
        numbers.truncate(MOST);
        let list = numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        let plural = if numbers.len() > 1 { "s" } else { "" };
        if list.is_empty() { String::new() } else { format!(" ({}{plural} {list})", self.counted) }
    }
}

/// Distance of a point from a triangle's plane or, beside it, from its edges.
fn distance(x: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let edges = [[a, b], [b, c], [c, a]];
    let is_inside = edges.iter().all(|[from, to]| normal.cross(*to - *from).dot(x - *from) >= 0.0);
    if is_inside && normal != DVec3::ZERO {
        return normal.dot(x - a).abs();
    }
    let to_edge = |[from, to]: [DVec3; 2]| {
        let along = to - from;
        let part = ((x - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        x.distance(from + if part.is_nan() { DVec3::ZERO } else { part * along })
    };
    edges.map(to_edge).into_iter().fold(f64::INFINITY, f64::min)
}
