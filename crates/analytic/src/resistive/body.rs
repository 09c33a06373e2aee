//! Pieces of surface, and what the soil does to all of them.

use super::{Traction, cross, dot};
use crate::disc::Disc;
use crate::error::{Answer, none};
use crate::numeric::gauss_points;

/// A flat piece of a body's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its middle in the body frame [m].
    pub middle: [f64; 3],
    /// Unit normal out of the body.
    pub normal: [f64; 3],
    /// Area [m²].
    pub area: f64,
    /// Half of its extent in height [m], by which one that the ground line cuts counts with its lower part; 0 for a point.
    pub rise: f64,
}

impl Facet {
    /// Depth [m] that, over the whole area, gives the mean of the depth of what lies below ground, for its middle at
    /// `depth` [m]; exact for a rectangle with a level edge.
    fn mean_depth(&self, depth: f64) -> f64 {
        if depth >= self.rise {
            depth
        } else if depth <= -self.rise {
            0.0
        } else {
            (depth + self.rise).powi(2) / (4.0 * self.rise)
        }
    }

    /// The same piece as a 2-D law sees it in slices along the tow: its area and normal in the plane of tow and gravity.
    #[must_use]
    pub fn sliced(&self) -> Self {
        let [x, _, z] = self.normal;
        let share = x.hypot(z);
        if share < 1e-12 {
            return Self { area: 0.0, ..*self };
        }
        Self { normal: [x / share, 0.0, z / share], area: self.area * share, ..*self }
    }
}

/// Where the body is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Height of the body frame's origin above the ground [m].
    pub height: f64,
    /// Velocity of the origin [m/s]; only its direction and its ratio to the spin matter.
    pub velocity: [f64; 3],
    /// Angular velocity [rad/s].
    pub spin: [f64; 3],
}

/// What the soil does to the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Force [N].
    pub force: [f64; 3],
    /// Torque about the origin of the body frame [N m].
    pub torque: [f64; 3],
}

/// Sums the traction of a law over a body.
#[must_use]
pub fn load(law: &impl Traction, facets: &[Facet], motion: &Motion) -> Load {
    let mut load = Load { force: [0.0; 3], torque: [0.0; 3] };
    for facet in facets {
        let depth = facet.mean_depth(-(motion.height + facet.middle[2]));
        if depth <= 0.0 {
            continue;
        }
        let turned = cross(motion.spin, facet.middle);
        let velocity = [0, 1, 2].map(|i| motion.velocity[i] + turned[i]);
        let speed = dot(velocity, velocity).sqrt();
        if speed < 1e-12 {
            continue;
        }
        let traction = law.traction(depth, facet.normal, velocity.map(|v| v / speed));
        let force = traction.map(|t| t * facet.area);
        let torque = cross(facet.middle, force);
        for i in 0..3 {
            load.force[i] += force[i];
            load.torque[i] += torque[i];
        }
    }
    load
}

/// The part of a disc's rim between the angles `from` and `to` [rad] from its lowest point, axle along y.
///
/// The pieces follow Gauss points, so that few are needed. The flat faces of a disc move in their own
/// plane and feel nothing in this theory.
#[must_use]
pub fn rim_facets(disc: &Disc, from: f64, to: f64) -> Vec<Facet> {
    let radius = 0.5 * disc.diameter;
    let facet = |(theta, weight): (f64, f64)| {
        let normal = [theta.sin(), 0.0, -theta.cos()];
        let area = weight * radius * disc.thickness;
        Facet { middle: normal.map(|n| n * radius), normal, area, rise: 0.0 }
    };
    gauss_points(from, to).map(facet).collect()
}

/// The facets of a closed triangle mesh [m], corners counter-clockwise seen from outside.
///
/// # Errors
/// If a triangle names a corner that is not there.
pub fn facets_of_triangles(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> Answer<Vec<Facet>> {
    let mut facets = Vec::with_capacity(triangles.len());
    for corners in triangles {
        let [Some(a), Some(b), Some(c)] = corners.map(|n| points.get(n as usize)) else {
            return none("the surface", "a triangle names a corner that is not there");
        };
        let edge = |to: &[f64; 3]| [0, 1, 2].map(|i| to[i] - a[i]);
        let twice = cross(edge(b), edge(c));
        let size = dot(twice, twice).sqrt();
        if size > 0.0 {
            let middle = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
            facets.push(Facet { middle, normal: twice.map(|x| x / size), area: 0.5 * size, rise: 0.0 });
        }
    }
    Ok(facets)
}
