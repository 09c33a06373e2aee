//! The words that a value may be chosen from.

use analytic::wheel::{CMU_SAND, TERRAINS};

/// Body shapes.
pub const SHAPES: [&str; 10] = [
    "disc", "block", "cylinder", "sphere", //
    "cone", "wheel", "blade", "wedge", //
    "mesh", "frame",
];
/// Rims of a disc.
pub const RIMS: [&str; 3] = ["square", "rounded", "bevelled"];
/// Sides from which a rim or an edge is bevelled.
pub const BEVELS: [&str; 5] = ["both", "left", "right", "front", "back"];
/// Sides of a dished disc.
pub const HOLLOWS: [&str; 2] = ["left", "right"];
/// Kinds of joints.
pub const JOINTS: [&str; 6] = ["hinge", "ball", "slider", "spring", "cable", "contact"];
/// Axes of a cylinder.
pub const AXES: [&str; 3] = ["x", "y", "z"];
/// What a table's times count from: their zero, or its first line.
pub const ORIGINS: [&str; 2] = ["zero", FIRST_LINE];
/// The word for the latter.
pub const FIRST_LINE: &str = "first line";
/// Units of the coordinates in the file of a mesh.
pub const MESH_UNITS: [&str; 5] = ["m", "cm", "mm", "in", "ft"];
/// Words for the relative density of sand: about the middle of each class of ISO 14688-2.
pub const DENSITIES: [(&str, f64); 5] =
    [("very loose", 0.1), ("loose", 0.25), ("medium dense", 0.5), ("dense", 0.75), ("very dense", 0.9)];
/// Sections of furrows.
pub const FURROWS: [&str; 2] = ["sinusoidal", "triangular"];
/// Axes along which a grid can follow a body.
pub const FOLLOWED: [&str; 7] = ["x", "y", "z", "xy", "xz", "yz", "xyz"];
/// Flow potentials of the Mohr–Coulomb law.
pub const POTENTIALS: [&str; 2] = ["mohr-coulomb", "menetrey-willam"];
/// Contact methods.
pub const CONTACTS: [&str; 2] = ["penalty", "impulse"];
/// Precisions of the soil's fields.
pub const PRECISIONS: [&str; 2] = ["double", "single"];
/// Boundary conditions of a wall.
pub const WALLS: [&str; 3] = ["smooth", "fixed", "pressure"];
/// Authors of the shape, depth and inclination factors of the bearing capacity model.
pub const FACTORS: [&str; 3] = ["meyerhof", "hansen-vesic", "lyamin"];
/// Soils with published pressure–sinkage parameters.
pub const PUBLISHED_SOILS: [&str; TERRAINS.len() + 1] = {
    let mut names = [CMU_SAND.name; TERRAINS.len() + 1];
    let mut n = 0;
    while n < TERRAINS.len() {
        names[n] = TERRAINS[n].name;
        n += 1;
    }
    names
};
