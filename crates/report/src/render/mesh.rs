//! The triangles of a time: soil surface, the sides of its block, bodies.

use crate::pictures::Tone;
use crate::plots::{ColourMap, Rgb};
use crate::view::{RecordedBody, Recording};
use glam::{DMat3, DVec3};

/// Dry sand; wet sand where it is cut.
const SAND: Tone = [[222, 199, 158], [186, 160, 118]];
const CUT: [Tone; 2] = [[[176, 143, 103], [120, 95, 66]], [[137, 107, 74], [84, 65, 44]]];
/// Steel. Quarters of two tones show how a body turns.
const STEEL: [Tone; 2] = [[[188, 198, 210], [176, 186, 198]], [[142, 153, 168], [130, 141, 156]]];
/// Faces that meet at less than this angle are one smooth surface: cosine of 35°.
const SMOOTH: f64 = 0.82;

/// A vertex of a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    /// Position of the vertex [m].
    pub(super) place: DVec3,
    /// The outward normal, of any length.
    pub(super) normal: DVec3,
    /// Colour of the vertex in full light.
    pub(super) tone: Tone,
}

/// Triangles; those that touch a vertex without a place are left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Mesh {
    pub(super) vertices: Vec<Vertex>,
    pub(super) triangles: Vec<[usize; 3]>,
}

/// Colours of heights.
#[derive(Clone, Copy, Debug)]
pub(super) struct HeightColours {
    map: ColourMap,
    /// Whether the soil is heaped on a floor.
    heaped: bool,
    /// The largest height above or below the level at any time [m].
    pub(super) most: f64,
}

impl HeightColours {
    pub(super) fn of(recording: &Recording) -> Self {
        let all = recording.heights.iter().flatten();
        let rises = all.map(|z| (z - recording.level).abs()).filter(|rise| rise.is_finite());
        let map = if recording.heaped { ColourMap::Sequential } else { ColourMap::Diverging };
        Self { map, heaped: recording.heaped, most: rises.fold(1e-6, f64::max) }
    }

    /// The lowest value of the scale, above the level [m].
    pub(super) fn low(&self) -> f64 {
        if self.heaped { 0.0 } else { -self.most }
    }

    /// The colour of a height above the level [m].
    pub(super) fn tone(&self, rise: f64) -> Tone {
        let part = (rise - self.low()) / (self.most - self.low());
        [self.map.at(part), self.map.for_dark().at(part)]
    }
}

impl Mesh {
    /// The scene at a recorded time; the block of soil ends at the height `base` [m]. Without `colours` the
    /// soil looks as soil does.
    pub(super) fn of(
        (recording, base): (&Recording, f64),
        frame: usize,
        colours: Option<&HeightColours>,
    ) -> Self {
        let mut mesh = Self::default();
        mesh.push_surface(recording, &recording.heights[frame], colours);
        mesh.push_sides(recording, &recording.heights[frame], base);
        for body in &recording.bodies {
            mesh.push_body(body, &body.poses[frame]);
        }
        mesh
    }

    fn push_surface(&mut self, recording: &Recording, heights: &[f64], colours: Option<&HeightColours>) {
        let [x, y] = &recording.places;
        let height = |i: usize, j: usize| heights[j * x.len() + i];
        for j in 0..y.len() {
            for i in 0..x.len() {
                let z = height(i, j);
                let (west, east) = (i.saturating_sub(1), (i + 1).min(x.len() - 1));
                let (south, north) = (j.saturating_sub(1), (j + 1).min(y.len() - 1));
                let slope = |rise: f64, run: f64| if (rise / run).is_finite() { rise / run } else { 0.0 };
                let normal = DVec3::new(
                    -slope(height(east, j) - height(west, j), x[east] - x[west]),
                    -slope(height(i, north) - height(i, south), y[north] - y[south]),
                    1.0,
                );
                let tone = colours.map_or(SAND, |colours| colours.tone(z - recording.level));
                self.vertices.push(Vertex { place: DVec3::new(x[i], y[j], z), normal, tone });
            }
        }
        for j in 1..y.len() {
            for i in 1..x.len() {
                let [a, b] = [(j - 1) * x.len() + i - 1, j * x.len() + i - 1];
                self.triangles.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
            }
        }
    }

