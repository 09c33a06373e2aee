//! Contact points of any shape, from its mesh and its signed distance.
//!
//! The triangles are cut into small pieces. In every facet, the part of the surface between two sharp edges,
//! the pieces that lie in the same square of a lattice become one point; pieces next to sharp convex edges
//! are left out. The signed distance puts the point onto the surface where that is curved, so that the mesh
//! need not be fine, and a fine mesh means no more points.

use super::facets::{Facets, normals};
use super::mesh::Mesh;
use super::point::SurfacePoint;
use super::triangle::area_vector;
use glam::DVec3;
use std::collections::HashMap;

/// Side of the pieces over the spacing of the points.
const PIECE: f64 = 0.5;
/// Pieces of thin triangles up to which each of them is looked at (chosen: a tenth of a second). A fan of
/// triangles as long as the body has many more, of no area.
const MOST_PIECES: f64 = 1e7;
/// Pieces to a square of the spacing where there are more, spread evenly: the area of a point is right to
/// about a per cent.
const PIECES_TO_A_SQUARE: f64 = 64.0;
/// Points and triangles, spread over the surface, that are asked whether it is mirrored.
const MOST_PROBES: usize = 100_000;

/// What is known of a surface whatever the spacing.
#[derive(Debug)]
pub(super) struct Plan {
    facets: Facets,
    is_mirrored: bool,
}

impl Plan {
    /// The plan of a shape with a `mesh` and a signed distance [m].
    pub(super) fn new(mesh: &Mesh, distance: impl Fn(DVec3) -> f64) -> Self {
        Self { facets: Facets::new(mesh, &normals(mesh)), is_mirrored: is_mirrored(mesh, distance) }
    }
}

/// Contact points about `spacing` [m] apart, with an `inset` [m] along x, y, z from sharp convex edges, of a
/// shape with a `mesh` and a signed distance [m].
pub(super) fn sample(
    mesh: &Mesh,
    distance: impl Fn(DVec3) -> f64,
    spacing: f64,
    inset: DVec3,
) -> Vec<SurfacePoint> {
    let plan = Plan::new(mesh, &distance);
    sample_as_planned(mesh, distance, &plan, spacing, inset)
}

