//! The disc: flat or dished, with any rim.

use super::bevel::{self, Sides};
use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use super::widths;
use crate::key::{part, required};
use geometry::{self, Axis, Bevel, DiscRim, Dish, Profile, Revolved};
use input::key::{KeyOf, Place};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;

/// A disc, axle along y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Disc {
    /// Diameter d [m].
    pub diameter: f64,
    /// Thickness t [m].
    pub thickness: f64,
    /// Rim of the disc.
    pub rim: DiscRim,
    /// How the disc is dished; `None` if it is flat.
    pub dish: Option<Dish>,
}

impl Disc {
    pub(super) const FIELDS: &[KeyOf<Self>] = &[
        field("diameter", Place::Number(|disc| &mut disc.diameter)),
        field("thickness", Place::Number(|disc| &mut disc.thickness)),
        field("rim", Place::Elsewhere),
        field("rim_radius", part!(rim, DiscRim::Rounded, radius)),
        field("bevel_angle", part!(rim, DiscRim::Bevelled, angle)),
        field("edge_thickness", part!(rim, DiscRim::Bevelled, edge)),
        field("bevel", Place::Elsewhere),
        field("concavity", Place::Part(|disc| disc.dish.as_mut().map(|dish| &mut dish.depth))),
        field("hollow", Place::Elsewhere),
    ];

    /// Reads a disc; in plane strain it is as thick as the slab is wide.
    pub(super) fn read(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        let diameter = required(KEYS, section, "diameter", problems);
        let thickness =
            widths::across(section, "thickness", "a disc is as thick as the slab is wide", slab, problems);
        let rim = rim(section, thickness, problems);
        if section.has("hollow") && !section.has("concavity") {
            let message = "`hollow` applies to a dished disc only";
            problems.add(section.at("hollow"), message, "remove it, or add  concavity = \"30 mm\"");
        }
        let dish = if section.has("concavity") {
            let hollow_is_left = section.text("hollow")? == "left";
            Some(Dish { depth: section.number("concavity")?, hollow_is_left })
        } else {
            None
        };
        Some(Self { diameter: diameter?, thickness: thickness?, rim: rim?, dish })
    }

    /// The profile that is revolved about the axle; `None` where the lengths exclude each other.
    fn profile(&self) -> Option<Profile> {
        geometry::disc(self.diameter, self.thickness, self.rim, self.dish)
    }

    /// Whether the disc is a flat cylinder.
    fn is_plain(&self) -> bool {
        self.rim == DiscRim::Square && self.dish.is_none()
    }
}

/// The rim of a disc of this thickness [m].
fn rim(section: &Section, thickness: Option<f64>, problems: &mut Problems) -> Option<DiscRim> {
    let word = section.text("rim")?;
    let belongs = [
        ("rim_radius", "rounded"),
        ("bevel_angle", "bevelled"),
        ("bevel", "bevelled"),
        ("edge_thickness", "bevelled"),
    ];
    for (key, rim) in belongs.into_iter().filter(|(key, rim)| section.has(key) && *rim != word) {
        let message = format!("`{key}` does not apply to rim = \"{word}\"");
        problems.add(section.at(key), message, format!("remove it, or write rim = \"{rim}\""));
    }
    match word.as_str() {
        "rounded" => {
            let radius = section.number_or("rim_radius", 0.5 * thickness?)?;
            Some(DiscRim::Rounded { radius })
        }
        "bevelled" => {
            let angle = required(KEYS, section, "bevel_angle", problems);
            let sides = Sides { low: "right", high: "left", usual: Bevel::Both };
            let bevel = bevel::read(section, &sides, problems);
            Some(DiscRim::Bevelled { angle: angle?, edge: section.number("edge_thickness")?, bevel: bevel? })
        }
        _ => Some(DiscRim::Square),
    }
}

