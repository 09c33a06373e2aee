//! The frame: a body without a surface.

use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Size};
use input::key::KeyOf;
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A frame: mass and motion without a surface, such as the beam that carries discs, or the point that a cable
/// is towed by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Frame {}

impl Frame {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[];

    pub(super) fn read(_section: &Section, _slab: Option<Slab>, _problems: &mut Problems) -> Option<Self> {
        Some(Self {})
    }
}

impl CaseShape for Frame {
    fn solid(&self) -> Box<dyn geometry::Shape> {
        Box::new(geometry::Frame)
    }

    fn sizes(&self) -> Vec<Size> {
        Vec::new()
    }

    /// No length: a frame has no dimensionless groups.
    fn reference_length(&self) -> f64 {
        0.0
    }

    fn reference_width(&self) -> f64 {
        0.0
    }

    fn has_flat_sides(&self, _axis: usize) -> bool {
        false
    }

    fn has_surface(&self) -> bool {
        false
    }

    fn describe(&self, _length: &dyn Fn(f64) -> String) -> String {
        "frame".to_owned()
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::None
    }
}
