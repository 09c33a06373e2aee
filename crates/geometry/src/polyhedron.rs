//! A solid bounded by plane triangles, such as one drawn in a CAD program.

use super::edges::neighbours;
use super::hierarchy::Hierarchy;
use super::mass::MassProperties;
use super::mesh::Mesh;
use super::sampler::{self, Plan};
use super::triangle::{self, Feature};
use super::{Shape, SurfacePoint};
use glam::DVec3;
use std::sync::{Arc, OnceLock};

/// A triangle must be nearer than another one by this, as a factor of the squared distance, to be looked for:
/// above a face the boxes of all its triangles are as near as the face itself, but for rounding.
const NEARER: f64 = 1.0 - 1e-12;

/// A solid bounded by a closed surface of triangles, which may consist of several shells. Copies share their
/// triangles.
///
/// The distance to the surface is that to its nearest triangle. Its sign is that of the nearest point's
/// pseudo-normal: the sum of the normals of the triangles that meet there, each weighted by its angle
/// (Bærentzen & Aanæs 2005).
#[derive(Clone)]
pub struct Polyhedron {
    parts: Arc<Parts>,
}

struct Parts {
    surface: Mesh,
    hierarchy: Hierarchy,
    /// The triangle beyond each edge.
    beyond: Vec<[u32; 3]>,
    /// Pseudo-normal of each point.
    point_normals: Vec<DVec3>,
    mass_properties: MassProperties,
    /// How contact points are laid out, once some were.
    plan: OnceLock<Plan>,
}

impl Polyhedron {
    /// The solid that a closed surface bounds, whose triangles share their points and are counter-clockwise
    /// seen from outside. [`super::repaired`] makes such a surface from what a file holds.
    #[must_use]
    pub fn new(surface: Mesh) -> Self {
        let corners: Vec<[DVec3; 3]> =
            surface.triangles.iter().map(|t| t.map(|n| surface.points[n as usize])).collect();
        let (hierarchy, order) = Hierarchy::new(&corners);
        let triangles: Vec<[u32; 3]> = order.iter().map(|n| surface.triangles[*n as usize]).collect();
        let surface = Mesh { triangles, ..surface };
        let parts = Parts {
            beyond: neighbours(&surface.triangles),
            point_normals: point_normals(&surface, &hierarchy.corners),
            mass_properties: MassProperties::of_mesh(&surface),
            hierarchy,
            surface,
            plan: OnceLock::new(),
        };
        Self { parts: Arc::new(parts) }
    }

    /// Surface of the solid.
    #[must_use]
    pub fn surface(&self) -> &Mesh {
        &self.parts.surface
    }

    pub(super) fn hierarchy(&self) -> &Hierarchy {
        &self.parts.hierarchy
    }

    /// Whether the polyhedron is its own mirror image in the plane through the origin across an axis, up to a
    /// distance [m].
    #[must_use]
    pub fn is_mirrored(&self, axis: usize, tolerance: f64) -> bool {
        let image = |mut x: DVec3| {
            x[axis] = -x[axis];
            x
        };
        let agrees = |x: DVec3| self.signed_distance(image(x)).abs() <= tolerance;
        let centre = |corners: &[DVec3; 3]| corners.iter().sum::<DVec3>() / 3.0;
        self.parts.surface.points.iter().copied().all(agrees)
            && self.parts.hierarchy.corners.iter().map(centre).all(agrees)
    }
}

impl Parts {
    /// Direction out of the solid at a point of a triangle; of any length.
    fn pseudo_normal(&self, number: usize, feature: Feature) -> DVec3 {
        let normal = |n: usize| triangle::area_vector(&self.hierarchy.corners[n]).normalize_or_zero();
        match feature {
            Feature::Face => normal(number),
            Feature::Edge(n) => normal(number) + normal(self.beyond[number][usize::from(n)] as usize),
            Feature::Corner(n) => self.point_normals[self.surface.triangles[number][usize::from(n)] as usize],
        }
    }
}

/// The normals of the triangles at each point, each times its angle there.
fn point_normals(surface: &Mesh, corners: &[[DVec3; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; surface.points.len()];
    for (numbers, corners) in surface.triangles.iter().zip(corners) {
        let normal = triangle::area_vector(corners).normalize_or_zero();
        for n in 0..3 {
            let [here, next, last] = [0, 1, 2].map(|m| corners[(n + m) % 3]);
            let (one, other) = (next - here, last - here);
            let angle = one.cross(other).length().atan2(one.dot(other));
            normals[numbers[n] as usize] += angle * normal;
        }
    }
    normals
}

impl std::fmt::Debug for Polyhedron {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Polyhedron of {} triangles", self.parts.surface.triangles.len())
    }
}

