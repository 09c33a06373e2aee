//! The wedge: a triangular prism, such as a share.

use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Size};
use super::widths::{self, WIDE};
use crate::key::required;
use geometry::{self, Extruded};
use glam::DVec3;
use input::key::{KeyOf, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A right-angled wedge: base level, back upright, its edge in front (+x) at the bottom.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Wedge {
    /// Edge lengths of the box round the wedge [m]: length, width, height.
    pub size: DVec3,
}

impl Wedge {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[
        field("length", Place::Number(|wedge| &mut wedge.size.x)),
        field("width", Place::Number(|wedge| &mut wedge.size.y)),
        field("height", Place::Number(|wedge| &mut wedge.size.z)),
    ];

    /// Reads a wedge; in plane strain it is as wide as the slab.
    pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        let width = widths::across(section, "width", WIDE, slab, problems);
        let [length, height] = ["length", "height"].map(|key| required(KEYS, section, key, problems));
        Some(Self { size: DVec3::new(length?, width?, height?) })
    }
}

impl CaseShape for Wedge {
    fn solid(&self) -> Box<dyn geometry::Shape> {
        Box::new(Extruded::new(geometry::wedge(self.size.x, self.size.z), self.size.y))
    }

    fn sizes(&self) -> Vec<Size> {
        let keys = ["length", "width", "height"];
        (0..3).map(|axis| Size::along(keys[axis], self.size[axis], axis)).collect()
    }

    /// Height of the wedge.
    fn reference_length(&self) -> f64 {
        self.size.z
    }

    fn reference_width(&self) -> f64 {
        self.size.y
    }

    fn has_flat_sides(&self, axis: usize) -> bool {
        axis == 1
    }

    fn is_mirrored(&self, axis: usize) -> bool {
        axis != 0
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        let [long, width, height] = self.size.to_array().map(length);
        format!("wedge, {long} long, {width} wide, {height} high")
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Facets { length: self.size.z, width: self.size.y }
    }
}
