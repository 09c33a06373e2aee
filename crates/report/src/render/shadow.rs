//! What the sun reaches.

use super::mesh::Mesh;
use super::raster::Raster;
use glam::DVec3;

/// Pixels of the sun's picture along each side.
const SIZE: usize = 1536;
/// Half the width of the filter that softens the edges of shadows [pixels].
const REACH: i64 = 2;

/// The scene as the sun sees it.
pub(super) struct ShadowMap {
    raster: Raster,
    right: DVec3,
    up: DVec3,
    /// Towards the sun.
    sun: DVec3,
    low: DVec3,
    /// Pixels per metre.
    scale: f64,
}

impl ShadowMap {
    /// The shadow that a scene casts on itself, the sun being in this direction (a unit vector, not
    /// vertical).
    pub(super) fn of(mesh: &Mesh, sun: DVec3) -> Self {
        let right = sun.cross(DVec3::Z).normalize();
        let up = right.cross(sun);
        let seen = |p: DVec3| DVec3::new(p.dot(right), p.dot(up), p.dot(sun));
        let places = || mesh.vertices.iter().filter(|c| c.place.is_finite()).map(|c| seen(c.place));
        let low = places().fold(DVec3::INFINITY, DVec3::min);
        let high = places().fold(DVec3::NEG_INFINITY, DVec3::max);
        let extent = (high - low).truncate().max_element().max(1e-9);
        let mut shadow =
            Self { raster: Raster::new([SIZE, SIZE]), right, up, sun, low, scale: SIZE as f64 / extent };
        let vertices: Vec<[f64; 3]> = mesh.vertices.iter().map(|c| shadow.seen(c.place)).collect();
        shadow.raster.draw(&vertices, &mesh.triangles);
        shadow
    }

    /// Place in the sun's picture, and how near it is [pixels], 1 at least.
    fn seen(&self, place: DVec3) -> [f64; 3] {
        let at = DVec3::new(place.dot(self.right), place.dot(self.up), place.dot(self.sun)) - self.low;
        let [x, y, near] = (at * self.scale).to_array();
        [x, y, 1.0 + near]
    }

    /// The part of the sun that reaches a place whose outward unit normal this is, 0 to 1.
    pub(super) fn light(&self, place: DVec3, normal: DVec3) -> f64 {
        // The picture has steps: a face must not shade itself, the less it faces the sun the more.
        let slope = normal.dot(self.sun).clamp(0.05, 1.0);
        let [x, y, near] = self.seen(place + normal * (2.5 / self.scale));
        let near = near + (1.0 + 1.5 / slope).min(12.0);
        let (x, y) = (x.floor() as i64, y.floor() as i64);
        let (mut reached, mut all) = (0.0, 0.0);
        for dy in -REACH..=REACH {
            for dx in -REACH..=REACH {
                let (i, j) = (x + dx, y + dy);
                all += 1.0;
                let inside = (0..SIZE as i64).contains(&i) && (0..SIZE as i64).contains(&j);
                if !inside || f64::from(self.raster.near[j as usize * SIZE + i as usize]) <= near {
                    reached += 1.0;
                }
            }
        }
        reached / all
    }
}

#[cfg(test)]
mod tests {
    use super::super::mesh::Vertex;
    use super::*;

    #[test]
    fn what_is_below_a_plate_lies_in_its_shadow() {
        let vertex = |x: f64, y: f64, z: f64| Vertex {
            place: DVec3::new(x, y, z),
            normal: DVec3::Z,
            tone: [[0; 3]; 2],
        };
        let square =
            |s: f64, z: f64| [vertex(-s, -s, z), vertex(s, -s, z), vertex(s, s, z), vertex(-s, s, z)];
        let mesh = Mesh {
            vertices: [square(2.0, 0.0), square(0.5, 1.0)].concat(),
            triangles: vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]],
        };
        let shadow = ShadowMap::of(&mesh, DVec3::new(0.3, 0.0, 1.0).normalize());
        let light = |x: f64, z: f64| shadow.light(DVec3::new(x, 0.0, z), DVec3::Z);
        assert_eq!((light(-0.3, 0.0), light(1.0, 0.0), light(0.0, 1.0)), (0.0, 1.0, 1.0));
    }
}
