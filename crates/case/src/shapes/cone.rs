//! The cone on a shaft, tip down: a penetrometer.

use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use crate::key::required;
use geometry::{self, Axis, Profile, Revolved};
use input::key::{KeyOf, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A cone on a shaft, its axis along z and its tip down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cone {
    /// Diameter d of the base of the cone [m].
    pub diameter: f64,
    /// Angle at the tip [rad], between opposite sides.
    pub apex: f64,
    /// Diameter of the shaft [m].
    pub shaft: f64,
    /// Length of cone and shaft together [m].
    pub length: f64,
}

impl Cone {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[
        field("diameter", Place::Number(|cone| &mut cone.diameter)),
        field("shaft_diameter", Place::Number(|cone| &mut cone.shaft)),
        field("length", Place::Number(|cone| &mut cone.length)),
        field("cone_angle", Place::Number(|cone| &mut cone.apex)),
    ];

    pub(super) fn read(section: &Section, _slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        let [diameter, apex, length] =
            ["diameter", "cone_angle", "length"].map(|key| required(KEYS, section, key, problems));
        let shaft = section.number_or("shaft_diameter", diameter?);
        Some(Self { diameter: diameter?, apex: apex?, shaft: shaft?, length: length? })
    }

    fn profile(&self) -> Option<Profile> {
        geometry::cone(self.diameter, self.apex, self.shaft, self.length)
    }
}

impl CaseShape for Cone {
    /// The solid of the cone; one whose lengths exclude each other is shown as a cylinder.
    fn solid(&self) -> Box<dyn geometry::Shape> {
        let Self { diameter, length, .. } = *self;
        match self.profile() {
            Some(profile) => Box::new(Revolved::new(profile, Axis::Z)),
            None => Box::new(geometry::Cylinder { diameter, length, axis: Axis::Z }),
        }
    }

    fn sizes(&self) -> Vec<Size> {
        vec![
            Size::across("diameter", self.diameter),
            Size::across("shaft_diameter", self.shaft),
            Size::along("length", self.length, 2),
        ]
    }

    fn conflict(&self) -> Option<Conflict> {
        if self.profile().is_some() {
            return None;
        }
        Some(if self.shaft > self.diameter {
            let message = "the shaft is wider than the base of the cone";
            Conflict::new("shaft_diameter", message, "make it at most `diameter`, or leave it out")
        } else {
            let message = "the cone alone is as long as cone and shaft together";
            Conflict::new("length", message, "make `length` or `cone_angle` larger")
        })
    }

    fn plane_strain_conflict(&self) -> Option<Conflict> {
        Some(Conflict {
            key: "shape",
            message: "shape = \"cone\" cannot be combined with plane_strain = true",
            cure: "remove plane_strain, or choose a blade with bevel = \"both\"",
        })
    }

    fn reference_length(&self) -> f64 {
        self.diameter
    }

    fn reference_width(&self) -> f64 {
        self.diameter
    }

    fn has_flat_sides(&self, _axis: usize) -> bool {
        false
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        let shaft = if self.shaft < self.diameter {
            format!(", shaft of d = {}", length(self.shaft))
        } else {
            String::new()
        };
        let angle = (10.0 * self.apex.to_degrees()).round() / 10.0;
        format!("cone of {angle}°, d = {}{shaft}, l = {}", length(self.diameter), length(self.length))
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Facets { length: self.diameter, width: self.diameter }
    }
}
