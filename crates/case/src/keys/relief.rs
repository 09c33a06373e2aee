//! Keys of ground that is not level, and of bodies of other soil in it.

use super::body::BODY;
use crate::keys::allowed::TILT;
use crate::keys::words::MESH_UNITS;
use crate::soil::KEYS as SOIL;
use input::key::DefaultValue::{Derived, Quantity, Required};
use input::key::{Key, Kind, key};
use input::quantity::{ANGLE, LENGTH};

pub(super) const HEIGHT_MAP: &[Key] = &[
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

/// Number of keys that describe a shape: those of a body up to the file of its mesh.
pub const SHAPE_KEYS: usize = {
    let mut n = 0;
    while !is_unit(BODY[n].name) {
        n += 1;
    }
    n + 1
};

const fn is_unit(name: &str) -> bool {
    matches!(name.as_bytes(), b"unit")
}

/// Place and attitude of a soil body.
const PLACED: [Key; 6] = [
    key("x", Kind::Quantity(LENGTH), Quantity("0 m"), "Position of its centre along x."),
    key("y", Kind::Quantity(LENGTH), Quantity("0 m"), "Position of its centre along y."),
    key(
        "elevation",
        Kind::Quantity(LENGTH),
        Required,
        "Height of its centre over `ground.surface`; negative for one in the ground.",
    ),
    key("yaw", Kind::Quantity(ANGLE), Quantity("0 deg"), "Rotation about z, as of a body."),
    key("tilt", Kind::Quantity(ANGLE), Quantity("0 deg"), "Rotation about x, as of a body.").within(TILT),
    key("pitch", Kind::Quantity(ANGLE), Quantity("0 deg"), "Rotation about y, as of a body."),
];

/// Number of keys of a soil body that are not those of a body's shape or of a soil.
pub const PLACE_KEYS: usize = PLACED.len();

/// Keys of a soil body: its place, the shape, and those of a soil.
pub(super) const SOIL_BODY: &[Key] = &{
    let mut keys = [PLACED[0]; PLACE_KEYS + SHAPE_KEYS + SOIL.len()];
    let mut n = 0;
    while n < keys.len() {
        keys[n] = if n < PLACE_KEYS {
            PLACED[n]
        } else if n < PLACE_KEYS + SHAPE_KEYS {
            BODY[n - PLACE_KEYS]
        } else {
            SOIL[n - PLACE_KEYS - SHAPE_KEYS]
        };
        n += 1;
    }
    keys
};
