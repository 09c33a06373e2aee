//! Resistive force theory (RFT): the soil exerts a traction on every surface element, independently of the
//! others.
//!
//! The traction is proportional to depth and otherwise depends on the inclination of the element and its
//! direction of motion only. There is no width term: compared with model BC, forces on shallow wide bodies
//! are too low and on deep narrow ones too high. For quasi-static motion in dry, loose to medium sand, at
//! depths up to about the width of the body.

mod body;
mod planar;
mod spatial;
mod towed;

pub use body::{Facet, Motion, Wrench, facets_of_triangles, rim_facets, wrench};
pub use planar::PlanarLaw;
pub use spatial::{SpatialLaw, stiffness_per_unit_weight};
pub use towed::{Axle, Faceted, SteadyTow, at_depth, body_at_depth, body_under_weight, under_weight};

/// A law for the traction on a surface element.
pub trait Traction {
    /// Traction on the body [Pa] at a depth [m], for the outward unit normal and the unit direction of
    /// motion.
    ///
    /// x is the tow direction, z points up. Zero where the element moves away from the soil.
    fn traction(&self, depth: f64, normal: [f64; 3], direction: [f64; 3]) -> [f64; 3];
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
