//! Shapes of rigid bodies: signed distance, mass properties, contact points, triangle mesh; and the relief of
//! the ground.
//!
//! A shape is given in the body frame: origin at the body's reference point (for a disc the centre of the
//! axle), the axle along `y`. Lengths in metres.

mod block;
mod compound;
mod cylinder;
mod disc;
mod edge;
mod edges;
mod extruded;
mod facets;
mod frame;
mod hierarchy;
mod mass;
mod mesh;
mod outlines;
mod point;
mod polyhedron;
mod profile;
pub mod relief;
mod repair;
mod revolved;
mod rim;
mod rotated;
mod sampler;
mod sphere;
mod thickness;
mod touch;
mod triangle;

pub use block::Block;
pub use compound::{Compound, Placed};
pub use cylinder::{Axis, Cylinder};
pub use disc::Disc;
pub use extruded::Extruded;
pub use frame::Frame;
pub use mass::MassProperties;
pub use mesh::Mesh;
pub use outlines::{Bevel, DiscRim, Dish, Grousers, blade, cone, disc, wedge, wheel};
pub use point::SurfacePoint;
pub use polyhedron::Polyhedron;
pub use profile::Profile;
pub use repair::{Defect, Mend, MendKind, Repaired, repaired};
pub use revolved::Revolved;
pub use rim::{Rim, RimPoint};
pub use rotated::Rotated;
pub use sphere::Sphere;
pub use thickness::{Thin, ThinSearch};
pub use touch::{Near, Place, Solids};

use glam::{DMat3, DVec3};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Midpoint of division `n` of `count` equal divisions of the interval −½ to ½; those of opposite divisions
/// are opposite to the bit.
fn midpoint(n: usize, count: f64) -> f64 {
    (2.0 * n as f64 + 1.0 - count) / (2.0 * count)
}

/// Directions around a circle of this circumference, at most `spacing` apart [m]. A quadrant is laid out and
/// reflected, so the ring is symmetric about both axes to the bit, and no direction lies on an axis.
fn ring(circumference: f64, spacing: f64) -> Vec<[f64; 2]> {
    let quarter = divisions(0.25 * circumference, spacing);
    let mut directions = Vec::with_capacity(4 * quarter as usize);
    for n in 0..quarter as usize {
        let (sin, cos) = (FRAC_PI_2 * (n as f64 + 0.5) / quarter).sin_cos();
        directions.extend([[cos, sin], [cos, -sin], [-cos, sin], [-cos, -sin]]);
    }
    directions
}

/// Number of equal divisions of a length, none longer than `spacing`; rounding errors add no further
/// division.
fn divisions(length: f64, spacing: f64) -> f64 {
    (length / spacing * (1.0 - 1e-9)).ceil().max(1.0)
}

/// Divisions of a length into parts of at most this spacing, an even number: points on a middle plane, where
/// two cells may meet, would be assigned to one of them.
fn even_divisions(length: f64, spacing: f64) -> f64 {
    2.0 * divisions(0.5 * length, spacing)
}

/// Number of points in rings of the given radii, each with `around` of its circumference points; for more
/// rings than could be laid out it is estimated as `area`.
fn ring_points(rings: f64, radius: impl Fn(f64) -> f64, around: impl Fn(f64) -> f64, area: f64) -> f64 {
    const MOST_RINGS: f64 = 1e5;
    if rings > MOST_RINGS {
        return area;
    }
    (0..rings as usize).map(|n| around(TAU * radius(n as f64))).sum()
}

/// Number of directions of a [`ring`].
fn ring_count(circumference: f64, spacing: f64) -> f64 {
    4.0 * divisions(0.25 * circumference, spacing)
}

/// The inset from the rim of a flat round end, whose axis is y: half the widths of an ellipse.
#[derive(Clone, Copy)]
struct RimInset {
    /// Along x [m].
    along_x: f64,
    /// Square of that along z over that along x, less 1; exactly 0 where they differ by no more than
    /// rounding.
    elongation: f64,
}

impl RimInset {
    fn new(inset: DVec3) -> Self {
        const ROUNDING: f64 = 1e-9;
        let elongation = if inset.x > 0.0 { (inset.z / inset.x).powi(2) - 1.0 } else { 0.0 };
        Self { along_x: inset.x, elongation: if elongation.abs() > ROUNDING { elongation } else { 0.0 } }
    }

    /// The inset in a direction whose cosine with z is `cos` [m].
    fn towards(&self, cos: f64) -> f64 {
        self.along_x * (1.0 + self.elongation * cos * cos).sqrt()
    }

    /// The least inset in any direction [m].
    fn least(&self) -> f64 {
        self.towards(0.0).min(self.towards(1.0))
    }
}

/// Orders the points so that mirror images in y are adjacent, in the order of the first of each pair.
fn paired(points: Vec<SurfacePoint>) -> Vec<SurfacePoint> {
    let key = |p: &SurfacePoint, side: f64| {
        [p.position.x, side * p.position.y, p.position.z, p.normal.x, side * p.normal.y, p.normal.z]
            .map(|x| (x + 0.0).to_bits())
    };
    let mut index: BTreeMap<_, usize> = points.iter().enumerate().map(|(n, p)| (key(p, 1.0), n)).collect();
    let mut ordered = Vec::with_capacity(points.len());
    for point in &points {
        if index.remove(&key(point, 1.0)).is_some() {
            ordered.push(*point);
            if let Some(partner) = index.remove(&key(point, -1.0)) {
                ordered.push(points[partner]);
            }
        }
    }
    ordered
}

