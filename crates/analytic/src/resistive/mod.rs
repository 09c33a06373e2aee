//! Resistive force theory: every piece of a surface pushes on the soil by itself.
//!
//! Traction grows with depth and depends on the tilt of the piece and the direction of its motion only. There is no
//! width term: shallow wide bodies come out too weak, deep narrow ones too strong next to model BC. Quasi-static, dry,
//! loose to medium sand; depth up to about the width of the body.

mod body;
mod planar;
mod spatial;
mod towed;

pub use body::{Facet, Load, Motion, facets_of_triangles, load, rim_facets};
pub use planar::PlanarLaw;
pub use spatial::{SpatialLaw, strength_scale};
pub use towed::{Rolled, at_depth, body_at_depth, body_under_weight, under_weight};

/// A law for the traction on a piece of surface.
pub trait Traction {
    /// Traction on the body [Pa] at the depth [m], for the outward unit normal and the unit direction of motion.
    ///
    /// x is the tow direction, z points up. Zero where the piece moves away from the soil.
    fn traction(&self, depth: f64, normal: [f64; 3], direction: [f64; 3]) -> [f64; 3];
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
