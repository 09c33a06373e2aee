//! Rigid shapes: signed distance, surface points for contact, a mesh to look at.
//!
//! A shape lives in its own frame: origin at the body's reference point (for a disc the centre of the axle), the axle
//! along `y`. Lengths in metres.

mod ball;
mod block;
mod cylinder;
mod disc;
mod turned;

pub use ball::Ball;
pub use block::Block;
pub use cylinder::{Axis, Cylinder};
pub use disc::Disc;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};
pub use turned::Turned;

/// A point of the surface at which contact is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Position in the body frame [m].
    pub position: DVec3,
    /// Unit normal pointing out of the body, into the soil.
    pub normal: DVec3,
    /// Area that the point stands for [m²].
    pub area: f64,
}

/// Middle of part `n` of `count` equal parts of the length from −½ to ½; the middles of opposite parts are opposite to
/// the bit.
fn middle(n: usize, count: f64) -> f64 {
    (2.0 * n as f64 + 1.0 - count) / (2.0 * count)
}

/// Directions round a circle of this circumference, at most `spacing` apart [m]. A quarter is laid out and reflected, so
/// that the ring is its own mirror image across both axes to the bit, and no direction lies on an axis.
fn ring(circumference: f64, spacing: f64) -> Vec<[f64; 2]> {
    let quarter = parts(0.25 * circumference, spacing);
    let mut directions = Vec::with_capacity(4 * quarter as usize);
    for n in 0..quarter as usize {
        let (sin, cos) = (FRAC_PI_2 * (n as f64 + 0.5) / quarter).sin_cos();
        directions.extend([[cos, sin], [cos, -sin], [-cos, sin], [-cos, -sin]]);
    }
    directions
}

/// Number of equal parts, none longer than `spacing`, of a length; rounding makes no further part.
fn parts(length: f64, spacing: f64) -> f64 {
    (length / spacing * (1.0 - 1e-9)).ceil().max(1.0)
}

/// Number of points in rings of the given radii, each laid out by `around`; beyond what could ever be laid out the area tells.
fn ring_points(rings: f64, radius: impl Fn(f64) -> f64, around: impl Fn(f64) -> f64, area: f64) -> f64 {
    const MOST_RINGS: f64 = 1e5;
    if rings > MOST_RINGS {
        return area;
    }
    (0..rings as usize).map(|n| around(TAU * radius(n as f64))).sum()
}

/// Number of directions of a [`ring`].
fn ring_count(circumference: f64, spacing: f64) -> f64 {
    4.0 * parts(0.25 * circumference, spacing)
}

/// Puts points that are each other's mirror image in y side by side, in the order of the first of each pair.
fn paired(points: Vec<SurfacePoint>) -> Vec<SurfacePoint> {
    let key = |p: &SurfacePoint, side: f64| {
        [p.position.x, side * p.position.y, p.position.z, p.normal.x, side * p.normal.y, p.normal.z]
            .map(|x| (x + 0.0).to_bits())
    };
    let mut place: BTreeMap<_, usize> = points.iter().enumerate().map(|(n, p)| (key(p, 1.0), n)).collect();
    let mut ordered = Vec::with_capacity(points.len());
    for point in &points {
        if place.remove(&key(point, 1.0)).is_some() {
            ordered.push(*point);
            if let Some(partner) = place.remove(&key(point, -1.0)) {
                ordered.push(points[partner]);
            }
        }
    }
    ordered
}

/// Triangles to draw a body with.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners in the body frame [m].
    pub points: Vec<DVec3>,
    /// Corner indices of each triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// What every rigid shape can tell about itself.
pub trait Shape: Send + Sync + std::fmt::Debug {
    /// Signed distance from `x` (body frame) to the surface [m]; negative inside.
    fn signed_distance(&self, x: DVec3) -> f64;
    /// Corners of the box round the shape, in the body frame [m].
    fn bounds(&self) -> (DVec3, DVec3);
    /// Volume [m³].
    fn volume(&self) -> f64;
    /// Moment of inertia about the axle (body `y`) of a solid of unit mass [m²].
    fn axle_inertia_per_mass(&self) -> f64;
    /// Contact points with a spacing of at most `spacing` [m], kept `inset` [m] (along x, y, z) away from sharp convex
    /// edges.
    ///
    /// The inset takes away the cell's half width by which a row of points at a sharp edge makes the body too wide.
    /// Points that are each other's mirror image in y stand side by side, so that contact can treat them alike.
    fn surface_points(&self, spacing: f64, inset: DVec3) -> Vec<SurfacePoint>;
    /// Number of points that [`Shape::surface_points`] lays out, found without laying them out; a float, since it may be
    /// beyond all bounds.
    fn surface_point_count(&self, spacing: f64, inset: DVec3) -> f64;
    /// Whether a turn about the axle leaves the shape as it is; its contact points then need not turn with it.
    fn is_revolved(&self) -> bool;
    /// A closed triangle mesh of the surface.
    fn mesh(&self) -> Mesh;
}
