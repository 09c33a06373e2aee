//! The rim of a body: its surface as seen along the axle, in bins along the outline. What faces along the
//! axle instead are its flanks.
//!
//! The outline is the circle of a shape that is symmetric about the axle, and the convex hull of any other.
//! Arcs along it begin straight below the reference point and grow forwards (x) there, so that front, top and
//! back follow.

use super::{Shape, divisions};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Largest number of bins, about one per degree (chosen: sums of bins are kept over time).
const MOST_BINS: f64 = 360.0;
/// Cosine of the turn of the outline, 30°, above which a corner separates two bins (chosen).
const CORNER: f64 = 0.866;

/// A point of the outline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RimPoint {
    /// Polar angle about the axle [rad]: 0 straight below, positive towards the front, −π to π.
    pub angle: f64,
    /// Distance along the outline from straight below [m], positive towards the front.
    pub arc: f64,
    /// Coordinate along x in the body frame [m].
    pub x: f64,
    /// Coordinate along z in the body frame [m].
    pub z: f64,
}

/// The rim of a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Rim {
    outline: Outline,
    /// Arcs at which bins begin, and at which the last one ends [m].
    ends: Vec<f64>,
}

#[derive(Clone, Debug, PartialEq)]
enum Outline {
    Circle { radius: f64 },
    Polygon(Polygon),
}

impl Rim {
    /// The rim of a shape in bins that are at most `width` [m] wide, unless there would be more than 360 of
    /// them. No bin extends round a corner or over straight below.
    #[must_use]
    pub fn of(shape: &dyn Shape, width: f64) -> Self {
        let outline = if shape.is_revolved() {
            Outline::Circle { radius: shape.extent(DVec3::X) }
        } else {
            let flat = shape.mesh().points.iter().map(|p| DVec2::new(p.x, p.z)).collect();
            Outline::Polygon(Polygon::around(hull(flat)))
        };
        let half = 0.5 * outline.length();
        let mut breaks = vec![-half, 0.0, half];
        breaks.extend(outline.corners());
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * half);
        let width = width.max(2.0 * half / MOST_BINS);
        let mut ends = vec![-half];
        for pair in breaks.windows(2) {
            let (from, count) = (pair[0], divisions(pair[1] - pair[0], width));
            ends.extend((1..=count as usize).map(|n| from + (pair[1] - from) * n as f64 / count));
        }
        Self { outline, ends }
    }

    /// The middles of the bins, in the order of their arcs.
    #[must_use]
    pub fn middles(&self) -> Vec<RimPoint> {
        self.ends.windows(2).map(|ends| self.at(0.5 * (ends[0] + ends[1]))).collect()
    }

    /// The point of the outline at an arc [m].
    #[must_use]
    pub fn at(&self, arc: f64) -> RimPoint {
        let at = self.outline.at(arc);
        RimPoint { angle: polar_angle(at), arc, x: at.x, z: at.y }
    }

    /// The bin of a point of the surface with this outward unit normal, in the body frame [m], and its
    /// arc [m]; none on a flank, where the normal is nearer to the axle than to the plane across it.
    #[must_use]
    pub fn bin_of(&self, position: DVec3, normal: DVec3) -> Option<(usize, f64)> {
        let (flat, across) = (DVec2::new(normal.x, normal.z), normal.y.abs());
        if across > flat.length() {
            return None;
        }
        let arc = self.outline.arc_of(DVec2::new(position.x, position.z), flat);
        let last = self.ends.len() - 2;
        Some((self.ends.partition_point(|end| *end <= arc).saturating_sub(1).min(last), arc))
    }
}

/// Angle of a point (x, z) from straight below, positive towards x [rad].
fn polar_angle(at: DVec2) -> f64 {
    at.x.atan2(-at.y)
}

impl Outline {
    fn length(&self) -> f64 {
        match self {
            Self::Circle { radius } => 2.0 * PI * radius,
            Self::Polygon(polygon) => polygon.length,
        }
    }

    /// Arcs of the corners of the outline [m].
    fn corners(&self) -> Vec<f64> {
        match self {
            Self::Circle { .. } => Vec::new(),
            Self::Polygon(polygon) => polygon.corners(),
        }
    }

    /// The point at an arc, as (x, z) [m].
    fn at(&self, arc: f64) -> DVec2 {
        match self {
            Self::Circle { radius } => {
                // A body without a surface has no radius.
                let (sin, cos) = (arc / radius.max(f64::MIN_POSITIVE)).sin_cos();
                *radius * DVec2::new(sin, -cos)
            }
            Self::Polygon(polygon) => polygon.at(arc),
        }
    }

