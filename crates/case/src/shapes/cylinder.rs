//! The cylinder.

use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use super::widths;
use crate::key::{missing, required};
use geometry::{self, Axis};
use input::key::{KeyOf, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cylinder {
    /// Diameter d [m].
    pub diameter: f64,
    /// Length along the axis of the cylinder [m].
    pub length: f64,
    /// Direction of the axis of the cylinder.
    pub axis: Axis,
}

impl Cylinder {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[
        field("diameter", Place::Number(|cylinder| &mut cylinder.diameter)),
        field("length", Place::Number(|cylinder| &mut cylinder.length)),
        field("axis", Place::Elsewhere),
    ];

    /// Reads a cylinder; in plane strain it lies across the slab and is as long as the slab is wide.
    pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        let diameter = required(KEYS, section, "diameter", problems);
        missing(KEYS, section, "axis", problems);
        let length =
            widths::across(section, "length", "a cylinder is as long as the slab is wide", slab, problems);
        let axis = match section.text("axis")?.as_str() {
            "x" => Axis::X,
            "y" => Axis::Y,
            _ => Axis::Z,
        };
        Some(Self { diameter: diameter?, length: length?, axis })
    }
}

impl CaseShape for Cylinder {
    fn solid(&self) -> Box<dyn geometry::Shape> {
        let Self { diameter, length, axis } = *self;
        Box::new(geometry::Cylinder { diameter, length, axis })
    }

    fn sizes(&self) -> Vec<Size> {
        let axis = match self.axis {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        };
        vec![Size::across("diameter", self.diameter), Size::along("length", self.length, axis)]
    }

    fn plane_strain_conflict(&self) -> Option<Conflict> {
        (self.axis != Axis::Y).then_some(Conflict {
            key: "axis",
            message: "in plane strain a cylinder lies across the slab",
            cure: "write axis = \"y\", or model it in 3D",
        })
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

    fn has_flat_sides(&self, axis: usize) -> bool {
        let along = match self.axis {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        };
        axis == along
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        format!("cylinder along {}, d = {}, l = {}", self.axis, length(self.diameter), length(self.length))
    }

    fn closed_form(&self) -> ClosedForm {
        let Self { diameter, length, axis } = *self;
        match axis {
            Axis::X => ClosedForm::Facets { length: diameter, width: length },
            Axis::Y => ClosedForm::Disc { diameter, thickness: length },
            Axis::Z => ClosedForm::Column { diameter, height: length },
        }
    }
}
