//! The cylinder: with sharp rims and its axis along x, y or z, such as a pile, a pipe or a circular footing.

use super::{
    Disc, MassProperties, Mesh, RimInset, Shape, SurfacePoint, divisions, even_divisions, midpoint, paired,
    ring, ring_count, ring_points,
};
use glam::DVec3;
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Direction of a cylinder's axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// The axis lies in the tow direction.
    X,
    /// Horizontal, perpendicular to the tow, like a disc's axle.
    Y,
    /// Vertical.
    Z,
}

impl std::fmt::Display for Axis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        })
    }
}

/// A cylinder centred on the origin: a disc with another axis, and with contact points that are symmetric
/// about both planes through the axis, so that half or a quarter of it can be modelled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Diameter [m].
    pub diameter: f64,
    /// Length along the axis [m].
    pub length: f64,
    /// Direction of the axis.
    pub axis: Axis,
}

impl Cylinder {
    fn disc(&self) -> Disc {
        Disc { diameter: self.diameter, thickness: self.length }
    }

    /// Rotates from the body frame to that of the disc, whose axle is y.
    fn disc_frame(self, x: DVec3) -> DVec3 {
        match self.axis {
            Axis::X => DVec3::new(x.z, x.x, x.y),
            Axis::Y => x,
            Axis::Z => DVec3::new(x.y, x.z, x.x),
        }
    }

    /// Spacing of the contact points along the axis and round it [m].
    fn spacing(self, spacing: DVec3) -> [f64; 2] {
        let spacing = self.disc_frame(spacing);
        [spacing.y, spacing.x.min(spacing.z)]
    }

    /// Rotates from the frame of the disc to the body frame.
    fn body_frame(self, x: DVec3) -> DVec3 {
        match self.axis {
            Axis::X => DVec3::new(x.y, x.z, x.x),
            Axis::Y => x,
            Axis::Z => DVec3::new(x.z, x.x, x.y),
        }
    }

    fn point(self, position: DVec3, normal: DVec3, [area, represents]: [f64; 2]) -> SurfacePoint {
        let (position, normal) = (self.body_frame(position), self.body_frame(normal));
        SurfacePoint { position, normal, area, represents }
    }
}

impl Shape for Cylinder {
    fn signed_distance(&self, x: DVec3) -> f64 {
        self.disc().signed_distance(self.disc_frame(x))
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let (low, high) = self.disc().bounds();
        (self.body_frame(low), self.body_frame(high))
    }

    fn extent(&self, direction: DVec3) -> f64 {
        self.disc().extent(self.disc_frame(direction))
    }

    fn mass_properties(&self) -> MassProperties {
        let MassProperties { volume, inertia, .. } = self.disc().mass_properties();
        let inertia = DVec3::new(inertia.x_axis.x, inertia.y_axis.y, inertia.z_axis.z);
        MassProperties::principal(volume, self.body_frame(inertia))
    }

    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        let (radius, inset) = (0.5 * self.diameter, self.disc_frame(inset));
        let [along, spacing] = self.spacing(spacing);
        let mut points = Vec::new();
        let width = self.length - 2.0 * inset.y;
        if width > 0.0 {
            let rows = even_divisions(width, along);
            let around = ring(TAU * radius, spacing);
            let area = |width: f64| TAU * radius * width / (rows * around.len() as f64);
            for row in 0..rows as usize {
                let along = DVec3::Y * (width * midpoint(row, rows));
                points.extend(around.iter().map(|[a, b]| {
                    let normal = DVec3::new(*a, 0.0, *b);
                    self.point(radius * normal + along, normal, [width, self.length].map(area))
                }));
            }
        }
        let inset = RimInset::new(inset);
        let outer = (radius - inset.least()).max(0.0);
        let rings = if outer > 0.0 { divisions(outer, spacing) } else { 0.0 };
        for n in 0..rings as usize {
            let around = ring(TAU * (outer * (n as f64 + 0.5) / rings), spacing);
            for side in [-1.0, 1.0] {
                let normal = DVec3::Y * side;
                points.extend(around.iter().map(|[a, b]| {
                    let outer = (radius - inset.towards(*b)).max(0.0);
                    let radius = outer * (n as f64 + 0.5) / rings;
                    let area = TAU * radius * outer / (rings * around.len() as f64);
                    let represents = area * (0.5 * self.diameter / outer).powi(2);
                    let flat = DVec3::new(*a, 0.0, *b);
                    self.point(radius * flat + 0.5 * self.length * normal, normal, [area, represents])
                }));
            }
        }
        paired(points)
    }

    fn surface_point_count(&self, spacing: DVec3, inset: DVec3) -> f64 {
        let (radius, inset) = (0.5 * self.diameter, self.disc_frame(inset));
        let [along, spacing] = self.spacing(spacing);
        let width = self.length - 2.0 * inset.y;
        let outer = (radius - RimInset::new(inset).least()).max(0.0);
        let side = even_divisions(width, along) * ring_count(TAU * radius, spacing);
        let rings = if outer > 0.0 { divisions(outer, spacing) } else { 0.0 };
        let area = PI * (outer / spacing).powi(2);
        let around = |length: f64| ring_count(length, spacing);
        let end = ring_points(rings, |n| outer * (n + 0.5) / rings, around, area);
        if width > 0.0 { side + 2.0 * end } else { 2.0 * end }
    }

    fn is_revolved(&self) -> bool {
        self.axis == Axis::Y
    }

    fn mesh(&self) -> Mesh {
        let mesh = self.disc().mesh();
        Mesh { points: mesh.points.into_iter().map(|x| self.body_frame(x)).collect(), ..mesh }
    }
}
