//! A height map of the ground, from a file.

use crate::key::words::MESH_UNITS;
use crate::key::{missing, range};
use input::height_file::{HeightFile, Placement};
use input::key::DefaultValue::{Derived, Quantity, Required};
use input::key::{Key, Kind, key};
use input::problem::Problems;
use input::quantity::{self, LENGTH};
use input::typed::Section;

/// Keys of a height map.
pub(crate) const KEYS: &[Key] = &[
    key(
        "file",
        Kind::Text,
        Required,
        "File with heights, relative to the folder of the case file: table (CSV), ESRI grid, points (.xyz), TIFF (GeoTIFF) or PNG. See *Uneven ground*.",
    ),
    key(
        "unit",
        Kind::Choice(&MESH_UNITS),
        Derived(
            "that which a TIFF states; required for a TIFF that states none, and for CSV without a header; metres for .asc \
             and .xyz",
        ),
        "Unit of the heights in a file that does not name it.",
    ),
    key(
        "x",
        Kind::Range(LENGTH),
        Derived("from the file; required for PNG, CSV without a header, TIFF without coordinates"),
        "Where the first and the last column lie: of an image the middles of its outer pixels.",
    ),
    key(
        "y",
        Kind::Range(LENGTH),
        Derived("as for x"),
        "Where the last and the first row lie: the first row of an image, or of a grid, is that of the largest y.",
    ),
    key(
        "heights",
        Kind::Range(LENGTH),
        Derived("required for PNG"),
        "Heights of black and white over `ground.surface`.",
    ),
    key(
        "origin",
        Kind::Vector(LENGTH),
        Derived("0 m, 0 m"),
        "The point of the file, in its coordinates, that is x = y = 0 of the case; of a file that has coordinates.",
    ),
    key("datum", Kind::Quantity(LENGTH), Quantity("0 m"), "Height in the file that is `ground.surface`."),
];

/// The map that a section names.
pub(crate) fn height_map(section: &Section, problems: &mut Problems) -> Option<HeightFile> {
    missing(KEYS, section, "file", problems);
    let mut ends = |key: &str| match section.has(key) {
        true => range(KEYS, section, key, None, problems).map(Some),
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
