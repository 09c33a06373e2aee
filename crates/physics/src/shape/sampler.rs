//! Contact points of any shape, from its mesh and its signed distance.
//!
//! The triangles are cut into small pieces. In every facet, the part of the surface between two sharp edges, the pieces that lie
//! in the same square of a lattice become one point; pieces next to sharp convex edges are left out. The signed distance puts
//! the point onto the surface where that is curved, so that the mesh need not be fine, and a fine mesh means no more points.

use super::facets::{Facets, normals};
use super::mesh::Mesh;
use super::point::SurfacePoint;
use glam::DVec3;
use std::collections::{BTreeMap, HashMap};

/// Side of the pieces over the spacing of the points.
const PIECE: f64 = 0.5;

/// Contact points about `spacing` [m] apart, with an `inset` [m] along x, y, z from sharp convex edges, of a shape with a `mesh`
/// and a signed distance [m].
pub(super) fn sample(
    mesh: &Mesh,
    distance: impl Fn(DVec3) -> f64,
    spacing: f64,
    inset: DVec3,
) -> Vec<SurfacePoint> {
    let normals = normals(mesh);
    let facets = Facets::new(mesh, &normals);
    let edges = Edges::new(&facets, inset, spacing);
    let is_mirrored = is_mirrored(mesh, &distance);
    let mut patches: BTreeMap<(usize, usize, [i64; 2]), Patch> = BTreeMap::new();
    for ((triangle, normal), facet) in mesh.triangles.iter().zip(&normals).zip(&facets.of) {
        let axis = facets.normal[*facet].unwrap_or(*normal).abs().max_position();
        let corners = triangle.map(|n| mesh.points[n as usize]);
        each_piece(corners, spacing, is_mirrored, |centre, area| {
            let area = area * edges.kept(*facet, centre);
            let square = [(axis + 1) % 3, (axis + 2) % 3].map(|n| (centre[n] / spacing).floor() as i64);
            // The two sides of a body that bulges are apart.
            let side = 2 * axis + usize::from(normal[axis] > 0.0);
            patches.entry((*facet, side, square)).or_default().add(centre, *normal, area);
        });
    }
    let mut points = Vec::with_capacity(patches.len() * if is_mirrored { 2 } else { 1 });
    for ((facet, ..), patch) in &patches {
        if patch.area < 1e-6 * spacing.powi(2) {
            continue;
        }
        let point = patch.point(&distance, facets.normal[*facet], spacing);
        points.push(point);
        if is_mirrored {
            let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
            points.push(SurfacePoint {
                position: flip(point.position),
                normal: flip(point.normal),
                area: point.area,
            });
        }
    }
    points
}

/// About the number of points of [`sample`].
pub(super) fn count(mesh: &Mesh, spacing: f64) -> f64 {
    let squares = |(triangle, normal): (&[u32; 3], DVec3)| {
        let [a, b, c] = triangle.map(|n| mesh.points[n as usize]);
        0.5 * (b - a).cross(c - a).length() * normal.abs().max_element() / spacing.powi(2)
    };
    mesh.triangles.iter().zip(normals(mesh)).map(squares).sum()
}

/// Whether the shape is its own mirror image in y = 0.
fn is_mirrored(mesh: &Mesh, distance: impl Fn(DVec3) -> f64) -> bool {
    let size = mesh.points.iter().map(|x| x.length()).fold(0.0, f64::max);
    let tolerance = 2e-9 * size;
    let agrees = |x: DVec3| {
        let image = DVec3::new(x.x, -x.y, x.z);
        (distance(x) - distance(image)).abs() <= tolerance
    };
    let centre = |triangle: &[u32; 3]| triangle.iter().map(|n| mesh.points[*n as usize]).sum::<DVec3>() / 3.0;
    mesh.points.iter().copied().all(agrees) && mesh.triangles.iter().map(centre).all(agrees)
}

