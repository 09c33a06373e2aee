//! Where solids touch each other, by a collision library.

use crate::{MassProperties, Shape};
use glam::{DQuat, DVec3};
use parry3d_f64::math::{Pose3, Rot3, Vec3};
use parry3d_f64::query::{ContactManifold, DefaultQueryDispatcher, PersistentQueryDispatcher};
use parry3d_f64::shape::{SharedShape, TriMeshFlags};
use std::panic::catch_unwind;

/// Difference of its volume from that of its convex hull, relative to it, below which a solid is convex.
const CONVEX: f64 = 1e-6;

/// Two solids as the collision library knows them: a ball or a disc with sharp rims as it is, any other by
/// its mesh. The library has tolerances in absolute numbers: lengths are in units of the smaller solid.
#[derive(Clone)]
pub struct Solids {
    shapes: [SharedShape; 2],
    /// Radii of the balls about the reference points that enclose the solids [m].
    pub radii: [f64; 2],
    /// Unit of length of the shapes [m].
    unit: f64,
}

impl std::fmt::Debug for Solids {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Solids {{ radii: {:?} }}", self.radii)
    }
}

/// Where a body is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Of its reference point [m].
    pub position: DVec3,
    /// How it is turned.
    pub attitude: DQuat,
}

/// A place where two solids touch, or nearly do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Near {
    /// From the reference point of each to the point of its surface, along the axes of space [m].
    pub arms: [DVec3; 2],
    /// Unit normal from the first to the second, along the axes of space.
    pub normal: DVec3,
    /// Gap between the surfaces [m], negative where they overlap.
    pub gap: f64,
}

impl Solids {
    /// The solids of two shapes; `None` where one has no surface, or its mesh is none.
    #[must_use]
    pub fn of(shapes: [&dyn Shape; 2]) -> Option<Self> {
        if !shapes.iter().all(|shape| shape.has_surface()) {
            return None;
        }
        let radii = shapes.map(|shape| {
            let (low, high) = shape.bounds();
            low.abs().max(high.abs()).length()
        });
        let unit = radii[0].min(radii[1]);
        let [first, second] = shapes.map(|shape| known(shape, unit));
        Some(Self { shapes: [first?, second?], radii, unit })
    }

    /// Adds where the solids are nearer than `reach` [m].
    pub fn near(&self, places: [&Place; 2], reach: f64, found: &mut Vec<Near>) {
        let [first, second] = places;
        let apart = first.position.distance(second.position);
        if apart > self.radii[0] + self.radii[1] + reach {
            return;
        }
        let (to_first, reach) = (first.attitude.inverse(), reach / self.unit);
        let from_first =
            pose(to_first * (second.position - first.position) / self.unit, to_first * second.attitude);
        let mut manifolds: Vec<ContactManifold<(), ()>> = Vec::new();
        let [a, b] = self.shapes.each_ref().map(|shape| &**shape);
        // Every pair of the shapes that are made here is known to the library.
        let _ = DefaultQueryDispatcher.contact_manifolds(&from_first, a, b, reach, &mut manifolds, &mut None);
        for manifold in &manifolds {
            let normal = first.attitude * of(manifold.local_n1);
            for point in manifold.points.iter().filter(|point| point.dist < reach) {
                let [on_first, on_second] = [
                    manifold.subshape_pos1().map_or(point.local_p1, |pose| pose * point.local_p1),
                    manifold.subshape_pos2().map_or(point.local_p2, |pose| pose * point.local_p2),
                ];
                let arms = [first.attitude * of(on_first), second.attitude * of(on_second)];
                let arms = arms.map(|arm| self.unit * arm);
                found.push(Near { arms, normal, gap: self.unit * point.dist });
            }
        }
    }
}

/// A shape in a unit of length [m] as the library knows it.
fn known(shape: &dyn Shape, unit: f64) -> Option<SharedShape> {
    if let Some(radius) = shape.as_ball() {
        return Some(SharedShape::ball(radius / unit));
    }
    match shape.as_disc() {
        Some([diameter, thickness]) => {
            Some(SharedShape::cylinder(0.5 * thickness / unit, 0.5 * diameter / unit))
        }
        None => of_mesh(shape, unit),
    }
}

/// A convex solid by its hull, any other by its triangles.
fn of_mesh(shape: &dyn Shape, unit: f64) -> Option<SharedShape> {
    let mesh = shape.mesh();
    let points: Vec<Vec3> = mesh.points.iter().map(|point| vector(*point / unit)).collect();
    let volume = MassProperties::of_mesh(&mesh).volume / (unit * unit * unit);
    // Of degenerate faces the library panics: then by its triangles.
    let hull = catch_unwind(|| SharedShape::convex_hull(&points)).ok().flatten();
    let is_convex = |hull: &SharedShape| (hull.mass_properties(1.0).mass() / volume - 1.0).abs() < CONVEX;
    hull.filter(is_convex).or_else(|| {
        let flags = TriMeshFlags::FIX_INTERNAL_EDGES;
        SharedShape::trimesh_with_flags(points, mesh.triangles, flags).ok()
    })
}

fn vector(v: DVec3) -> Vec3 {
    Vec3::from_array(v.to_array())
}

fn of(v: Vec3) -> DVec3 {
    DVec3::from_array(v.to_array())
}