/// Pairs points about the plane y = `middle` [m], for points that are mirror images up to round-off.
fn paired_about(points: Vec<SurfacePoint>, middle: f64) -> Vec<SurfacePoint> {
    const ROUND_OFF: f64 = 1e-9;
    let size = points.iter().map(|p| p.position.length()).fold(0.0, f64::max);
    let rounded = |x: f64| (x / (ROUND_OFF * size)).round() as i64;
    let key = |p: &SurfacePoint, side: f64| {
        let across = [side * (p.position.y - middle), size * side * p.normal.y];
        let along = [p.position.x, p.position.z, size * p.normal.x, size * p.normal.z];
        (across.map(rounded), along.map(rounded))
    };
    let mut index: BTreeMap<_, usize> = points.iter().enumerate().map(|(n, p)| (key(p, 1.0), n)).collect();
    let mut is_placed = vec![false; points.len()];
    let mut ordered = Vec::with_capacity(points.len());
    for (n, point) in points.iter().enumerate() {
        if !std::mem::replace(&mut is_placed[n], true) {
            ordered.push(*point);
            if let Some(partner) = index.remove(&key(point, -1.0)).filter(|partner| !is_placed[*partner]) {
                is_placed[partner] = true;
                ordered.push(points[partner]);
            }
        }
    }
    ordered
}

/// An inset [m] along the axes of space, along those of a frame that `rotation` takes to space: half an
/// ellipsoid's widths.
#[must_use]
pub fn inset_in_frame(inset: DVec3, rotation: DMat3) -> DVec3 {
    DVec3::from_array([rotation.x_axis, rotation.y_axis, rotation.z_axis].map(|axis| (inset * axis).length()))
}

/// The shape of a rigid body: its signed distance and its mesh; the rest follows from these, unless the shape
/// knows better.
pub trait Shape: Send + Sync + std::fmt::Debug {
    /// Signed distance [m] from `x` (body frame) [m] to the surface; negative inside.
    fn signed_distance(&self, x: DVec3) -> f64;
    /// Lower and upper corner of the bounding box, in the body frame [m].
    fn bounds(&self) -> (DVec3, DVec3) {
        let along = |axis: DVec3| self.extent(axis);
        let high = DVec3::AXES.map(along);
        let low = DVec3::AXES.map(|axis| -along(-axis));
        (low.into(), high.into())
    }
    /// Boxes in the body frame that together enclose it: low and high corners [m].
    fn boxes(&self) -> Vec<(DVec3, DVec3)> {
        vec![self.bounds()]
    }
    /// Largest coordinate of the surface along a unit vector, in the body frame [m]: the support function.
    fn extent(&self, direction: DVec3) -> f64 {
        self.mesh().points.iter().map(|x| direction.dot(*x)).fold(f64::NEG_INFINITY, f64::max)
    }
    /// Volume, centroid and moments of inertia of a homogeneous solid; from the mesh unless the shape knows
    /// better.
    fn mass_properties(&self) -> MassProperties {
        MassProperties::of_mesh(&self.mesh())
    }
    /// Contact points about `spacing` [m] apart, at the distance `inset` [m] from sharp convex edges, both
    /// along x, y, z; from the mesh and the signed distance, and the least spacing, unless the shape lays
    /// them out itself.
    ///
    /// Points at a sharp edge would widen the body by half a cell, which the inset compensates. Points that
    /// are mirror images in y are adjacent, so that contact treats them symmetrically.
    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        sampler::sample(&self.mesh(), |x| self.signed_distance(x), spacing.min_element(), inset)
    }
    /// Number of points of [`Shape::surface_points`], without laying them out; a float, since it may be huge.
    /// An estimate where they come from the mesh.
    fn surface_point_count(&self, spacing: DVec3, _inset: DVec3) -> f64 {
        sampler::count(&self.mesh(), spacing.min_element())
    }
    /// Fraction of a small cube round `x` that it covers, for a cube of this width [m]; from the distance.
    fn coverage(&self, x: DVec3, width: f64) -> f64 {
        (0.5 - self.signed_distance(x) / width).clamp(0.0, 1.0)
    }
    /// Diameter and thickness [m], if it is a flat disc with sharp rims.
    fn as_disc(&self) -> Option<[f64; 2]> {
        None
    }
    /// Radius [m], if it is a ball.
    fn as_ball(&self) -> Option<f64> {
        None
    }
    /// The plane across the axle [m] about which contact points may be mirror images of each other.
    fn mid_plane(&self) -> f64 {
        0.0
    }
    /// Number of parts for which forces are accounted separately.
    fn parts(&self) -> usize {
        1
    }
    /// The part to which a point of the surface belongs.
    fn part_of(&self, _x: DVec3) -> usize {
        0
    }
    /// Whether the shape has a surface.
    fn has_surface(&self) -> bool {
        true
    }
    /// Whether the shape is rotationally symmetric about the axle; its contact points then need not rotate
    /// with it.
    fn is_revolved(&self) -> bool {
        false
    }
    /// A closed triangle mesh of the surface, whose triangles share their points.
    fn mesh(&self) -> Mesh;
}