/// Calls `each(centre, area)` for the pieces of a triangle; of a mirrored shape only for those with y > 0.
fn each_piece(corners: [DVec3; 3], spacing: f64, is_mirrored: bool, mut each: impl FnMut(DVec3, f64)) {
    let polygon = if is_mirrored { above(corners) } else { corners.to_vec() };
    for n in 2..polygon.len() {
        let [a, b, c] = [polygon[0], polygon[n - 1], polygon[n]];
        let longest = [b - a, c - b, a - c].map(DVec3::length).into_iter().fold(0.0, f64::max);
        let parts = (longest / (PIECE * spacing)).ceil().max(1.0);
        let area = 0.5 * (b - a).cross(c - a).length() / (parts * parts);
        let (across, up) = ((b - a) / parts, (c - a) / parts);
        for row in 0..parts as usize {
            for column in 0..parts as usize - row {
                let low = a + across * column as f64 + up * row as f64;
                each(low + (across + up) / 3.0, area);
                if column + row + 1 < parts as usize {
                    each(low + 2.0 * (across + up) / 3.0, area);
                }
            }
        }
    }
}

/// The part of a triangle with y ≥ 0: no corners, or three or four.
fn above(corners: [DVec3; 3]) -> Vec<DVec3> {
    let mut polygon = Vec::with_capacity(4);
    for n in 0..3 {
        let (from, to) = (corners[n], corners[(n + 1) % 3]);
        if from.y >= 0.0 {
            polygon.push(from);
        }
        if (from.y > 0.0 && to.y < 0.0) || (from.y < 0.0 && to.y > 0.0) {
            polygon.push(from.lerp(to, from.y / (from.y - to.y)).with_y(0.0));
        }
    }
    polygon
}

/// The pieces that become one point, weighted by their areas.
#[derive(Clone, Copy, Debug, Default)]
struct Patch {
    position: DVec3,
    normal: DVec3,
    area: f64,
}

impl Patch {
    fn add(&mut self, centre: DVec3, normal: DVec3, area: f64) {
        self.position += area * centre;
        self.normal += area * normal;
        self.area += area;
    }

    /// The point; `flat` is the normal of a flat facet.
    fn point(&self, distance: impl Fn(DVec3) -> f64, flat: Option<DVec3>, spacing: f64) -> SurfacePoint {
        let mut position = self.position / self.area;
        let mut normal = flat.unwrap_or(self.normal).normalize_or_zero();
        if flat.is_none() {
            position -= normal * distance(position);
            let step = 1e-4 * spacing;
            let slope = |axis: DVec3| distance(position + step * axis) - distance(position - step * axis);
            let gradient = DVec3::from_array(DVec3::AXES.map(slope)).normalize_or_zero();
            // Next to an edge that is not quite sharp the distance may have no gradient of use.
            if gradient.dot(normal) > 0.9 {
                normal = gradient;
            }
            position -= normal * distance(position);
        }
        SurfacePoint { position, normal, area: self.area }
    }
}

/// Sharp convex edges, found by position.
struct Edges<'a> {
    facets: &'a Facets,
    inset: DVec3,
    /// Width over which the surface fades in at the end of the inset [m].
    fade: f64,
    /// Width of a bucket [m].
    width: f64,
    /// Numbers of the edges of a facet in each bucket and the ones next to it.
    buckets: HashMap<(usize, [i64; 3]), Vec<usize>>,
}

impl<'a> Edges<'a> {
    fn new(facets: &'a Facets, inset: DVec3, spacing: f64) -> Self {
        let fade = PIECE * spacing;
        let reach = inset.max_element() + fade;
        // Steps of half the reach: whatever lies within reach of an edge is in a bucket next to that of a step.
        let mut edges = Self { facets, inset, fade, width: 1.5 * reach, buckets: HashMap::new() };
        if inset == DVec3::ZERO {
            return edges;
        }
        for (facet, convex) in facets.convex.iter().enumerate() {
            for (number, [from, to]) in convex.iter().enumerate() {
                let steps = (from.distance(*to) / (0.5 * reach)).ceil().max(1.0);
                for n in 0..=steps as usize {
                    let [i, j, k] = edges.bucket(from.lerp(*to, n as f64 / steps));
                    for n in 0..27 {
                        let bucket = [i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1];
                        let entered = edges.buckets.entry((facet, bucket)).or_default();
                        if entered.last() != Some(&number) {
                            entered.push(number);
                        }
                    }
                }
            }
        }
        edges
    }

    fn bucket(&self, x: DVec3) -> [i64; 3] {
        (x / self.width).floor().to_array().map(|n| n as i64)
    }