/// Contact points of a surface that has been looked at before.
pub(super) fn sample_as_planned(
    mesh: &Mesh,
    distance: impl Fn(DVec3) -> f64,
    Plan { facets, is_mirrored }: &Plan,
    spacing: f64,
    inset: DVec3,
) -> Vec<SurfacePoint> {
    let normals = normals(mesh);
    let mut edges = Edges::new(facets, inset, spacing);
    let mut pieces = Pieces::new(mesh, spacing, *is_mirrored);
    let mut patches = Patches::default();
    // Area of each facet, and what is left of it within the inset [m²].
    let mut areas = vec![[0.0; 2]; facets.normal.len()];
    for ((triangle, normal), facet) in mesh.triangles.iter().zip(&normals).zip(&facets.of) {
        let axis = facets.normal[*facet].unwrap_or(*normal).abs().max_position();
        let corners = triangle.map(|n| mesh.points[n as usize]);
        pieces.each(corners, |centre, area| {
            let kept = area * edges.kept(*facet, centre);
            areas[*facet] = [areas[*facet][0] + area, areas[*facet][1] + kept];
            let square = [(axis + 1) % 3, (axis + 2) % 3].map(|n| (centre[n] / spacing).floor() as i64);
            // The two sides of a body that bulges are apart.
            let side = 2 * axis + usize::from(normal[axis] > 0.0);
            patches.at((*facet, side, square)).add(centre, *normal, kept);
        });
    }
    let patches = patches.in_order();
    let mut points = Vec::with_capacity(patches.len() * if *is_mirrored { 2 } else { 1 });
    for ((facet, ..), patch) in &patches {
        if patch.area < 1e-6 * spacing.powi(2) {
            continue;
        }
        let [whole, kept] = areas[*facet];
        let point = patch.point(&distance, facets.normal[*facet], (spacing, whole / kept));
        points.push(point);
        if *is_mirrored {
            let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
            points.push(SurfacePoint { position: flip(point.position), normal: flip(point.normal), ..point });
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
    let stride = |count: usize| count.div_ceil(MOST_PROBES).max(1);
    mesh.points.iter().copied().step_by(stride(mesh.points.len())).all(agrees)
        && mesh.triangles.iter().map(centre).step_by(stride(mesh.triangles.len())).all(agrees)
}

/// Cuts triangles into pieces; of a mirrored shape only the part with y > 0.
struct Pieces {
    spacing: f64,
    is_mirrored: bool,
    /// Whether thin triangles have pieces by their areas rather than by their lengths.
    spreads: bool,
    /// Number of pieces that were spread so far.
    spread: u32,
}

impl Pieces {
    fn new(mesh: &Mesh, spacing: f64, is_mirrored: bool) -> Self {
        let all = |triangle: &[u32; 3]| {
            let corners = triangle.map(|n| mesh.points[n as usize]);
            let [cut, spread] = [parts(&corners, spacing).powi(2), spread_pieces(&corners, spacing)];
            if cut > spread { cut } else { 0.0 }
        };
        let spreads = mesh.triangles.iter().map(all).sum::<f64>() > MOST_PIECES;
        Self { spacing, is_mirrored, spreads, spread: 0 }
    }

    /// Calls `each(centre, area)` for the pieces of a triangle.
    fn each(&mut self, corners: [DVec3; 3], mut each: impl FnMut(DVec3, f64)) {
        let is_mirrored = self.is_mirrored;
        let mut cut = |corners: [DVec3; 3]| {
            let count = spread_pieces(&corners, self.spacing);
            if self.spreads && parts(&corners, self.spacing).powi(2) > count {
                self.spread_over(corners, count, &mut each);
            } else {
                each_piece(corners, self.spacing, &mut each);
            }
        };
        if is_mirrored {
            let polygon = above(corners);
            (2..polygon.len()).for_each(|n| cut([polygon[0], polygon[n - 1], polygon[n]]));
        } else {
            cut(corners);
        }
    }

    /// Pieces of equal area at places that, from one triangle to the next, lie evenly between its corners
    /// (Roberts 2018, the R₂ sequence).
    fn spread_over(&mut self, [a, b, c]: [DVec3; 3], count: f64, each: &mut impl FnMut(DVec3, f64)) {
        const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];
        let area = 0.5 * area_vector(&[a, b, c]).length() / count;
        for _ in 0..count as usize {
            self.spread = self.spread.wrapping_add(1);
            let [u, v] = STEPS.map(|step| (f64::from(self.spread) * step).fract());
            let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
            each(a + u * (b - a) + v * (c - a), area);
        }
    }
}

/// Parts into which the edges of a triangle are divided.
fn parts([a, b, c]: &[DVec3; 3], spacing: f64) -> f64 {
    let longest = [*b - *a, *c - *b, *a - *c].map(DVec3::length).into_iter().fold(0.0, f64::max);
    (longest / (PIECE * spacing)).ceil().max(1.0)
}

/// Pieces of a triangle where they are spread.
fn spread_pieces(corners: &[DVec3; 3], spacing: f64) -> f64 {
    (PIECES_TO_A_SQUARE * 0.5 * area_vector(corners).length() / spacing.powi(2)).ceil().max(1.0)
}

/// Calls `each(centre, area)` for the equal pieces of a triangle.
fn each_piece([a, b, c]: [DVec3; 3], spacing: f64, each: &mut impl FnMut(DVec3, f64)) {
    let parts = parts(&[a, b, c], spacing);
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

    /// The point; `flat` is the normal of a flat facet, `share` the facet's area over that of its patches.
    fn point(
        &self,
        distance: impl Fn(DVec3) -> f64,
        flat: Option<DVec3>,
        (spacing, share): (f64, f64),
    ) -> SurfacePoint {
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
        SurfacePoint { position, normal, area: self.area, represents: share * self.area }
    }
}

/// Facet, side and square of a patch.
type Key = (usize, usize, [i64; 2]);

/// All patches. Pieces that follow each other are mostly in the same one.
#[derive(Default)]
struct Patches {
    number: HashMap<Key, usize>,
    all: Vec<(Key, Patch)>,
    last: Option<(Key, usize)>,
}

impl Patches {
    fn at(&mut self, key: Key) -> &mut Patch {
        let number = match self.last {
            Some((last, number)) if last == key => number,
            _ => *self.number.entry(key).or_insert_with(|| {
                self.all.push((key, Patch::default()));
                self.all.len() - 1
            }),
        };
        self.last = Some((key, number));
        &mut self.all[number].1
    }

    fn in_order(mut self) -> Vec<(Key, Patch)> {
        self.all.sort_unstable_by_key(|(key, _)| *key);
        self.all
    }
}

/// A facet and a cube of space.
type Bucket = (usize, [i64; 3]);

/// Sharp convex edges, found by position.
struct Edges<'a> {
    facets: &'a Facets,
    inset: DVec3,
    /// Width over which the surface fades in at the end of the inset [m].
    fade: f64,
    /// Width of a bucket [m].
    width: f64,
    /// Numbers of the edges of a facet in each bucket.
    within: HashMap<Bucket, Vec<u32>>,
    /// Place in `lists` of the edges in a bucket and the ones next to it, of those that were asked for; the
    /// last of them.
    near: HashMap<Bucket, usize>,
    lists: Vec<Vec<u32>>,
    last: Option<(Bucket, usize)>,
}