    /// The arc of a point of the surface with this normal [m].
    fn arc_of(&self, at: DVec2, normal: DVec2) -> f64 {
        match self {
            Self::Circle { radius } => radius * polar_angle(at),
            Self::Polygon(polygon) => polygon.arc_of(at, normal),
        }
    }
}

/// A closed convex outline, counter-clockwise with x to the right and z upwards.
#[derive(Clone, Debug, PartialEq)]
struct Polygon {
    /// Corners (x, z) [m].
    points: Vec<DVec2>,
    /// Distance of each from the first along the outline [m].
    along: Vec<f64>,
    /// Distance along the outline of the point straight below the origin, or of the lowest one where there is
    /// none [m].
    below: f64,
    length: f64,
}

impl Polygon {
    fn around(points: Vec<DVec2>) -> Self {
        let mut polygon = Self { along: Vec::new(), below: 0.0, length: 0.0, points };
        for n in 0..polygon.points.len() {
            let [from, to] = polygon.side(n);
            polygon.along.push(polygon.length);
            polygon.length += from.distance(to);
        }
        let sides = || (0..polygon.points.len()).map(|n| (n, polygon.side(n)));
        let crossing = sides().find(|(_, [from, to])| from.x <= 0.0 && to.x > 0.0);
        let lowest = || sides().min_by(|a, b| a.1[0].y.total_cmp(&b.1[0].y));
        polygon.below = crossing.map_or_else(
            || lowest().map_or(0.0, |(n, _)| polygon.along[n]),
            |(n, [from, to])| polygon.along[n] + from.distance(to) * from.x / (from.x - to.x),
        );
        polygon
    }

    /// The ends of a side.
    fn side(&self, n: usize) -> [DVec2; 2] {
        [self.points[n], self.points[(n + 1) % self.points.len()]]
    }

    /// Distance along the outline from the first corner to an arc: −length/2 to length/2.
    fn arc(&self, along: f64) -> f64 {
        (along - self.below + 0.5 * self.length).rem_euclid(self.length) - 0.5 * self.length
    }

    fn corners(&self) -> Vec<f64> {
        let direction = |n: usize| {
            let [from, to] = self.side(n);
            (to - from).normalize_or_zero()
        };
        let count = self.points.len();
        let turns = |n: &usize| direction(*n).dot(direction((n + count - 1) % count)) < CORNER;
        (0..count).filter(turns).map(|n| self.arc(self.along[n])).collect()
    }

    fn at(&self, arc: f64) -> DVec2 {
        let along = (arc + self.below).rem_euclid(self.length);
        let n = self.along.partition_point(|begin| *begin <= along).saturating_sub(1);
        let [from, to] = self.side(n);
        from + (to - from).normalize_or_zero() * (along - self.along[n])
    }

    /// Where the normal through a point of the surface leaves the outline; a point of the surface may lie
    /// deeper than the outline, as on the round side of a cylinder whose axis lies across the axle. At a
    /// corner the normal decides.
    fn arc_of(&self, at: DVec2, normal: DVec2) -> f64 {
        /// Least cosine between the normals of the surface and of a side on which it may lie.
        const ALIKE: f64 = 0.1;
        let normal = normal.normalize_or_zero();
        let (mut nearest, mut along) = (f64::INFINITY, self.below);
        for n in 0..self.points.len() {
            let [from, to] = self.side(n);
            let (side, length) = ((to - from).normalize_or_zero(), from.distance(to));
            let outward = DVec2::new(side.y, -side.x);
            let cosine = normal.dot(outward);
            let distance = outward.dot(from - at) / cosine;
            if cosine > ALIKE && distance < nearest {
                // Not to the very end, where the next side begins.
                let leaves =
                    (at + distance * normal - from).dot(side).clamp(1e-9 * length, (1.0 - 1e-9) * length);
                (nearest, along) = (distance, self.along[n] + leaves);
            }
        }
        self.arc(along)
    }
}

/// The convex hull of points, counter-clockwise (Andrew's monotone chain).
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let size = points.iter().fold(0.0, |size: f64, p| size.max(p.length()));
    let half = |points: &mut dyn Iterator<Item = &DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                if (b - a).perp_dot(*point - b) > 1e-12 * size * size {
                    break;
                }
                chain.pop();
            }
            chain.push(*point);
        }
        chain.pop();
        chain
    };
    let mut all = half(&mut points.iter());
    all.extend(half(&mut points.iter().rev()));
    all
}

