//! Names of the case and of its bodies, which become those of files, and how many bodies there may be.

use crate::joint::GROUND;
use input::names::{is_body_name, is_case_name};
use input::problem::Problems;

/// Largest number of layers, and of soil bodies: every one of them is a field of portions in the cells.
const MOST_LAYERS: usize = 20;

/// Largest number of bodies, and of joints; with more, the text and the report become unreadable.
const LARGEST_NUMBER: usize = 500;

/// Reports a name that cannot be that of the results folder.
pub(crate) fn case_name(name: &str, problems: &mut Problems) {
    if !is_case_name(name) {
        let message = format!("\"{name}\" is not a valid name for the results folder");
        let cure = "use 1 to 100 letters, digits, `-` and `_`, but not the name of a Windows device";
        problems.add("name", message, cure);
    }
}

/// Whether a body or a joint may have this name; reported if not.
pub(crate) fn part_name(kind: &str, name: &str, problems: &mut Problems) -> bool {
    let is_ground = kind == "body" && name == GROUND;
    let is_valid = is_body_name(name) && !is_ground;
    if is_ground {
        let message = format!("\"{name}\" is what joints call the ground");
        problems.add(format!("{kind}.{name}"), message, "give the body another name");
    } else if !is_valid {
        let message = format!("\"{name}\" is not a valid name for a {kind}");
        let cure = "use letters, digits, `-` and `_`, but not the name of a Windows device";
        problems.add(format!("{kind}.{name}"), message, cure);
    }
    is_valid
}

fn plural(kind: &str) -> &'static str {
    match kind {
        "layer" => "layers",
        "soil_body" => "soil bodies",
        "body" => "bodies",
        "joint" => "joints",
        _ => "stages",
    }
}

/// Whether there are not too many layers, bodies or joints; reported if there are.
pub(crate) fn number_of(kind: &str, number: usize, problems: &mut Problems) -> bool {
    let (most, cure) = match kind {
        "layer" => (MOST_LAYERS, "join layers that are alike"),
        "soil_body" => (MOST_LAYERS, "join soil bodies that are alike, in a mesh of several parts"),
        _ => (LARGEST_NUMBER, "model fewer of them, or each group in a separate case"),
    };
    if number > most {
        let kinds = plural(kind);
        problems.add(kind, format!("{number} {kinds}; at most {most} are allowed"), cure);
    }
    number <= most
}

/// Reports too many bodies or joints, and names that are not valid or stand for two.
pub(crate) fn parts(kind: &str, names: &[&str], problems: &mut Problems) {
    if !number_of(kind, names.len(), problems) {
        return;
    }
    for (n, name) in names.iter().enumerate() {
        part_name(kind, name, problems);
        if names[..n].contains(name) {
            let kinds = plural(kind);
            let message = format!("two {kinds} are called \"{name}\"");
            problems.add(format!("{kind}.{name}"), message, format!("give each {kind} a name of its own"));
        }
    }
}
