//! The disc: a flat cylinder with sharp rims and its axle along `y`.

use super::{
    MassProperties, Mesh, RimInset, Shape, SurfacePoint, divisions, even_divisions, midpoint, paired,
    ring_points,
};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A flat cylinder centred on the origin, axle along `y`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Diameter d [m].
    pub diameter: f64,
    /// Thickness t along the axle [m].
    pub thickness: f64,
}

impl Disc {
    fn radius(&self) -> f64 {
        0.5 * self.diameter
    }
}

impl Shape for Disc {
    fn signed_distance(&self, x: DVec3) -> f64 {
        let outside = DVec2::new(x.x.hypot(x.z) - self.radius(), x.y.abs() - 0.5 * self.thickness);
        outside.max_element().min(0.0) + outside.max(DVec2::ZERO).length()
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let corner = DVec3::new(self.radius(), 0.5 * self.thickness, self.radius());
        (-corner, corner)
    }

    fn extent(&self, direction: DVec3) -> f64 {
        self.radius() * direction.x.hypot(direction.z) + 0.5 * self.thickness * direction.y.abs()
    }

    fn mass_properties(&self) -> MassProperties {
        let across = 0.25 * self.radius().powi(2) + self.thickness.powi(2) / 12.0;
        let inertia = DVec3::new(across, 0.5 * self.radius().powi(2), across);
        MassProperties::principal(PI * self.radius().powi(2) * self.thickness, inertia)
    }

    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        let mut points = Vec::new();
        let (across, in_plane) = (spacing.y, spacing.x.min(spacing.z));
        rim_points(self, [across, in_plane], inset.y, &mut points);
        for side in [-1.0, 1.0] {
            face_points(self, side, in_plane, RimInset::new(inset), &mut points);
        }
        paired(points)
    }

    fn surface_point_count(&self, spacing: DVec3, inset: DVec3) -> f64 {
        let (across, spacing) = (spacing.y, spacing.x.min(spacing.z));
        let width = self.thickness - 2.0 * inset.y;
        let rim = even_divisions(width, across) * divisions(PI * self.diameter, spacing);
        let outer = self.radius() - RimInset::new(inset).least();
        let rings = divisions(outer, spacing);
        let area = PI * (outer / spacing).powi(2);
        let around = |length: f64| divisions(length, spacing);
        let face = ring_points(rings, |n| outer * (n + 0.5) / rings, around, area);
        if width > 0.0 { rim + 2.0 * face } else { 2.0 * face }
    }

    fn as_disc(&self) -> Option<[f64; 2]> {
        Some([self.diameter, self.thickness])
    }

    fn is_revolved(&self) -> bool {
        true
    }

    fn mesh(&self) -> Mesh {
        const SEGMENTS: u32 = 96;
        let (radius, half) = (self.radius(), 0.5 * self.thickness);
        let mut mesh =
            Mesh { points: vec![DVec3::new(0.0, -half, 0.0), DVec3::new(0.0, half, 0.0)], triangles: vec![] };
        for n in 0..SEGMENTS {
            let (sin, cos) = (TAU * f64::from(n) / f64::from(SEGMENTS)).sin_cos();
            for y in [-half, half] {
                mesh.points.push(DVec3::new(radius * sin, y, radius * cos));
            }
        }
        for n in 0..SEGMENTS {
            let (a, b) = (2 + 2 * n, 2 + 2 * ((n + 1) % SEGMENTS));
            mesh.triangles.extend([[0, b, a], [1, a + 1, b + 1], [a, b, a + 1], [b, b + 1, a + 1]]);
        }
        mesh
    }
}

/// Points on the rim, in rows across the thickness; spacing across and round the rim.
fn rim_points(disc: &Disc, [across, spacing]: [f64; 2], inset: f64, points: &mut Vec<SurfacePoint>) {
    let width = disc.thickness - 2.0 * inset;
    if width <= 0.0 {
        return;
    }
    let rows = even_divisions(width, across);
    let columns = divisions(PI * disc.diameter, spacing);
    let [area, represents] = [width, disc.thickness].map(|width| width / rows * PI * disc.diameter / columns);
    for row in 0..rows as usize {
        let y = width * midpoint(row, rows);
        for column in 0..columns as usize {
            let (sin, cos) = (TAU * (column as f64 + 0.5) / columns).sin_cos();
            let normal = DVec3::new(sin, 0.0, cos);
            let position = normal * disc.radius() + DVec3::Y * y;
            points.push(SurfacePoint { position, normal, area, represents });
        }
    }
}

/// Points on one flat face, in rings.
fn face_points(disc: &Disc, side: f64, spacing: f64, inset: RimInset, points: &mut Vec<SurfacePoint>) {
    let outer = disc.radius() - inset.least();
    let rings = divisions(outer, spacing);
    for ring in 0..rings as usize {
        let count = divisions(TAU * (outer * (ring as f64 + 0.5) / rings), spacing);
        for n in 0..count as usize {
            let (sin, cos) = (TAU * (n as f64 + 0.5) / count).sin_cos();
            let outer = disc.radius() - inset.towards(cos);
            let radius = outer * (ring as f64 + 0.5) / rings;
            let area = TAU * radius * outer / rings / count;
            points.push(SurfacePoint {
                position: DVec3::new(radius * sin, side * 0.5 * disc.thickness, radius * cos),
                normal: DVec3::Y * side,
                area,
                represents: area * (disc.radius() / outer).powi(2),
            });
        }
    }
}
