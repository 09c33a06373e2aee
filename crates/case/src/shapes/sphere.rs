//! The sphere.

use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use crate::key::required;
use input::key::{KeyOf, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sphere {
    /// Diameter d [m].
    pub diameter: f64,
}

impl Sphere {
    pub(super) const FIELDS: &[KeyOf<Self>] =
        &[field("diameter", Place::Number(|sphere| &mut sphere.diameter))];

    pub(super) fn read(section: &Section, _slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        Some(Self { diameter: required(KEYS, section, "diameter", problems)? })
    }
}

impl CaseShape for Sphere {
    fn solid(&self) -> Box<dyn geometry::Shape> {
        Box::new(geometry::Sphere { diameter: self.diameter })
    }

    fn sizes(&self) -> Vec<Size> {
        vec![Size::across("diameter", self.diameter)]
    }

    fn plane_strain_conflict(&self) -> Option<Conflict> {
        Some(Conflict {
            key: "shape",
            message: "shape = \"sphere\" cannot be combined with plane_strain = true",
            cure: "remove plane_strain, or choose a disc",
        })
    }

    fn reference_length(&self) -> f64 {
        self.diameter
    }

    fn reference_width(&self) -> f64 {
        self.diameter
    }

    fn rolling_diameter(&self) -> Option<f64> {
        Some(self.diameter)
    }

    fn has_flat_sides(&self, _axis: usize) -> bool {
        false
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        format!("sphere, d = {}", length(self.diameter))
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Facets { length: self.diameter, width: self.diameter }
    }
}
