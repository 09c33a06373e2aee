//! The relief of the ground: a height map from a file, and furrows.

use super::context::checked;
use crate::missing::{missing, range};
use crate::relief::{Furrows, Relief};
use crate::typed_case::Schema;
use input::height_file::{HeightFile, Placement};
use input::problem::Problems;
use input::quantity::{self, LENGTH};
use input::typed::Section;

/// The relief, level where the case has neither section; `None` where one was given wrongly.
pub(super) fn relief(schema: &Schema, problems: &mut Problems) -> Option<Relief> {
    let map = schema.height_map.as_ref().map(|section| height_map(section, problems));
    let furrows = schema.furrows.as_ref().map(|section| Furrows::typed(section, problems));
    let relief = Relief {
        map: map.map_or(Some(None), |map| map.map(Some))?,
        furrows: furrows.map_or(Some(None), |furrows| furrows.map(Some))?,
    };
    checked(relief, problems, |relief, problems| relief.furrows.iter().for_each(|f| f.check(problems)))
}

fn height_map(section: &Section, problems: &mut Problems) -> Option<HeightFile> {
    if !section.has("file") {
        missing(section, "file", problems);
    }
    let mut ends = |key: &str| match section.has(key) {
        true => range(section, key, None, problems).map(Some),
        false => Some(None),
    };
    let (x, y, heights) = (ends("x")?, ends("y")?, ends("heights")?);
    let origin = match section.has("origin") {
        true => Some(origin(section, problems)?),
        false => None,
    };
    let unit = match section.has("unit") {
        true => Some(quantity::parse(&format!("1 {}", section.text("unit")?), &LENGTH).ok()?),
        false => None,
    };
    let placement = Placement { unit, ends: [x, y], heights, origin, datum: section.number("datum")? };
    let file = section.text("file")?;
    match HeightFile::load(&section.folder, &file, &placement) {
        Ok(map) => {
            map.remarks().iter().for_each(|remark| problems.remark(format!("height_map: {file}: {remark}")));
            Some(map)
        }
        Err(problem) => {
            problems.add(section.at("file"), format!("{file}: {}", problem.message), problem.cure);
            None
        }
    }
}

fn origin(section: &Section, problems: &mut Problems) -> Option<[f64; 2]> {
    let given = section.list("origin")?;
    let [x, y] = given[..] else {
        let message = format!("a point of {} coordinates", given.len());
        problems.add(section.at("origin"), message, "give its x and y in the coordinates of the file");
        return None;
    };
    Some([x, y])
}
