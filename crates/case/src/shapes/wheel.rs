//! The wheel with grousers.

use super::keys::{KEYS, field, named};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use super::widths;
use crate::key::required;
use geometry::{self, Extruded, Grousers, Profile};
use input::key::{KeyOf, Numbers, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A wheel with grousers, axle along y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Wheel {
    /// Diameter d of the rim, between the grousers [m].
    pub diameter: f64,
    /// Width t along the axle [m].
    pub thickness: f64,
    /// Grousers of the wheel, straight and as wide as it is.
    pub grousers: Grousers,
}

impl Wheel {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[
        field("diameter", Place::Number(|wheel| &mut wheel.diameter)),
        field("thickness", Place::Number(|wheel| &mut wheel.thickness)),
        field("grouser_height", Place::Number(|wheel| &mut wheel.grousers.height)),
        field("grouser_thickness", Place::Number(|wheel| &mut wheel.grousers.thickness)),
        field("grousers", Place::Elsewhere),
    ];

    /// Reads a wheel; in plane strain it is as wide as the slab.
    pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        let diameter = required(KEYS, section, "diameter", problems);
        let thickness =
            widths::across(section, "thickness", "a wheel is as thick as the slab is wide", slab, problems);
        let [number, height, bar] = ["grousers", "grouser_height", "grouser_thickness"]
            .map(|key| required(KEYS, section, key, problems));
        // The range of the key leaves only whole numbers that fit.
        let grousers = Grousers { number: number? as u32, height: height?, thickness: bar? };
        Some(Self { diameter: diameter?, thickness: thickness?, grousers })
    }

    fn profile(&self) -> Option<Profile> {
        geometry::wheel(self.diameter, self.grousers)
    }
}

impl CaseShape for Wheel {
    /// The solid of the wheel; one whose grousers do not fit is shown without them.
    fn solid(&self) -> Box<dyn geometry::Shape> {
        match self.profile() {
            Some(profile) => Box::new(Extruded::new(profile, self.thickness)),
            None => Box::new(geometry::Disc { diameter: self.diameter, thickness: self.thickness }),
        }
    }

    fn sizes(&self) -> Vec<Size> {
        vec![
            Size::across("diameter", self.diameter),
            Size::along("thickness", self.thickness, 1),
            Size::across("grouser_height", self.grousers.height),
            Size::across("grouser_thickness", self.grousers.thickness),
        ]
    }

    fn other_numbers(&self) -> Numbers {
        vec![(named("grousers"), f64::from(self.grousers.number))]
    }

    fn conflict(&self) -> Option<Conflict> {
        let message = "the grousers do not fit side by side on the rim";
        let cure = "make them thinner or fewer, or the wheel larger";
        self.profile().is_none().then(|| Conflict::new("grouser_thickness", message, cure))
    }

    fn reference_length(&self) -> f64 {
        self.diameter
    }

    fn reference_width(&self) -> f64 {
        self.thickness
    }

    /// Diameter of the rim [m], as slip is usually stated for wheels with grousers.
    fn rolling_diameter(&self) -> Option<f64> {
        Some(self.diameter)
    }

    fn has_flat_sides(&self, axis: usize) -> bool {
        axis == 1
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        let Grousers { number, height, thickness } = self.grousers;
        let [diameter, width, height, bar] = [self.diameter, self.thickness, height, thickness].map(length);
        format!("wheel, d = {diameter}, t = {width}, {number} grousers of {height} × {bar}")
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Facets { length: self.diameter, width: self.thickness }
    }
}
