//! Facets of a body's surface, and the force and torque of the soil on all of them.

use super::{Traction, cross, dot};
use crate::disc::Disc;
use crate::error::{ModelResult, undefined};
use numerics::quadrature::gauss_points;

/// A flat element of a body's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Centroid in the body frame [m].
    pub centroid: [f64; 3],
    /// Outward unit normal.
    pub normal: [f64; 3],
    /// Area [m²].
    pub area: f64,
    /// Half of the vertical extent of the facet [m], for facets that are only partly below the ground; 0 for
    /// a point.
    pub half_height: f64,
}

impl Facet {
    /// Mean over the area of the depth below ground [m], 0 above it, for the centroid at `depth` [m]; exact
    /// for a rectangle with a horizontal edge.
    fn mean_depth(&self, depth: f64) -> f64 {
        if depth >= self.half_height {
            depth
        } else if depth <= -self.half_height {
            0.0
        } else {
            (depth + self.half_height).powi(2) / (4.0 * self.half_height)
        }
    }

    /// Projection of the facet for a 2-D law applied in slices along the tow: area and normal in the x–z
    /// plane.
    #[must_use]
    pub fn sliced(&self) -> Self {
        let [x, _, z] = self.normal;
        let ratio = x.hypot(z);
        if ratio < 1e-12 {
            return Self { area: 0.0, ..*self };
        }
        Self { normal: [x / ratio, 0.0, z / ratio], area: self.area * ratio, ..*self }
    }
}

/// Position and velocity of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Height of the body frame's origin above the ground [m].
    pub height: f64,
    /// Velocity of the origin [m/s]; only its direction and its ratio to the angular velocity matter.
    pub velocity: [f64; 3],
    /// Angular velocity [rad/s].
    pub spin: [f64; 3],
}

/// Force and torque of the soil on the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench {
    /// Force [N].
    pub force: [f64; 3],
    /// Torque about the origin of the body frame [N m].
    pub torque: [f64; 3],
}

/// Integrates the traction of a law over a body.
#[must_use]
pub fn wrench(law: &impl Traction, facets: &[Facet], motion: &Motion) -> Wrench {
    let mut sum = Wrench { force: [0.0; 3], torque: [0.0; 3] };
    for facet in facets {
        let depth = facet.mean_depth(-(motion.height + facet.centroid[2]));
        if depth <= 0.0 {
            continue;
        }
        let rotation = cross(motion.spin, facet.centroid);
        let velocity = [0, 1, 2].map(|i| motion.velocity[i] + rotation[i]);
        let speed = dot(velocity, velocity).sqrt();
        if speed < 1e-12 {
            continue;
        }
        let traction = law.traction(depth, facet.normal, velocity.map(|v| v / speed));
        let force = traction.map(|t| t * facet.area);
        let torque = cross(facet.centroid, force);
        for i in 0..3 {
            sum.force[i] += force[i];
            sum.torque[i] += torque[i];
        }
    }
    sum
}

/// Facets of a disc's rim between the angles `from` and `to` [rad] from its lowest point, axle along y.
///
/// The facets are placed at Gauss points, so that few are needed. The flat faces of a disc move in their own
/// plane, where the theory gives no traction.
#[must_use]
pub fn rim_facets(disc: &Disc, from: f64, to: f64) -> Vec<Facet> {
    let radius = 0.5 * disc.diameter;
    let facet = |(theta, weight): (f64, f64)| {
        let normal = [theta.sin(), 0.0, -theta.cos()];
        let area = weight * radius * disc.thickness;
        Facet { centroid: normal.map(|n| n * radius), normal, area, half_height: 0.0 }
    };
    gauss_points(from, to).map(facet).collect()
}

/// The facets of a closed triangle mesh [m], corners counter-clockwise seen from outside.
///
/// # Errors
/// If a triangle refers to a point that does not exist.
pub fn facets_of_triangles(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> ModelResult<Vec<Facet>> {
    let mut facets = Vec::with_capacity(triangles.len());
    for corners in triangles {
        let [Some(a), Some(b), Some(c)] = corners.map(|n| points.get(n as usize)) else {
            return undefined("the surface", "a triangle refers to a point that does not exist");
        };
        let edge = |to: &[f64; 3]| [0, 1, 2].map(|i| to[i] - a[i]);
        let twice = cross(edge(b), edge(c));
        let size = dot(twice, twice).sqrt();
        if size > 0.0 {
            let centroid = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
            facets.push(Facet {
                centroid,
                normal: twice.map(|x| x / size),
                area: 0.5 * size,
                half_height: 0.0,
            });
        }
    }
    Ok(facets)
}
