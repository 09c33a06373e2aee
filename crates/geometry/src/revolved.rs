//! Solids of revolution: discs with any rim, cones.

use super::edge::Edge;
use super::{
    Axis, MassProperties, Mesh, Profile, Shape, SurfacePoint, divisions, paired, ring, ring_count,
    ring_points,
};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A profile revolved about an axis of the body frame. Its u is the distance from the axis, its v the
/// coordinate along it.
#[derive(Clone, Debug, PartialEq)]
pub struct Revolved {
    profile: Profile,
    axis: Axis,
}

impl Revolved {
    /// The profile lies at u ≥ 0; one that is not closed begins and ends on the axis.
    #[must_use]
    pub fn new(profile: Profile, axis: Axis) -> Self {
        Self { profile, axis }
    }

    /// Rotates from the frame of the profile, whose axis is y, to the body frame.
    fn body_frame(&self, x: DVec3) -> DVec3 {
        match self.axis {
            Axis::X => DVec3::new(x.y, x.z, x.x),
            Axis::Y => x,
            Axis::Z => DVec3::new(x.z, x.x, x.y),
        }
    }

    /// Rotates from the body frame to that of the profile.
    fn profile_frame(&self, x: DVec3) -> DVec3 {
        match self.axis {
            Axis::X => DVec3::new(x.z, x.x, x.y),
            Axis::Y => x,
            Axis::Z => DVec3::new(x.y, x.z, x.x),
        }
    }

    /// Distance from the axis and coordinate along it.
    fn flat(&self, x: DVec3) -> DVec2 {
        let x = self.profile_frame(x);
        DVec2::new(x.x.hypot(x.z), x.y)
    }

    /// A vector of the profile at an angle round the axis, given by its cosine and sine, in the body frame.
    fn turned(&self, x: DVec2, [cos, sin]: [f64; 2]) -> DVec3 {
        self.body_frame(DVec3::new(x.x * cos, x.y, x.x * sin))
    }

    /// The edges to lay points on, and whether their mirror images in y are needed as well.
    fn laid_out(&self) -> (Vec<(Edge, [f64; 2])>, bool) {
        let half = if self.axis == Axis::Y { self.profile.lower_half() } else { None };
        half.map_or_else(
            || {
                let edges = self.profile.edges().iter().copied();
                (edges.zip(self.profile.corners()).collect(), false)
            },
            |half| (half, true),
        )
    }

    /// Rows of points round an edge.
    fn rows(&self, edge: Edge, corners: [f64; 2], spacing: DVec3, inset: DVec3) -> Rows {
        let spacing = self.profile_frame(spacing);
        let (along, around) = (spacing.y, spacing.x.min(spacing.z));
        // The width of a cell along the edge, the least anywhere on it.
        let width = |fraction: f64| {
            let tangent = edge.tangent(fraction);
            1.0 / (tangent.x / around).hypot(tangent.y / along)
        };
        let width = [0.0, 0.5, 1.0].into_iter().map(width).fold(f64::INFINITY, f64::min);
        let mut rows = Rows { edge, corners, inset, spacing: around, count: 0.0, ends: [0.0; 2] };
        // Directions between the axes have insets between theirs.
        let directions = [[1.0, 0.0], [0.0, 1.0]];
        let [one, other] = directions.map(|direction| self.ends(&rows, direction));
        rows.ends = [one[0].min(other[0]), one[1].max(other[1])];
        if rows.ends[0] < rows.ends[1] && directions.map(|direction| self.share(&rows, direction)) != [0.0; 2]
        {
            rows.count = divisions(edge.length() * (rows.ends[1] - rows.ends[0]), width);
        }
        rows
    }

    /// Fractions of an edge's length between which its points lie, in a direction round the axis.
    fn ends(&self, rows: &Rows, direction: [f64; 2]) -> [f64; 2] {
        let inset = |end: usize| {
            let tangent = self.turned(rows.edge.tangent(end as f64), direction);
            ((rows.inset * tangent).length() - rows.corners[end]).max(0.0) / rows.edge.length()
        };
        [inset(0), 1.0 - inset(1)]
    }

    /// Portion of the area of an edge that it keeps, in a direction round the axis: an arc that rounds a
    /// corner within the inset is part of the corner, and one with twice the inset, about a cell, for its
    /// radius is a surface of its own.
    fn share(&self, rows: &Rows, direction: [f64; 2]) -> f64 {
        rows.edge.rounding().map_or(1.0, |(radius, _)| {
            let inset = (rows.inset * self.turned(rows.edge.tangent(0.5), direction)).length();
            if radius >= 2.0 * inset { 1.0 } else { (radius / inset - 1.0).max(0.0) }
        })
    }
}

/// Rows of contact points round an edge.
struct Rows {
    edge: Edge,
    /// How far the sharp convex corners before and after the edge are from its ends [m].
    corners: [f64; 2],
    /// Inset from a sharp corner along the axes of the body [m].
    inset: DVec3,
    /// Spacing of the points of a row [m].
    spacing: f64,
    /// Number of rows.
    count: f64,
    /// Fractions of the edge's length between which they lie, in the direction in which most of the edge is
    /// left.
    ends: [f64; 2],
}

