//! What the program asks of a shape in a case.

use glam::DVec3;
use physics::shape;

/// What the program asks of a shape. The body frame is that of [`shape::Shape`].
pub trait CaseShape {
    /// The shape with its geometry: distances, contact points, mesh.
    fn solid(&self) -> Box<dyn shape::Shape>;
    /// Reference length d [m] of the dimensionless groups.
    fn reference_length(&self) -> f64;
    /// Reference width t across the tow [m] of the dimensionless groups.
    fn reference_width(&self) -> f64;
    /// Diameter in which it rolls about y [m]; `None` if it cannot roll.
    fn rolling_diameter(&self) -> Option<f64> {
        None
    }
    /// Whether its sides across an axis are flat, and stay where they are; `rotates` says whether the body may rotate about y.
    fn has_flat_sides(&self, axis: usize, rotates: bool) -> bool;
    /// Whether it is its own mirror image about x = 0.
    fn is_symmetric_about_x(&self) -> bool {
        true
    }
    /// In words, with the kind first; lengths [m] and angles [rad] are written by the caller's functions.
    fn describe(&self, length: &dyn Fn(f64) -> String, angle: &dyn Fn(f64) -> String) -> String;
    /// What the closed-form models take it for.
    fn closed_form(&self) -> ClosedForm;
}

/// A body as the closed-form models see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClosedForm {
    /// A disc that rolls about y.
    Disc {
        /// Diameter [m].
        diameter: f64,
        /// Thickness [m].
        thickness: f64,
    },
    /// A block.
    Block {
        /// Edge lengths [m].
        size: DVec3,
        /// Rotation about y [rad].
        orientation: f64,
    },
    /// Any other surface, divided into facets.
    Facets {
        /// Size along the tow [m].
        length: f64,
        /// Size across it [m].
        width: f64,
    },
}
