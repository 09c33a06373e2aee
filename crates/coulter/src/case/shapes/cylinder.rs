//! The cylinder.

use super::surroundings::Surroundings;
use super::traits::{CaseShape, ClosedForm};
use crate::case::problem::Problems;
use crate::case::ranges::{self, POSITIVE};
use crate::case::typed::Section;
use physics::shape::{self, Axis};
use serde::Serialize;

/// A cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cylinder {
    /// Diameter d [m].
    pub diameter: f64,
    /// Length along its axis [m].
    pub length: f64,
    /// Direction of its axis.
    pub axis: Axis,
}

impl Cylinder {
    pub(super) const KEYS: &[&str] = &["diameter", "length", "axis"];

    /// In plane strain it lies across the slab and is as long as the slab is wide.
    pub(super) fn read(section: &Section, around: &Surroundings, problems: &mut Problems) -> Option<Self> {
        let diameter = ranges::required(section, "diameter", &POSITIVE, problems);
        if !section.has("axis") {
            ranges::missing(section, "axis", problems);
        }
        let length = match around.slab {
            None => ranges::required(section, "length", &POSITIVE, problems),
            Some(slab) if !section.has("length") => Some(slab.covering_width()),
            Some(_) => {
                let message = "in plane strain a cylinder is as long as the slab is wide";
                problems.add(section.location_of("length"), message, "remove `length`");
                None
            }
        };
        let axis = match section.text("axis")?.value.as_str() {
            "x" => Axis::X,
            "y" => Axis::Y,
            _ => Axis::Z,
        };
        if around.slab.is_some() && axis != Axis::Y {
            let message = "in plane strain a cylinder lies across the slab";
            problems.add(section.location_of("axis"), message, "write axis = \"y\", or model it in 3D");
            return None;
        }
        let (diameter, length) = (diameter?, length?);
        let mut enough = around.resolve(section, "diameter", diameter, problems);
        if around.slab.is_none() {
            enough &= around.resolve(section, "length", length, problems);
        }
        enough.then_some(Self { diameter, length, axis })
    }
}

impl CaseShape for Cylinder {
    fn solid(&self) -> Box<dyn shape::Shape> {
        let Self { diameter, length, axis } = *self;
        Box::new(shape::Cylinder { diameter, length, axis })
    }

    fn reference_length(&self) -> f64 {
        self.diameter
    }

    fn reference_width(&self) -> f64 {
        if self.axis == Axis::Y { self.length } else { self.diameter }
    }

    fn rolling_diameter(&self) -> Option<f64> {
        (self.axis == Axis::Y).then_some(self.diameter)
    }

    fn has_flat_sides(&self, axis: usize, rotates: bool) -> bool {
        match self.axis {
            Axis::X => axis == 0 && !rotates,
            Axis::Y => axis == 1,
            Axis::Z => axis == 2 && !rotates,
        }
    }

    fn describe(&self, length: &dyn Fn(f64) -> String, _angle: &dyn Fn(f64) -> String) -> String {
        format!("cylinder along {}, d = {}, l = {}", self.axis, length(self.diameter), length(self.length))
    }

    fn closed_form(&self) -> ClosedForm {
        let Self { diameter, length, axis } = *self;
        if axis == Axis::Y {
            ClosedForm::Disc { diameter, thickness: length }
        } else {
            ClosedForm::Facets { length: diameter, width: length }
        }
    }
}
