//! The disc.

use super::surroundings::Surroundings;
use super::traits::{CaseShape, ClosedForm};
use crate::case::problem::Problems;
use crate::case::ranges::{self, POSITIVE};
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
    pub(super) fn read(section: &Section, around: &Surroundings, problems: &mut Problems) -> Option<Self> {
        let diameter = ranges::required(section, "diameter", &POSITIVE, problems);
        let thickness = match around.slab {
            None => ranges::required(section, "thickness", &POSITIVE, problems),
            Some(slab) if !section.has("thickness") => Some(slab.covering_width()),
            Some(_) => {
                let message = "in plane strain a disc is as thick as the slab is wide";
                problems.add(section.location_of("thickness"), message, "remove `thickness`");
                None
            }
        };
        let (diameter, thickness) = (diameter?, thickness?);
        let mut enough = around.resolve(section, "diameter", diameter, problems);
        if around.slab.is_none() {
            enough &= around.resolve(section, "thickness", thickness, problems);
        }
        enough.then_some(Self { diameter, thickness })
    }
}

impl CaseShape for Disc {
    fn solid(&self) -> Box<dyn shape::Shape> {
        Box::new(shape::Disc { diameter: self.diameter, thickness: self.thickness })
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

    fn has_flat_sides(&self, axis: usize, _rotates: bool) -> bool {
        axis == 1
    }

    fn describe(&self, length: &dyn Fn(f64) -> String, _angle: &dyn Fn(f64) -> String) -> String {
        format!("disc, d = {}, t = {}", length(self.diameter), length(self.thickness))
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Disc { diameter: self.diameter, thickness: self.thickness }
    }
}
