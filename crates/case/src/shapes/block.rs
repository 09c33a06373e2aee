//! The block.

use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Size};
use crate::key::missing;
use glam::DVec3;
use input::key::{KeyOf, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A rectangular block.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Block {
    /// Edge lengths [m].
    pub size: DVec3,
}

impl Block {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[
        field("size", Place::Number(|block| &mut block.size.x)),
        field("size", Place::Number(|block| &mut block.size.y)),
        field("size", Place::Number(|block| &mut block.size.z)),
    ];

    /// Reads a block; in plane strain it is as wide as the slab.
    pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        missing(KEYS, section, "size", problems);
        let edges = section.list("size")?;
        let size = match (edges.as_slice(), slab) {
            (&[x, z], Some(slab)) => DVec3::new(x, slab.covering_width(), z),
            (&[x, y, z], None) => DVec3::new(x, y, z),
            (_, slab) => {
                let cure = if slab.is_some() {
                    "in plane strain give two edges, along x and z"
                } else {
                    "give three edges, along x, y and z (two only with plane_strain = true)"
                };
                let message = format!("{} edges are not possible here", edges.len());
                problems.add(section.at("size"), message, cure);
                return None;
            }
        };
        Some(Self { size })
    }
}

impl CaseShape for Block {
    fn solid(&self) -> Box<dyn geometry::Shape> {
        Box::new(geometry::Block { size: self.size })
    }

    fn sizes(&self) -> Vec<Size> {
        (0..3).map(|axis| Size::along("size", self.size[axis], axis)).collect()
    }

    /// Height of the block.
    fn reference_length(&self) -> f64 {
        self.size.z
    }

    fn reference_width(&self) -> f64 {
        self.size.y
    }

    fn has_flat_sides(&self, _axis: usize) -> bool {
        true
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        let [x, y, z] = self.size.to_array().map(length);
        format!("block, {x} × {y} × {z}")
    }

    fn closed_form(&self) -> ClosedForm {
        ClosedForm::Block { size: self.size }
    }
}
