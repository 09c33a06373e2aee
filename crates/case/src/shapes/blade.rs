//! The blade: an upright plate, square or sharpened at its lower end.

use super::bevel::{self, Sides};
use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use super::widths::{self, WIDE};
use crate::key::required;
use geometry::{self, Bevel, Extruded, Profile};
use glam::DVec3;
use input::key::{KeyOf, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A blade across the tow: its faces look along x.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Blade {
    /// Edge lengths of the box round the blade [m]: thickness, width, height.
    pub size: DVec3,
    /// How the lower end of the blade is sharpened; `None` if it is square.
    pub cutting_edge: Option<CuttingEdge>,
}

/// The sharpened lower end of a blade.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CuttingEdge {
    /// Angle between the bevel and the face that it cuts [rad].
    pub angle: f64,
    /// Thickness of the edge [m]; 0 for a knife edge.
    pub thickness: f64,
    /// The faces that are cut: the low one is the back.
    pub bevel: Bevel,
}

impl Blade {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[
        field("thickness", Place::Number(|blade| &mut blade.size.x)),
        field("width", Place::Number(|blade| &mut blade.size.y)),
        field("height", Place::Number(|blade| &mut blade.size.z)),
        field("bevel_angle", Place::Part(|blade| blade.cutting_edge.as_mut().map(|edge| &mut edge.angle))),
        field(
            "edge_thickness",
            Place::Part(|blade| blade.cutting_edge.as_mut().map(|edge| &mut edge.thickness)),
        ),
        field("bevel", Place::Elsewhere),
    ];

    /// Reads a blade; in plane strain it is as wide as the slab.
    pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        let width = widths::across(section, "width", WIDE, slab, problems);
        let [height, thickness] = ["height", "thickness"].map(|key| required(KEYS, section, key, problems));
        let is_sharp = section.has("bevel_angle");
        for key in ["bevel", "edge_thickness"].into_iter().filter(|key| section.has(key) && !is_sharp) {
            let message = format!("`{key}` applies to a blade with a bevel only");
            problems.add(section.at(key), message, "remove it, or add  bevel_angle = \"20 deg\"");
        }
        let cutting_edge = if is_sharp {
            let sides = Sides { low: "back", high: "front", usual: Bevel::Low };
            let bevel = bevel::read(section, &sides, problems)?;
            let (angle, thickness) = (section.number("bevel_angle")?, section.number("edge_thickness")?);
            Some(CuttingEdge { angle, thickness, bevel })
        } else {
            None
        };
        Some(Self { size: DVec3::new(thickness?, width?, height?), cutting_edge })
    }

    fn profile(&self) -> Option<Profile> {
        let sharpened = self.cutting_edge.map(|edge| (edge.angle, edge.thickness, edge.bevel));
        geometry::blade([self.size.x, self.size.z], sharpened)
    }
}

impl CaseShape for Blade {
    /// The solid of the blade: a square one is a block, and so is shown one whose lengths exclude each other.
    fn solid(&self) -> Box<dyn geometry::Shape> {
        match self.profile() {
            Some(profile) if self.cutting_edge.is_some() => Box::new(Extruded::new(profile, self.size.y)),
            _ => Box::new(geometry::Block { size: self.size }),
        }
    }

    fn sizes(&self) -> Vec<Size> {
        let keys = ["thickness", "width", "height"];
        (0..3).map(|axis| Size::along(keys[axis], self.size[axis], axis)).collect()
    }

    fn conflict(&self) -> Option<Conflict> {
        if self.profile().is_some() {
            return None;
        }
        Some(if self.cutting_edge.is_some_and(|edge| edge.thickness >= self.size.x) {
            let message = "the edge is as thick as the blade, so that there is no bevel";
            Conflict::new("edge_thickness", message, "make it less than `thickness`, or remove `bevel_angle`")
        } else {
            let message = "the bevel is as high as the blade or higher";
            Conflict::new("bevel_angle", message, "make `bevel_angle` or `edge_thickness` larger")
        })
    }

    /// Height of the blade.
    fn reference_length(&self) -> f64 {
        self.size.z
    }

    fn reference_width(&self) -> f64 {
        self.size.y
    }

    fn has_flat_sides(&self, axis: usize) -> bool {
        axis != 2 || self.cutting_edge.is_none()
    }

    fn is_mirrored(&self, axis: usize) -> bool {
        axis != 0 || self.cutting_edge.is_none_or(|edge| edge.bevel == Bevel::Both)
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        let [thickness, width, height] = self.size.to_array().map(length);
        let edge = self.cutting_edge.map_or_else(String::new, |edge| {
            let side = match edge.bevel {
                Bevel::Both => "on both sides",
                Bevel::Low => "at the back",
                Bevel::High => "in front",
            };
            format!(", {side} {}", bevel::describe(edge.angle, edge.thickness, length))
        });
        format!("blade, {width} wide, {height} high, {thickness} thick{edge}")
    }

    fn closed_form(&self) -> ClosedForm {
        match self.cutting_edge {
            None => ClosedForm::Block { size: self.size },
            Some(_) => ClosedForm::Facets { length: self.size.z, width: self.size.y },
        }
    }
}