    /// The sides of the block, from the surface down.
    fn push_sides(&mut self, recording: &Recording, heights: &[f64], base: f64) {
        let [columns, rows] = [0, 1].map(|axis| recording.places[axis].len());
        let at = |i: usize, j: usize| j * columns + i;
        let sides: [(Vec<usize>, DVec3); 4] = [
            ((0..columns).map(|i| at(i, 0)).collect(), DVec3::NEG_Y),
            ((0..columns).map(|i| at(i, rows - 1)).collect(), DVec3::Y),
            ((0..rows).map(|j| at(0, j)).collect(), DVec3::NEG_X),
            ((0..rows).map(|j| at(columns - 1, j)).collect(), DVec3::X),
        ];
        for (rim, normal) in sides {
            let first = self.vertices.len();
            for n in &rim {
                let place = DVec3::new(
                    recording.places[0][n % columns],
                    recording.places[1][n / columns],
                    heights[*n],
                );
                self.vertices.push(Vertex { place, normal, tone: CUT[0] });
                let foot = if place.z.is_nan() { f64::NAN } else { base };
                self.vertices.push(Vertex { place: place.with_z(foot), normal, tone: CUT[1] });
            }
            for n in 1..rim.len() {
                let [a, b] = [first + 2 * n - 2, first + 2 * n];
                self.triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
            }
        }
    }

    fn push_body(&mut self, body: &RecordedBody, pose: &[f64; 12]) {
        let (rotation, middle) = placed(pose);
        let normals = smooth_normals(&body.points, &body.triangles);
        for (triangle, normals) in body.triangles.iter().zip(normals) {
            let points = triangle.map(|n| body.points[n]);
            let centre = points.iter().sum::<DVec3>();
            let tone = STEEL[usize::from(body.turns() && centre.x * centre.z > 0.0)];
            let first = self.vertices.len();
            for (point, normal) in points.into_iter().zip(normals) {
                self.vertices.push(Vertex {
                    place: middle + rotation * point,
                    normal: rotation * normal,
                    tone,
                });
            }
            self.triangles.push([first, first + 1, first + 2]);
        }
    }
}

/// Rotation and middle of a body.
pub(super) fn placed(pose: &[f64; 12]) -> (DMat3, DVec3) {
    let rows: [f64; 9] = std::array::from_fn(|n| pose[n]);
    (DMat3::from_cols_array(&rows).transpose(), DVec3::from_slice(&pose[9..]))
}

/// Where the block of soil ends below [m]; a heap stands on its floor.
pub(super) fn base(recording: &Recording) -> f64 {
    let heights = || recording.heights.iter().flatten().copied().filter(|z| z.is_finite());
    let low = heights().fold(recording.level, f64::min);
    if recording.heaped {
        return low;
    }
    let high = heights().fold(recording.level, f64::max);
    let extents =
        recording.places.iter().map(|axis| axis.last().unwrap_or(&0.0) - axis.first().unwrap_or(&0.0));
    low - 0.04 * extents.fold(0.0, f64::max) - 0.15 * (high - low)
}

/// For each vertex of each triangle the mean normal of the faces that meet there smoothly.
fn smooth_normals(points: &[DVec3], triangles: &[[usize; 3]]) -> Vec<[DVec3; 3]> {
    // As long as twice the area of the face: large faces count more.
    let faces: Vec<DVec3> =
        triangles.iter().map(|[a, b, c]| (points[*b] - points[*a]).cross(points[*c] - points[*a])).collect();
    let mut meeting = vec![Vec::new(); points.len()];
    for (face, triangle) in triangles.iter().enumerate() {
        triangle.iter().for_each(|n| meeting[*n].push(face));
    }
    let smooth = |own: DVec3, point: usize| {
        let near = |face: &&usize| faces[**face].normalize_or_zero().dot(own.normalize_or_zero()) > SMOOTH;
        meeting[point].iter().filter(near).map(|face| faces[*face]).sum::<DVec3>() + 1e-9 * own
    };
    triangles.iter().zip(&faces).map(|(triangle, own)| triangle.map(|n| smooth(*own, n))).collect()
}

/// A tone in some light, 0 to 1 and a little beyond.
pub(super) fn shaded(colour: Rgb, light: f64) -> Rgb {
    colour.map(|channel| (f64::from(channel) * light).clamp(0.0, 255.0) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_faces_share_normals_and_edges_stay_sharp() {
        // Two faces that meet at a small angle, and one across.
        let points =
            [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.1], [0., 0., -1.]].map(DVec3::from_array);
        let normals = smooth_normals(&points, &[[0, 1, 2], [1, 3, 2], [0, 2, 4]]);
        assert!(normals[0][1].normalize().abs_diff_eq(normals[1][0].normalize(), 1e-8));
        assert!(normals[0][0].normalize().dot(DVec3::Z) > 0.999);
        assert!(normals[2][0].normalize().dot(DVec3::X).abs() > 0.999);
    }
}