fn pose(position: DVec3, attitude: DQuat) -> Pose3 {
    Pose3::from_parts(vector(position), Rot3::from_array(attitude.to_array()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Block, Disc, Sphere};

    fn near(a: &dyn Shape, b: &dyn Shape, at: DVec3, attitude: DQuat) -> Vec<Near> {
        let solids = Solids::of([a, b]).expect("two solids");
        let places = [Place::default(), Place { position: at, attitude }];
        let mut found = Vec::new();
        solids.near([&places[0], &places[1]], 0.01, &mut found);
        found
    }

    #[test]
    fn balls_touch_in_one_point_between_their_middles() {
        let ball = Sphere { diameter: 0.2 };
        let at = DVec3::new(0.12, 0.0, 0.16);
        let found = near(&ball, &ball, 1.01 * at, DQuat::IDENTITY);
        assert_eq!(found.len(), 1);
        let Near { arms, normal, gap } = found[0];
        assert!((gap - 0.002).abs() < 1e-12 && (normal - at / 0.2).length() < 1e-12, "{found:?}");
        assert!((arms[0] - 0.5 * at).length() < 1e-12 && (arms[1] + 0.5 * at).length() < 1e-12);
    }

    #[test]
    fn a_block_stands_on_four_corners_of_another() {
        let (wide, small) = (DVec3::new(1.0, 1.0, 0.2), DVec3::new(0.2, 0.1, 0.1));
        let turned = DQuat::from_rotation_z(0.3);
        let found = near(&Block { size: wide }, &Block { size: small }, DVec3::new(0.1, 0.2, 0.15), turned);
        assert!(found.iter().all(|n| n.gap.abs() < 1e-12 && (n.normal - DVec3::Z).length() < 1e-12));
        // The library may add points between them, where it looked first.
        for (x, y) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            let corner = turned * (0.5 * small * DVec3::new(x, y, -1.0));
            assert!(found.iter().any(|near| (near.arms[1] - corner).length() < 1e-9), "{corner}: {found:?}");
        }
    }

    #[test]
    fn a_disc_stands_on_its_rim() {
        let disc = Disc { diameter: 0.4, thickness: 0.1 };
        let ground = Block { size: DVec3::new(2.0, 2.0, 0.2) };
        let turned = DQuat::from_rotation_y(0.7);
        let found = near(&ground, &disc, DVec3::new(0.0, 0.0, 0.3), turned);
        let ends: Vec<f64> = found.iter().map(|near| near.arms[1].y).collect();
        assert!(ends.iter().any(|y| *y > 0.049) && ends.iter().any(|y| *y < -0.049), "{found:?}");
        assert!(found.iter().all(|near| near.gap.abs() < 1e-7 && near.arms[1].x.abs() < 0.02), "{found:?}");
    }

    #[test]
    fn a_ball_lies_in_the_corner_of_a_scoop() {
        let part = |size: DVec3, position: DVec3| {
            let shape: std::sync::Arc<dyn Shape> = std::sync::Arc::new(Block { size });
            crate::Placed { shape, position, rotation: glam::DMat3::IDENTITY }
        };
        let floor = part(DVec3::new(0.4, 0.2, 0.04), DVec3::new(0.0, 0.0, -0.02));
        let back = part(DVec3::new(0.04, 0.2, 0.4), DVec3::new(-0.18, 0.0, 0.2));
        let scoop = crate::Compound::new(vec![floor, back]);
        // 1 mm from both.
        let at = DVec3::new(-0.109, 0.01, 0.051);
        let found = near(&scoop, &Sphere { diameter: 0.1 }, at, DQuat::IDENTITY);
        for normal in [DVec3::X, DVec3::Z] {
            let own: Vec<&Near> = found.iter().filter(|n| (n.normal - normal).length() < 1e-9).collect();
            assert!(!own.is_empty(), "{normal}: {found:?}");
            assert!(own.iter().all(|n| (n.gap - 1e-3).abs() < 1e-9), "{own:?}");
            assert!(own.iter().all(|n| (n.arms[1] + 0.05 * normal).length() < 1e-9), "{own:?}");
        }
        assert!(found.iter().all(|n| n.gap > 0.9e-3), "{found:?}");
    }

    /// The gap of a ball is known exactly, by its middle.
    #[test]
    fn solids_of_any_size_touch_balls_where_they_are() {
        for size in [1e-4, 0.1, 1.0, 1e3] {
            let block = Block { size: size * DVec3::new(0.4, 0.2, 0.1) };
            let disc = Disc { diameter: 0.4 * size, thickness: 0.05 * size };
            let shapes: [&dyn Shape; 2] = [&block, &disc];
            let ball = Sphere { diameter: 0.2 * size };
            for (shape, k) in shapes.into_iter().flat_map(|shape| (0..50).map(move |k| (shape, f64::from(k))))
            {
                let towards = DVec3::new(k.sin(), (2.0 * k).cos(), (0.7 * k).sin() + 0.3).normalize();
                let (mut low, mut high) = (0.0, size);
                for _ in 0..100 {
                    let middle = 0.5 * (low + high);
                    let is_far = shape.signed_distance(middle * towards) > 0.1005 * size;
                    if is_far { high = middle } else { low = middle }
                }
                let solids = Solids::of([shape, &ball]).expect("two solids");
                let attitude = DQuat::from_euler(glam::EulerRot::XYZ, k, 0.3 * k, 1.7 * k);
                let first = Place { position: DVec3::ZERO, attitude };
                let second = Place { position: attitude * (high * towards), attitude };
                let mut found = Vec::new();
                solids.near([&first, &second], 2e-3 * size, &mut found);
                assert_eq!(found.len(), 1, "{size} {shape:?}");
                assert!((found[0].gap / size - 5e-4).abs() < 1e-12, "{size} {shape:?}: {found:?}");
            }
        }
    }
}