impl<'a> Edges<'a> {
    fn new(facets: &'a Facets, inset: DVec3, spacing: f64) -> Self {
        let fade = PIECE * spacing;
        let reach = inset.max_element() + fade;
        // Steps of half the reach: whatever lies within reach of an edge is in a bucket next to that of a
        // step.
        let width = 1.5 * reach;
        let mut within: HashMap<Bucket, Vec<u32>> = HashMap::new();
        let all = if inset == DVec3::ZERO { &[][..] } else { &facets.convex };
        for (facet, convex) in all.iter().enumerate() {
            for (number, [from, to]) in convex.iter().enumerate() {
                let steps = (from.distance(*to) / (0.5 * reach)).ceil().max(1.0);
                for n in 0..=steps as usize {
                    let bucket = bucket(from.lerp(*to, n as f64 / steps), width);
                    let entered = within.entry((facet, bucket)).or_default();
                    if entered.last() != Some(&(number as u32)) {
                        entered.push(number as u32);
                    }
                }
            }
        }
        Self { facets, inset, fade, width, within, near: HashMap::new(), lists: Vec::new(), last: None }
    }

    /// Number of the list of edges in a bucket and the ones next to it.
    fn around(&mut self, key: Bucket) -> usize {
        if let Some((last, list)) = self.last
            && last == key
        {
            return list;
        }
        let list = *self.near.entry(key).or_insert_with(|| {
            let (facet, [i, j, k]) = key;
            let next = (0..27).map(|n| [i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1]);
            let mut list: Vec<u32> =
                next.filter_map(|bucket| self.within.get(&(facet, bucket))).flatten().copied().collect();
            list.sort_unstable();
            list.dedup();
            self.lists.push(list);
            self.lists.len() - 1
        });
        self.last = Some((key, list));
        list
    }

