//! The sphere.

use super::{MassProperties, Mesh, Shape, SurfacePoint, midpoint, paired, ring, ring_count, ring_points};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// A sphere centred on the origin. It has no sharp edges, so its contact points have no inset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Diameter [m].
    pub diameter: f64,
}

impl Sphere {
    fn radius(&self) -> f64 {
        0.5 * self.diameter
    }

    /// Number of rings of contact points.
    fn rings(&self, spacing: f64) -> f64 {
        (PI * self.radius() / spacing).ceil().max(2.0)
    }
}

impl Shape for Sphere {
    fn signed_distance(&self, x: DVec3) -> f64 {
        x.length() - self.radius()
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        (DVec3::splat(-self.radius()), DVec3::splat(self.radius()))
    }

    fn extent(&self, direction: DVec3) -> f64 {
        self.radius() * direction.length()
    }

    fn mass_properties(&self) -> MassProperties {
        let inertia = DVec3::splat(0.4 * self.radius().powi(2));
        MassProperties::principal(PI / 6.0 * self.diameter.powi(3), inertia)
    }

    /// Rings of equal width between the poles on the z axis; the points of a ring share the exact area of its
    /// zone.
    fn surface_points(&self, spacing: DVec3, _inset: DVec3) -> Vec<SurfacePoint> {
        let (radius, spacing) = (self.radius(), spacing.min_element());
        let rings = self.rings(spacing);
        let mut points = Vec::new();
        for n in 0..rings as usize {
            // Relative to the equator, so that the hemispheres are symmetric to the bit.
            let latitude = PI * midpoint(n, rings);
            let half = 0.5 * PI / rings;
            let zone = TAU * radius.powi(2) * 2.0 * latitude.cos() * half.sin();
            let around = ring(TAU * radius * latitude.cos(), spacing);
            let area = zone / around.len() as f64;
            points.extend(around.iter().map(|[x, y]| {
                let normal = DVec3::new(x * latitude.cos(), y * latitude.cos(), latitude.sin());
                SurfacePoint { position: radius * normal, normal, area, represents: area }
            }));
        }
        paired(points)
    }

    fn surface_point_count(&self, spacing: DVec3, _inset: DVec3) -> f64 {
        let spacing = spacing.min_element();
        let (radius, rings) = (self.radius(), self.rings(spacing));
        let ring_radius = |n: f64| radius * (PI * (2.0 * n + 1.0 - rings) / (2.0 * rings)).cos();
        let area = 4.0 * PI * (radius / spacing).powi(2);
        ring_points(rings, ring_radius, |length| ring_count(length, spacing), area)
    }

    fn as_ball(&self) -> Option<f64> {
        Some(self.radius())
    }

    fn is_revolved(&self) -> bool {
        true
    }

    fn mesh(&self) -> Mesh {
        const AROUND: u32 = 96;
        const UP: u32 = 48;
        let radius = self.radius();
        let mut mesh = Mesh { points: vec![-radius * DVec3::Z, radius * DVec3::Z], triangles: vec![] };
        for row in 1..UP {
            let (up, out) = (PI * (f64::from(row) / f64::from(UP) - 0.5)).sin_cos();
            for n in 0..AROUND {
                let (sin, cos) = (TAU * f64::from(n) / f64::from(AROUND)).sin_cos();
                mesh.points.push(radius * DVec3::new(out * cos, out * sin, up));
            }
        }
        let at = |row: u32, n: u32| 2 + (row - 1) * AROUND + n % AROUND;
        for n in 0..AROUND {
            mesh.triangles.extend([[0, at(1, n + 1), at(1, n)], [1, at(UP - 1, n), at(UP - 1, n + 1)]]);
            for row in 1..UP - 1 {
                let [a, b, c, d] = [at(row, n), at(row, n + 1), at(row + 1, n), at(row + 1, n + 1)];
                mesh.triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
        mesh
    }
}