    /// Fraction of a piece of a facet that lies beyond the inset from all edges.
    fn kept(&self, facet: usize, x: DVec3) -> f64 {
        let near = self.buckets.get(&(facet, self.bucket(x))).into_iter().flatten();
        let beyond = |number: &usize| {
            let [from, to] = self.facets.convex[facet][*number];
            let along = to - from;
            let fraction = ((x - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            let arm = x - from - fraction * along;
            let inset = (self.inset * arm.normalize_or_zero()).length();
            (0.5 + (arm.length() - inset) / self.fade).clamp(0.0, 1.0)
        };
        near.map(beyond).fold(1.0, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{Axis, Block, Cylinder, Disc, Rotated, Shape, Sphere};

    fn sample(shape: &dyn Shape, spacing: f64, inset: DVec3) -> Vec<SurfacePoint> {
        super::sample(&shape.mesh(), |x| shape.signed_distance(x), spacing, inset)
    }

    fn shapes() -> [Box<dyn Shape>; 5] {
        [
            Box::new(Disc { diameter: 0.2, thickness: 0.05 }),
            Box::new(Block { size: DVec3::new(0.3, 0.2, 0.1) }),
            Box::new(Rotated::new(Box::new(Block { size: DVec3::new(0.3, 0.2, 0.1) }), 0.6)),
            Box::new(Cylinder { diameter: 0.2, length: 0.05, axis: Axis::X }),
            Box::new(Sphere { diameter: 0.2 }),
        ]
    }

    #[test]
    fn points_cover_the_surface() {
        for shape in shapes() {
            let own = shape.surface_points(DVec3::splat(0.004), DVec3::ZERO);
            let sampled = sample(shape.as_ref(), 0.004, DVec3::ZERO);
            let area = |points: &[SurfacePoint]| points.iter().map(|p| p.area).sum::<f64>();
            assert!((area(&sampled) / area(&own) - 1.0).abs() < 2e-3, "{shape:?}");
            let resultant: DVec3 = sampled.iter().map(|p| p.area * p.normal).sum();
            assert!(resultant.length() < 1e-3 * area(&own), "{shape:?}: {resultant}");
            let volume = sampled.iter().map(|p| p.area * p.normal.dot(p.position)).sum::<f64>() / 3.0;
            let exact = shape.mass_properties().volume;
            assert!((volume / exact - 1.0).abs() < 2e-3, "{shape:?}: {volume} of {exact}");
            for p in &sampled {
                assert!(shape.signed_distance(p.position).abs() < 1e-9, "{shape:?} {p:?}");
                assert!(shape.signed_distance(p.position + 1e-4 * p.normal) > 0.99e-4, "{shape:?} {p:?}");
            }
            let estimate = count(&shape.mesh(), 0.004);
            assert!((estimate / sampled.len() as f64 - 1.0).abs() < 0.2, "{shape:?}: {estimate}");
        }
    }

    #[test]
    fn an_inset_leaves_out_what_the_shapes_themselves_leave_out() {
        for shape in shapes() {
            // Where the inset differs from axis to axis, that from a round edge is approximated: 2.1 % apart on the disc.
            for (inset, tolerance) in [(DVec3::splat(0.008), 0.02), (DVec3::new(0.004, 0.008, 0.012), 0.03)] {
                let area = |points: &[SurfacePoint]| points.iter().map(|p| p.area).sum::<f64>();
                let own = area(&shape.surface_points(DVec3::splat(0.004), inset));
                let sampled = area(&sample(shape.as_ref(), 0.004, inset));
                assert!((sampled / own - 1.0).abs() < tolerance, "{shape:?} {inset}: {sampled} {own}");
            }
        }
    }

    #[test]
    fn mirror_images_are_adjacent() {
        for shape in shapes() {
            let points = sample(shape.as_ref(), 0.007, DVec3::splat(0.003));
            for pair in points.chunks(2) {
                let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
                assert_eq!(flip(pair[0].position), pair[1].position, "{shape:?}");
                assert_eq!(flip(pair[0].normal), pair[1].normal, "{shape:?}");
            }
        }
    }

    #[test]
    fn a_fine_mesh_means_no_more_points() {
        let points = sample(&Sphere { diameter: 0.2 }, 0.05, DVec3::ZERO);
        let triangles = Sphere { diameter: 0.2 }.mesh().triangles.len();
        assert!(points.len() < 150 && triangles > 9000, "{} points", points.len());
    }
}