#[cfg(test)]
mod tests {
    use super::super::{Axis, Block, Cylinder, Disc, Rotated, Sphere};
    use super::*;

    #[test]
    fn bins_of_a_disc_are_equal_sectors_that_begin_straight_below() {
        let disc = Disc { diameter: 0.2, thickness: 0.05 };
        let rim = Rim::of(&disc, 0.00625);
        let middles = rim.middles();
        assert_eq!(middles.len(), 102);
        let first = &middles[51];
        assert!((first.angle - PI / 102.0).abs() < 1e-12 && (first.arc - 0.1 * first.angle).abs() < 1e-12);
        assert!(first.x > 0.0 && first.z < 0.0);
        let bin_of = |position, normal| rim.bin_of(position, normal).map(|(bin, _)| bin);
        assert_eq!(bin_of(DVec3::new(0.05, 0.01, 0.0), DVec3::X), Some(76));
        assert_eq!(bin_of(DVec3::new(0.05, 0.025, 0.0), DVec3::Y), None);
    }

    #[test]
    fn bins_of_a_block_end_at_its_corners() {
        let block = Block { size: DVec3::new(0.4, 0.1, 0.2) };
        for angle in [0.0, 0.3, -std::f64::consts::FRAC_PI_4, 1.2] {
            let rim = Rim::of(&Rotated::new(Box::new(block), angle), 0.03);
            let corners = rim.outline.corners();
            assert_eq!(corners.len(), 4);
            assert!(corners.iter().all(|c| rim.ends.iter().any(|end| (end - c).abs() < 1e-9)), "{angle}");
            assert!((rim.outline.length() - 1.2).abs() < 1e-12);
        }
        // From straight below to the front, up, and backwards over the top.
        let rim = Rim::of(&block, 1.0);
        let expected = [[-0.1, 0.1], [-0.2, 0.0], [-0.1, -0.1], [0.1, -0.1], [0.2, 0.0], [0.1, 0.1]];
        for (middle, [x, z]) in rim.middles().iter().zip(expected) {
            assert!((middle.x - x).abs() < 1e-12 && (middle.z - z).abs() < 1e-12, "{middle:?}");
        }
        // A point at the edge belongs to the side that its normal says.
        let corner = DVec3::new(0.2, 0.0, -0.1);
        assert_eq!([-DVec3::Z, DVec3::X].map(|n| rim.bin_of(corner, n).unwrap().0), [3, 4]);
    }

    #[test]
    fn the_contact_points_of_every_shape_lie_in_their_bins() {
        let shapes: [Box<dyn Shape>; 6] = [
            Box::new(Disc { diameter: 0.2, thickness: 0.05 }),
            Box::new(Sphere { diameter: 0.2 }),
            Box::new(Cylinder { diameter: 0.1, length: 0.3, axis: Axis::X }),
            Box::new(Cylinder { diameter: 0.1, length: 0.3, axis: Axis::Z }),
            Box::new(Rotated::new(Box::new(Block { size: DVec3::new(0.3, 0.1, 0.02) }), 0.6)),
            Box::new(Block { size: DVec3::new(0.3, 0.1, 1e-9) }),
        ];
        for shape in shapes {
            let rim = Rim::of(shape.as_ref(), 0.01);
            let middles = rim.middles();
            let points = shape.surface_points(DVec3::splat(0.004), DVec3::splat(0.002));
            let mut on_rim = 0;
            for p in &points {
                let Some((bin, arc)) = rim.bin_of(p.position, p.normal) else { continue };
                let ends = [rim.ends[bin], rim.ends[bin + 1]].map(|end| end - arc);
                assert!(ends[0] < 1e-9 && ends[1] > -1e-9, "{shape:?}, {p:?}");
                on_rim += 1;
                // Along the outline; towards the axle a point may lie deeper.
                let along = DVec3::new(-p.normal.z, 0.0, p.normal.x).normalize();
                let to_middle = DVec3::new(middles[bin].x, 0.0, middles[bin].z) - p.position;
                assert!(to_middle.dot(along).abs() < 0.006, "{shape:?}, {p:?}, {:?}", middles[bin]);
            }
            assert!(on_rim > points.len() / 8, "{shape:?}");
        }
    }
}