impl CaseShape for Disc {
    /// The solid of the disc; one whose lengths exclude each other is shown as a plain disc.
    fn solid(&self) -> Box<dyn geometry::Shape> {
        match self.profile() {
            Some(profile) if !self.is_plain() => Box::new(Revolved::new(profile, Axis::Y)),
            _ => Box::new(geometry::Disc { diameter: self.diameter, thickness: self.thickness }),
        }
    }

    fn sizes(&self) -> Vec<Size> {
        vec![Size::across("diameter", self.diameter), Size::along("thickness", self.thickness, 1)]
    }

    fn conflict(&self) -> Option<Conflict> {
        if self.is_plain() || self.profile().is_some() {
            return None;
        }
        let conflict = |key, message, cure| Some(Conflict::new(key, message, cure));
        let too_deep = self.dish.filter(|dish| dish.depth >= 0.5 * self.diameter);
        match self.rim {
            _ if too_deep.is_some() => conflict(
                "concavity",
                "the hollow is as deep as a hemisphere or deeper",
                "make `concavity` less than half the diameter",
            ),
            DiscRim::Rounded { .. } if self.dish.is_some() => {
                conflict("rim", "a dished disc has no rounded rim", "write rim = \"square\" or \"bevelled\"")
            }
            DiscRim::Rounded { .. } => conflict(
                "rim_radius",
                "the rounding is larger than half the thickness, or than the radius of the disc",
                "make it smaller; without `rim_radius` it is half the thickness",
            ),
            DiscRim::Bevelled { edge, .. } if edge >= self.thickness => conflict(
                "edge_thickness",
                "the edge is as thick as the disc, so that there is no bevel",
                "make it less than `thickness`, or write rim = \"square\"",
            ),
            _ => conflict(
                "bevel_angle",
                "the bevel is wider than the disc",
                "make `bevel_angle` or `edge_thickness` larger",
            ),
        }
    }

    fn plane_strain_conflict(&self) -> Option<Conflict> {
        let key = if self.dish.is_some() { "concavity" } else { "rim" };
        (!self.is_plain()).then_some(Conflict {
            key,
            message: "in plane strain a disc is a slice between two planes: flat, with a square rim",
            cure: "remove it, or model the disc in 3D",
        })
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
        axis == 1 && self.dish.is_none()
    }

    fn is_mirrored(&self, axis: usize) -> bool {
        let one_sided = matches!(self.rim, DiscRim::Bevelled { bevel: Bevel::Low | Bevel::High, .. });
        axis != 1 || (self.dish.is_none() && !one_sided)
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        let mut text = format!("disc, d = {}, t = {}", length(self.diameter), length(self.thickness));
        match self.rim {
            DiscRim::Square => {}
            DiscRim::Rounded { radius } => text += &format!(", rim rounded to r = {}", length(radius)),
            DiscRim::Bevelled { angle, edge, bevel } => {
                let side = match bevel {
                    Bevel::Both => "on both sides",
                    Bevel::Low => "on the right",
                    Bevel::High => "on the left",
                };
                text += &format!(", rim {side} {}", bevel::describe(angle, edge, length));
            }
        }
        if let Some(Dish { depth, hollow_is_left }) = self.dish {
            let side = if hollow_is_left { "left" } else { "right" };
            text += &format!(", hollow by {} on the {side}", length(depth));
        }
        text
    }

    /// The models of discs know neither a bevel nor a hollow, which change where soil is cut and how it is
    /// turned.
    fn closed_form(&self) -> ClosedForm {
        let Self { diameter, thickness, .. } = *self;
        match self.rim {
            DiscRim::Square | DiscRim::Rounded { .. } if self.dish.is_none() => {
                ClosedForm::Disc { diameter, thickness }
            }
            _ => ClosedForm::Facets { length: diameter, width: thickness },
        }
    }

    fn closed_form_note(&self) -> Option<&'static str> {
        let is_rounded = matches!(self.rim, DiscRim::Rounded { .. });
        is_rounded.then_some("the models of discs take its rounded rim for a square one")
    }
}
