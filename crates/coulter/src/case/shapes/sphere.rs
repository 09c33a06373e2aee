//! The sphere.

use super::surroundings::Surroundings;
use super::traits::{CaseShape, ClosedForm};
use crate::case::problem::Problems;
use crate::case::ranges::{self, POSITIVE};
use crate::case::typed::Section;
use physics::shape;
use serde::Serialize;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sphere {
    /// Diameter d [m].
    pub diameter: f64,
}

impl Sphere {
    pub(super) const KEYS: &[&str] = &["diameter"];

    pub(super) fn read(section: &Section, around: &Surroundings, problems: &mut Problems) -> Option<Self> {
        let diameter = ranges::required(section, "diameter", &POSITIVE, problems)?;
        if around.slab.is_some() {
            let message = "shape = \"sphere\" cannot be combined with plane_strain = true";
            problems.add(section.location_of("shape"), message, "remove plane_strain, or choose a disc");
            return None;
        }
        around.resolve(section, "diameter", diameter, problems).then_some(Self { diameter })
    }
}

impl CaseShape for Sphere {
    fn solid(&self) -> Box<dyn shape::Shape> {
        Box::new(shape::Sphere { diameter: self.diameter })
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

    fn has_flat_sides(&self, _axis: usize, _rotates: bool) -> bool {
        false
    }

    fn describe(&self, length: &dyn Fn(f64) -> String, _angle: &dyn Fn(f64) -> String) -> String {
        format!("sphere, d = {}", length(self.diameter))
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Facets { length: self.diameter, width: self.diameter }
    }
}
