//! Prisms: wedges, blades, wheels with grousers.

use super::{MassProperties, Mesh, Profile, Shape};
use glam::{DMat3, DVec2, DVec3};

/// A closed profile in the plane of x (its u) and z (its v), extruded along y, centred on y = 0.
///
/// From the centroid of the profile every point of it can be seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Extruded {
    profile: Profile,
    width: f64,
}

impl Extruded {
    /// `width` along y [m].
    #[must_use]
    pub fn new(profile: Profile, width: f64) -> Self {
        Self { profile, width }
    }

    /// Area of the profile [m²] and its centroid [m].
    fn centroid(&self) -> (f64, DVec2) {
        let area = self.profile.integral(|x| x.x);
        let moment = |f: fn(DVec2) -> f64| self.profile.integral(f);
        (area, DVec2::new(moment(|x| 0.5 * x.x * x.x), moment(|x| x.x * x.y)) / area)
    }
}

impl Shape for Extruded {
    fn signed_distance(&self, x: DVec3) -> f64 {
        let flat = self.profile.signed_distance(DVec2::new(x.x, x.z));
        let outside = DVec2::new(flat, x.y.abs() - 0.5 * self.width);
        outside.max_element().min(0.0) + outside.max(DVec2::ZERO).length()
    }

    fn extent(&self, direction: DVec3) -> f64 {
        self.profile.support(DVec2::new(direction.x, direction.z)) + 0.5 * self.width * direction.y.abs()
    }

    fn mass_properties(&self) -> MassProperties {
        let (area, centroid) = self.centroid();
        let mean = |f: fn(DVec2) -> f64| self.profile.integral(f) / area;
        let xx = mean(|x| x.x.powi(3) / 3.0) - centroid.x.powi(2);
        let zz = mean(|x| x.x * x.y.powi(2)) - centroid.y.powi(2);
        let xz = mean(|x| 0.5 * x.x.powi(2) * x.y) - centroid.x * centroid.y;
        let yy = self.width.powi(2) / 12.0;
        MassProperties {
            volume: area * self.width,
            centroid: DVec3::new(centroid.x, 0.0, centroid.y),
            inertia: DMat3::from_cols_array_2d(&[
                [yy + zz, 0.0, -xz],
                [0.0, xx + zz, 0.0],
                [-xz, 0.0, xx + yy],
            ]),
        }
    }

    fn mesh(&self) -> Mesh {
        let (outline, half) = (self.profile.points(), 0.5 * self.width);
        let (_, centre) = self.centroid();
        let mut mesh = Mesh::default();
        for x in outline.iter().chain([&centre]) {
            mesh.points.extend([-half, half].map(|y| DVec3::new(x.x, y, x.y)));
        }
        let count = outline.len() as u32;
        let middle = 2 * count;
        for n in 0..count {
            let (a, b) = (2 * n, 2 * ((n + 1) % count));
            mesh.triangles.extend([
                [middle, a, b],
                [middle + 1, b + 1, a + 1],
                [a, b + 1, b],
                [a, a + 1, b + 1],
            ]);
        }
        mesh
    }
}
