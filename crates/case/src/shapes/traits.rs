//! What the program asks of a shape in a case.

use geometry::{self, Thin, ThinSearch};
use glam::DVec3;
use input::key::Numbers;
use input::mesh_file::MeshReport;

/// What the program asks of a shape. The body frame is that of [`geometry::Shape`].
pub trait CaseShape {
    /// The shape with its geometry: distances, contact points, mesh.
    fn solid(&self) -> Box<dyn geometry::Shape>;
    /// Every length that describes the shape.
    fn sizes(&self) -> Vec<Size>;
    /// Numbers that describe the shape and do not lie in a place, each with its key.
    fn other_numbers(&self) -> Numbers {
        Vec::new()
    }
    /// Why the numbers of the shape, each in the range of its key, exclude each other, if they do.
    fn conflict(&self) -> Option<Conflict> {
        None
    }
    /// Why the shape cannot be part of a slab in plane strain, if it cannot.
    fn plane_strain_conflict(&self) -> Option<Conflict> {
        None
    }
    /// Reference length d [m] of the dimensionless groups.
    fn reference_length(&self) -> f64;
    /// Reference width t across the tow [m] of the dimensionless groups.
    fn reference_width(&self) -> f64;
    /// Diameter on which the shape rolls about y [m]; `None` if it cannot roll.
    fn rolling_diameter(&self) -> Option<f64> {
        None
    }
    /// Whether the shape has a surface that the soil can touch.
    fn has_surface(&self) -> bool {
        true
    }
    /// Whether the sides of the shape across an axis of its own are flat.
    fn has_flat_sides(&self, axis: usize) -> bool;
    /// Whether the shape is its own mirror image in the plane through its reference point across an axis of
    /// its own.
    fn is_mirrored(&self, _axis: usize) -> bool {
        true
    }
    /// Thinnest place of the shape, where `sizes` do not say how thin the shape is.
    fn thinnest(&self, _search: &ThinSearch) -> Option<Thin> {
        None
    }
    /// What the surface of the shape is like, if that was read from a file.
    fn mesh_report(&self) -> Option<&MeshReport> {
        None
    }
    /// The shape in words, with the kind first; lengths [m] are written by the caller's function.
    fn describe(&self, length: &dyn Fn(f64) -> String) -> String;
    /// What the closed-form models take the shape for.
    fn closed_form(&self) -> ClosedForm;
    /// How the closed-form models simplify the shape, in words; `None` where they do not.
    fn closed_form_note(&self) -> Option<&'static str> {
        None
    }
}

/// A length that describes a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Key of the size.
    pub key: &'static str,
    /// The length [m].
    pub length: f64,
    /// The axis along which the length is measured; `None` for several.
    pub axis: Option<usize>,
}

impl Size {
    /// The size of a length along one axis [m].
    pub(super) fn along(key: &'static str, length: f64, axis: usize) -> Self {
        Self { key, length, axis: Some(axis) }
    }

    /// A length along several axes [m].
    pub(super) fn across(key: &'static str, length: f64) -> Self {
        Self { key, length, axis: None }
    }
}

/// Why a shape is not possible, or not in plane strain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// The key that says so.
    pub key: &'static str,
    /// What is wrong.
    pub message: &'static str,
    /// How to resolve the conflict.
    pub cure: &'static str,
}

impl Conflict {
    pub(super) fn new(key: &'static str, message: &'static str, cure: &'static str) -> Self {
        Self { key, message, cure }
    }
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
    },
    /// A body with a round level base, divided into facets under tow.
    Column {
        /// Diameter [m].
        diameter: f64,
        /// Height [m].
        height: f64,
    },
    /// Nothing: the shape has no surface.
    None,
    /// Any other surface, divided into facets.
    Facets {
        /// Size along the tow [m].
        length: f64,
        /// Size across the tow [m].
        width: f64,
    },
}
