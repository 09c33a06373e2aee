//! Surfaces and the files that hold them.

use std::f64::consts::TAU;
use std::fmt::Write;

/// Points and triangles.
#[derive(Clone)]
pub(crate) struct Surface {
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Surface {
    pub(crate) fn volume(&self) -> f64 {
        let one = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|n| self.points[n as usize]);
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6.0
        };
        self.triangles.iter().map(one).sum()
    }

    pub(crate) fn inverted(&self) -> Self {
        let triangles = self.triangles.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
        Self { triangles, points: self.points.clone() }
    }

    pub(crate) fn moved(&self, by: [f64; 3]) -> Self {
        let points = self.points.iter().map(|x| [0, 1, 2].map(|n| x[n] + by[n])).collect();
        Self { points, triangles: self.triangles.clone() }
    }

    /// Every triangle with points of its own.
    pub(crate) fn as_soup(&self) -> Self {
        let points = self.triangles.iter().flatten().map(|n| self.points[*n as usize]).collect();
        let triangles = (0..self.triangles.len() as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        Self { points, triangles }
    }
}

pub(crate) fn union(one: &Surface, other: &Surface) -> Surface {
    let first = one.points.len() as u32;
    let mut both = one.clone();
    both.points.extend(&other.points);
    both.triangles.extend(other.triangles.iter().map(|t| t.map(|n| n + first)));
    both
}

/// A disc about y.
pub(crate) fn disc(segments: u32, diameter: f64, thickness: f64) -> Surface {
    let mut points = vec![[0.0, -0.5 * thickness, 0.0], [0.0, 0.5 * thickness, 0.0]];
    let mut triangles = Vec::new();
    for n in 0..segments {
        let (sin, cos) = (TAU * f64::from(n) / f64::from(segments)).sin_cos();
        points.extend([-0.5, 0.5].map(|y| [0.5 * diameter * sin, y * thickness, 0.5 * diameter * cos]));
        let (a, b) = (2 + 2 * n, 2 + 2 * ((n + 1) % segments));
        triangles.extend([[0, b, a], [1, a + 1, b + 1], [a, b, a + 1], [b, b + 1, a + 1]]);
    }
    Surface { points, triangles }
}

pub(crate) fn cube(edge: f64) -> Surface {
    let half = 0.5 * edge;
    let corner = |n: u32| [n & 1, n >> 1 & 1, n >> 2].map(|bit| if bit == 1 { half } else { -half });
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    Surface { points: (0..8).map(corner).collect(), triangles }
}

/// A cube whose upper face is drawn in to a point at a height above its lower face.
pub(crate) fn bowl(edge: f64, height: f64) -> Surface {
    let mut surface = cube(edge);
    let low = -0.5 * edge;
    let is_upper = |t: &[u32; 3]| t.iter().all(|n| *n >= 4);
    surface.triangles.retain(|t| !is_upper(t));
    surface.points.push([0.01 * edge, 0.02 * edge, low + height]);
    surface.triangles.extend([[4, 5, 8], [5, 7, 8], [7, 6, 8], [6, 4, 8]]);
    surface
}

pub(crate) fn klein_bottle(size: f64) -> Surface {
    let point = |i: u32, j: u32| {
        let (i, j) = if i == 6 { (0, (6 - j % 6) % 6) } else { (i, j % 6) };
        6 * i + j
    };
    let mut triangles = Vec::new();
    for i in 0..6 {
        for j in 0..6 {
            let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let at = |n: u32| {
        let (u, v) = (f64::from(n / 6), f64::from(n % 6) * TAU / 6.0);
        [(2.0 + v.cos()) * u.cos(), (2.0 + v.cos()) * u.sin(), v.sin()].map(|x| size * x)
    };
    Surface { points: (0..36).map(at).collect(), triangles }
}

/// Name of a file in an encoding, and how it is written.
type Encoding = (&'static str, fn(&Surface) -> Vec<u8>);

pub(crate) const ENCODINGS: [Encoding; 6] = [
    ("binary.stl", binary_stl),
    ("text.stl", |surface| text_stl(surface).into_bytes()),
    ("faces.obj", |surface| obj(surface).into_bytes()),
    ("text.ply", |surface| text_ply(surface).into_bytes()),
    ("low.ply", |surface| binary_ply(surface, false)),
    ("high.ply", |surface| binary_ply(surface, true)),
];

pub(crate) fn binary_stl(surface: &Surface) -> Vec<u8> {
    let mut bytes = vec![b'-'; 80];
    bytes.extend((surface.triangles.len() as u32).to_le_bytes());
    for triangle in &surface.triangles {
        bytes.extend([0; 12]);
        let corners = triangle.iter().flat_map(|n| surface.points[*n as usize]);
        bytes.extend(corners.flat_map(|x| (x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

pub(crate) fn text_stl(surface: &Surface) -> String {
    let mut text = "solid part\n".to_owned();
    for triangle in &surface.triangles {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for [x, y, z] in triangle.map(|n| surface.points[n as usize]) {
            writeln!(text, "      vertex {x:e} {y:e} {z:e}").unwrap();
        }
        text += "    endloop\n  endfacet\n";
    }
    text + "endsolid part\n"
}

fn obj(surface: &Surface) -> String {
    let mut text = "# part\n".to_owned();
    for [x, y, z] in &surface.points {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for [a, b, c] in surface.triangles.iter().map(|t| t.map(|n| n + 1)) {
        writeln!(text, "f {a}/1 {b}/1/1 {c}").unwrap();
    }
    text
}

fn ply_header(surface: &Surface, format: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment part\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         property uchar red\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        surface.points.len(),
        surface.triangles.len()
    )
}

fn text_ply(surface: &Surface) -> String {
    let mut text = ply_header(surface, "ascii");
    for [x, y, z] in &surface.points {
        writeln!(text, "{x} {y} {z} 255").unwrap();
    }
    for [a, b, c] in &surface.triangles {
        writeln!(text, "3 {a} {b} {c}").unwrap();
    }
    text
}

fn binary_ply(surface: &Surface, is_high_first: bool) -> Vec<u8> {
    let format = if is_high_first { "binary_big_endian" } else { "binary_little_endian" };
    let mut bytes = ply_header(surface, format).into_bytes();
    for point in &surface.points {
        bytes
            .extend(point.iter().flat_map(|x| if is_high_first { x.to_be_bytes() } else { x.to_le_bytes() }));
        bytes.push(255);
    }
    for triangle in &surface.triangles {
        bytes.push(3);
        bytes.extend(
            triangle.iter().flat_map(|n| if is_high_first { n.to_be_bytes() } else { n.to_le_bytes() }),
        );
    }
    bytes
}
