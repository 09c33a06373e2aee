//! The disc.

use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Size};
use crate::case::missing::required;
use crate::case::problem::Problems;
use crate::case::typed::Section;
use physics::shape;
use serde::Serialize;

/// A disc, axle along y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Disc {
    /// Diameter d [m].
    pub diameter: f64,
    /// Thickness t [m].
    pub thickness: f64,
}

impl Disc {
    pub(super) const KEYS: &[&str] = &["diameter", "thickness"];

    /// In plane strain it is as thick as the slab is wide.
    pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        let diameter = required(section, "diameter", problems);
        let thickness = match slab {
            None => required(section, "thickness", problems),
            Some(slab) if !section.has("thickness") => Some(slab.covering_width()),
            Some(_) => {
                let message = "in plane strain a disc is as thick as the slab is wide";
                problems.add(section.at("thickness"), message, "remove `thickness`");
                None
            }
        };
        Some(Self { diameter: diameter?, thickness: thickness? })
    }
}

impl CaseShape for Disc {
    fn solid(&self) -> Box<dyn shape::Shape> {
        Box::new(shape::Disc { diameter: self.diameter, thickness: self.thickness })
    }

    fn sizes(&self) -> Vec<Size> {
        vec![Size::across("diameter", self.diameter), Size::along("thickness", self.thickness, 1)]
    }

    fn reference_length(&self) -> f64 {
        self.diameter
    }

    fn reference_width(&self) -> f64 {
        self.thickness
    }

    fn rolling_diameter(&self) -> Option<f64> {
        Some(self.diameter)
    }

    fn has_flat_sides(&self, axis: usize) -> bool {
        axis == 1
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        format!("disc, d = {}, t = {}", length(self.diameter), length(self.thickness))
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Disc { diameter: self.diameter, thickness: self.thickness }
    }
}