impl Shape for Polyhedron {
    fn signed_distance(&self, x: DVec3) -> f64 {
        let (mut found, mut offset) = ((0, Feature::Face), DVec3::ZERO);
        let mut distance = f64::INFINITY;
        self.parts.hierarchy.nearest(x, f64::INFINITY, |number, least| {
            let (nearest, feature) = triangle::nearest(x, &self.parts.hierarchy.corners[number]);
            let squared = (x - nearest).length_squared();
            if squared >= distance {
                return least;
            }
            (found, offset, distance) = ((number, feature), x - nearest, squared);
            squared * NEARER
        });
        let is_inside = self.parts.pseudo_normal(found.0, found.1).dot(offset) < 0.0;
        if is_inside { -distance.sqrt() } else { distance.sqrt() }
    }

    fn extent(&self, direction: DVec3) -> f64 {
        self.parts.hierarchy.extent(direction)
    }

    fn mass_properties(&self) -> MassProperties {
        self.parts.mass_properties
    }

    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        let distance = |x| self.signed_distance(x);
        let plan = self.parts.plan.get_or_init(|| Plan::new(self.surface(), distance));
        sampler::sample_as_planned(self.surface(), distance, plan, spacing.min_element(), inset)
    }

    fn surface_point_count(&self, spacing: DVec3, _inset: DVec3) -> f64 {
        sampler::count(&self.parts.surface, spacing.min_element())
    }

    fn mesh(&self) -> Mesh {
        self.parts.surface.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Block, Disc, Sphere};
    use std::f64::consts::TAU;

    /// A disc of as many segments, axle along y, as a CAD program would write it.
    fn disc(segments: usize, diameter: f64, thickness: f64) -> Polyhedron {
        let mut points = vec![DVec3::new(0.0, -0.5 * thickness, 0.0), DVec3::new(0.0, 0.5 * thickness, 0.0)];
        let mut triangles = Vec::new();
        for n in 0..segments as u32 {
            let (sin, cos) = (TAU * f64::from(n) / segments as f64).sin_cos();
            let at = |y: f64| DVec3::new(0.5 * diameter * sin, y * thickness, 0.5 * diameter * cos);
            points.extend([at(-0.5), at(0.5)]);
            let (a, b) = (2 + 2 * n, 2 + 2 * ((n + 1) % segments as u32));
            triangles.extend([[0, b, a], [1, a + 1, b + 1], [a, b, a + 1], [b, b + 1, a + 1]]);
        }
        Polyhedron::new(Mesh { points, triangles })
    }

    /// Points in a box, evenly spread (Halton 1960).
    fn scattered(count: usize, size: DVec3) -> impl Iterator<Item = DVec3> {
        let halton = |mut n: usize, base: usize| {
            let (mut sum, mut part) = (0.0, 1.0);
            while n > 0 {
                part /= base as f64;
                sum += part * (n % base) as f64;
                n /= base;
            }
            sum - 0.5
        };
        (1..=count).map(move |n| size * DVec3::new(halton(n, 2), halton(n, 3), halton(n, 5)))
    }

    #[test]
    fn the_distance_to_a_block_is_exact() {
        let block = Block { size: DVec3::new(0.3, 0.2, 0.1) };
        let same = Polyhedron::new(block.mesh());
        for x in scattered(5000, DVec3::splat(0.6)) {
            let (expected, found) = (block.signed_distance(x), same.signed_distance(x));
            assert!((expected - found).abs() < 1e-14, "{x}: {found}, not {expected}");
        }
        let (expected, found) = (block.mass_properties(), same.mass_properties());
        assert!((expected.volume - found.volume).abs() < 1e-15 && found.centroid.length() < 1e-15);
        assert_eq!(same.bounds(), block.bounds());
        assert!(!same.is_revolved() && same.is_mirrored(1, 1e-12));
    }

    #[test]
    fn a_disc_of_triangles_is_a_disc() {
        let exact = Disc { diameter: 0.2, thickness: 0.05 };
        for segments in [96, 384] {
            let meshed = disc(segments, 0.2, 0.05);
            // The segments lie inside the circle by this at most.
            let sag = 0.1 * (1.0 - (0.5 * TAU / segments as f64).cos());
            for x in scattered(2000, DVec3::new(0.4, 0.2, 0.4)) {
                let off = meshed.signed_distance(x) - exact.signed_distance(x);
                assert!((-1e-14..=sag + 1e-14).contains(&off), "{segments}: {x}: {off:e}");
            }
            let angle = TAU / segments as f64;
            let fraction = angle.sin() / angle;
            let (solid, circle) = (meshed.mass_properties(), exact.mass_properties());
            assert!((solid.volume / (circle.volume * fraction) - 1.0).abs() < 1e-12);
            // ∫ r² over a triangle of the fan: r⁴ sin α (2 + cos α)/12, against r⁴ α/4 (the inertia per mass:
            // over the area).
            let inertia = (2.0 + angle.cos()) / 3.0;
            assert!((solid.about_axle() / (circle.about_axle() * inertia) - 1.0).abs() < 1e-12);
            let area = |shape: &dyn Shape| -> f64 {
                shape.surface_points(DVec3::splat(0.005), DVec3::ZERO).iter().map(|p| p.area).sum()
            };
            let ratio = area(&meshed) / area(&exact);
            assert!((ratio - 1.0).abs() < 2e-3, "{segments}: {ratio}");
            for (axis, y) in [(0, 0.1), (1, 0.025), (2, 0.1)] {
                assert!((meshed.bounds().1[axis] - y).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn mirrored_points_of_a_disc_of_triangles_are_adjacent() {
        for pair in disc(96, 0.2, 0.05).surface_points(DVec3::splat(0.008), DVec3::splat(0.003)).chunks(2) {
            assert_eq!(pair[0].position.y, -pair[1].position.y);
        }
    }

    #[test]
    fn the_sign_is_right_everywhere_round_a_notched_body() {
        // A block with a prism cut out of it: concave and convex edges and corners, all sharp.
        let outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.1, 0.1], [2.0, 3.0], [0.0, 3.0]];
        let mut points = Vec::new();
        for [x, z] in outline {
            points.extend([DVec3::new(x, -1.0, z), DVec3::new(x, 1.0, z)]);
        }
        let mut triangles: Vec<[u32; 3]> = Vec::new();
        for n in 0..6_u32 {
            let (a, b) = (2 * n, 2 * ((n + 1) % 6));
            triangles.extend([[a, a + 1, b], [b, a + 1, b + 1]]);
        }
        for [a, b, c] in [[0, 1, 3], [1, 2, 3], [0, 3, 5], [3, 4, 5]] {
            triangles.extend([[2 * a, 2 * b, 2 * c], [2 * a + 1, 2 * c + 1, 2 * b + 1]]);
        }
        let mut solid = Polyhedron::new(Mesh { points: points.clone(), triangles: triangles.clone() });
        if solid.mass_properties().volume < 0.0 {
            triangles.iter_mut().for_each(|t| t.swap(0, 1));
            solid = Polyhedron::new(Mesh { points, triangles });
        }
        let inside = |x: DVec3| {
            let crossings = (0..6).filter(|n| {
                let ([x0, z0], [x1, z1]) = (outline[*n], outline[(*n + 1) % 6]);
                (z0 > x.z) != (z1 > x.z) && x.x < x0 + (x.z - z0) / (z1 - z0) * (x1 - x0)
            });
            x.y.abs() < 1.0 && crossings.count() % 2 == 1
        };
        for x in scattered(20_000, DVec3::new(8.0, 4.0, 8.0)) {
            let x = x + DVec3::new(2.0, 0.0, 1.5);
            let distance = solid.signed_distance(x);
            assert!((distance < 0.0) == inside(x) || distance.abs() < 1e-12, "{x}: {distance}");
        }
    }

    #[test]
    fn support_and_bounds_are_those_of_the_points() {
        let sphere = Polyhedron::new(Sphere { diameter: 0.2 }.mesh());
        for x in scattered(200, DVec3::ONE) {
            let direction = x.normalize();
            let slow = sphere.surface().points.iter().map(|p| direction.dot(*p)).fold(0.0, f64::max);
            assert_eq!(sphere.extent(direction), slow);
        }
    }
}