    /// Fraction of a piece of a facet that lies beyond the inset from all edges.
    fn kept(&mut self, facet: usize, x: DVec3) -> f64 {
        if self.within.is_empty() || self.facets.convex[facet].is_empty() {
            return 1.0;
        }
        let list = self.around((facet, bucket(x, self.width)));
        // Beyond it nothing fades.
        let farthest = (self.inset.max_element() + 0.5 * self.fade).powi(2) * (1.0 + 1e-9);
        let beyond = |number: &u32| {
            let [from, to] = self.facets.convex[facet][*number as usize];
            let along = to - from;
            let fraction = ((x - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            let arm = x - from - fraction * along;
            if arm.length_squared() > farthest {
                return 1.0;
            }
            let inset = (self.inset * arm.normalize_or_zero()).length();
            (0.5 + (arm.length() - inset) / self.fade).clamp(0.0, 1.0)
        };
        self.lists[list].iter().map(beyond).fold(1.0, f64::min)
    }
}

fn bucket(x: DVec3, width: f64) -> [i64; 3] {
    (x / width).floor().to_array().map(|n| n as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Axis, Block, Cylinder, Disc, Rotated, Shape, Sphere};

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
            // Where the inset differs from axis to axis, that from a round edge is approximated: 2.1 % apart
            // on the disc.
            for (inset, tolerance) in [(DVec3::splat(0.008), 0.02), (DVec3::new(0.004, 0.008, 0.012), 0.03)] {
                let area = |points: &[SurfacePoint]| points.iter().map(|p| p.area).sum::<f64>();
                let own = shape.surface_points(DVec3::splat(0.004), inset);
                let sampled = sample(shape.as_ref(), 0.004, inset);
                let ratio = area(&sampled) / area(&own);
                assert!((ratio - 1.0).abs() < tolerance, "{shape:?} {inset}: {ratio}");
                // What is left out is shared out among the rest.
                let whole = area(&shape.surface_points(DVec3::splat(0.004), DVec3::ZERO));
                for points in [own, sampled] {
                    let ratio = points.iter().map(|p| p.represents).sum::<f64>() / whole;
                    assert!((ratio - 1.0).abs() < 2e-3, "{shape:?} {inset}: {ratio}");
                }
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
    fn a_fan_of_thin_triangles_takes_no_longer_than_its_area() {
        // A cone, 1 m high on a base of 0.2 m, of as many triangles that meet at its tip.
        for count in [500_u32, 6000] {
            let angle = |n: u32| std::f64::consts::TAU * f64::from(n) / f64::from(count);
            let rim = |n: u32| DVec3::new(0.1 * angle(n).cos(), 0.1 * angle(n).sin(), 0.0);
            let points = (0..count).map(rim).chain([DVec3::Z, DVec3::ZERO]).collect();
            let of = |n: u32| [[n, (n + 1) % count, count], [(n + 1) % count, n, count + 1]];
            let mesh = Mesh { points, triangles: (0..count).flat_map(of).collect() };
            let began = std::time::Instant::now();
            let points = super::sample(&mesh, |_| 0.0, 0.01, DVec3::splat(0.01));
            assert!(began.elapsed().as_secs() < 20, "{count}: {:?}", began.elapsed());
            // Without 10 mm on both sides of the sharp rim.
            let side = std::f64::consts::PI * 0.1 * 1.01_f64.sqrt() * (1.0 - 0.01 / 1.01_f64.sqrt()).powi(2);
            let expected = side + std::f64::consts::PI * 0.09_f64.powi(2);
            let area: f64 = points.iter().map(|p| p.area).sum();
            assert!((area / expected - 1.0).abs() < 0.02, "{count}: {area}, not {expected}");
            let most = points.iter().map(|p| p.area).fold(0.0, f64::max);
            assert!((2000..6000).contains(&points.len()) && most < 2.5e-4, "{}: {most}", points.len());
        }
    }

    #[test]
    fn a_fine_mesh_means_no_more_points() {
        let points = sample(&Sphere { diameter: 0.2 }, 0.05, DVec3::ZERO);
        let triangles = Sphere { diameter: 0.2 }.mesh().triangles.len();
        assert!(points.len() < 150 && triangles > 9000, "{} points", points.len());
    }
}
