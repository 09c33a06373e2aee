//! Bodies of soil of another kind.

use super::body::attitude;
use super::context::{Context, checked};
use super::soil::{self, Conditions};
use crate::missing::{missing, required};
use crate::resolved::SoilBody;
use crate::shapes;
use crate::validate;
use glam::DVec3;
use input::problem::Problems;
use input::typed::Section;

/// All soil bodies, or `None` if any of them is wrong; on soil weighs this per mass [m/s²].
pub(super) fn soil_bodies(
    sections: &[Section],
    context: &Context,
    on_soil: f64,
    problems: &mut Problems,
) -> Option<Vec<SoilBody>> {
    let all: Vec<_> = sections.iter().map(|section| soil_body(section, context, on_soil, problems)).collect();
    all.into_iter().collect()
}

fn soil_body(
    section: &Section,
    context: &Context,
    on_soil: f64,
    problems: &mut Problems,
) -> Option<SoilBody> {
    if !section.has("shape") {
        missing(section, "shape", problems);
    }
    let shape = shapes::read(section, context.slab, problems);
    let elevation = required(section, "elevation", problems);
    let soil = soil::soil(section, Conditions { gravity: on_soil, slope: context.slope }, problems);
    let middle = context.slab.filter(|_| !section.has("y")).map(|slab| slab.middle);
    let y = middle.or_else(|| section.number("y"));
    let position = DVec3::new(section.number("x")?, y?, context.surface + elevation?);
    let name = section.path.trim_start_matches("soil_body.").to_owned();
    let body = SoilBody { name, shape: shape?, position, attitude: attitude(section)?, soil: soil? };
    checked(body, problems, |body, problems| {
        validate::relief::soil_body(body, context.slab.is_some(), problems);
    })
}