impl Rows {
    /// Radius of a row [m].
    fn radius(&self, n: f64) -> f64 {
        let [from, to] = self.ends;
        self.edge.at(from + (to - from) * (n + 0.5) / self.count).x
    }
}

impl Shape for Revolved {
    fn signed_distance(&self, x: DVec3) -> f64 {
        self.profile.signed_distance(self.flat(x))
    }

    fn extent(&self, direction: DVec3) -> f64 {
        self.profile.support(self.flat(direction))
    }

    /// Mass properties by Pappus' theorem and its extension to higher moments.
    fn mass_properties(&self) -> MassProperties {
        let volume = self.profile.integral(|x| x.x.powi(2) / 2.0);
        let along = self.profile.integral(|x| x.x.powi(2) / 2.0 * x.y) / volume;
        let along_squared = self.profile.integral(|x| x.x.powi(2) / 2.0 * x.y.powi(2)) / volume;
        let radius_squared = self.profile.integral(|x| x.x.powi(4) / 4.0) / volume;
        let across = 0.5 * radius_squared + along_squared - along.powi(2);
        let inertia = self.body_frame(DVec3::new(across, radius_squared, across));
        MassProperties {
            centroid: self.body_frame(DVec3::Y * along),
            ..MassProperties::principal(TAU * volume, inertia)
        }
    }

    /// Rings round the axis, each of which represents the exact area of its zone. Symmetric in the planes
    /// through the axis.
    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        let (edges, is_half) = self.laid_out();
        let mut points = Vec::new();
        for (edge, corners) in edges {
            let rows = self.rows(edge, corners, spacing, inset);
            let first = points.len();
            for n in 0..rows.count as usize {
                let directions = ring(TAU * rows.radius(n as f64), rows.spacing);
                let share = TAU / directions.len() as f64;
                points.extend(directions.iter().filter_map(|direction| {
                    let ([from, to], kept) = (self.ends(&rows, *direction), self.share(&rows, *direction));
                    let at = |row: f64| from + (to - from) * row / rows.count;
                    let (low, middle, high) = (at(n as f64), at(n as f64 + 0.5), at(n as f64 + 1.0));
                    (from < to && kept > 0.0).then(|| SurfacePoint {
                        position: self.turned(rows.edge.at(middle), *direction),
                        normal: self.turned(rows.edge.normal(middle), *direction),
                        area: kept * share * rows.edge.swept(low, high),
                        represents: 0.0,
                    })
                }));
            }
            let own = &mut points[first..];
            let sampled: f64 = own.iter().map(|p| p.area).sum();
            own.iter_mut().for_each(|p| p.represents = p.area * TAU * rows.edge.swept(0.0, 1.0) / sampled);
        }
        if is_half {
            let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
            let image =
                |p: &SurfacePoint| SurfacePoint { position: flip(p.position), normal: flip(p.normal), ..*p };
            let images: Vec<SurfacePoint> = points.iter().map(image).collect();
            points.extend(images);
        }
        paired(points)
    }

    fn surface_point_count(&self, spacing: DVec3, inset: DVec3) -> f64 {
        let (edges, is_half) = self.laid_out();
        let points = |(edge, corners): (Edge, [f64; 2])| {
            let rows = self.rows(edge, corners, spacing, inset);
            let area = TAU * rows.edge.swept(0.0, 1.0) / rows.spacing.powi(2);
            let around = |length: f64| ring_count(length, rows.spacing);
            ring_points(rows.count, |n| rows.radius(n), around, area)
        };
        let sum: f64 = edges.into_iter().map(points).sum();
        if is_half { 2.0 * sum } else { sum }
    }

    fn is_revolved(&self) -> bool {
        self.axis == Axis::Y
    }

    fn mesh(&self) -> Mesh {
        const SEGMENTS: u32 = 96;
        let profile = self.profile.points();
        let is_pole = |x: &DVec2| x.x == 0.0;
        let mut mesh = Mesh::default();
        // Number of the first point of each ring.
        let mut rings = Vec::with_capacity(profile.len());
        for x in &profile {
            rings.push(mesh.points.len() as u32);
            for n in 0..if is_pole(x) { 1 } else { SEGMENTS } {
                let (sin, cos) = (TAU * f64::from(n) / f64::from(SEGMENTS)).sin_cos();
                mesh.points.push(self.turned(*x, [sin, cos]));
            }
        }
        let is_ring = !is_pole(&profile[0]);
        for n in 0..if is_ring { profile.len() } else { profile.len() - 1 } {
            let next = (n + 1) % profile.len();
            let at =
                |ring: usize, n: u32| rings[ring] + if is_pole(&profile[ring]) { 0 } else { n % SEGMENTS };
            for k in 0..SEGMENTS {
                let [a, b, c, d] = [at(n, k), at(n, k + 1), at(next, k), at(next, k + 1)];
                if a != b {
                    mesh.triangles.push([a, b, c]);
                }
                if c != d {
                    mesh.triangles.push([b, d, c]);
                }
            }
        }
        mesh
    }
}
