//! Names of the case and of its bodies, which become those of files, and how many bodies there may be.

use crate::case::names::{is_body_name, is_case_name};
use crate::case::problem::Problems;
use crate::case::resolved::Body;

/// Largest number of bodies; with more, the text and the report become unreadable.
const MAX_BODIES: usize = 500;

/// Reports a name that cannot be that of the results folder.
pub(in crate::case) fn case_name(name: &str, problems: &mut Problems) {
    if !is_case_name(name) {
        let message = format!("\"{name}\" is not a valid name for the results folder");
        let cure = "use 1 to 100 letters, digits, `-` and `_`, but not the name of a Windows device";
        problems.add("name", message, cure);
    }
}

/// Whether a body may have this name; reported if not.
pub(in crate::case) fn body_name(name: &str, problems: &mut Problems) -> bool {
    let is_valid = is_body_name(name);
    if !is_valid {
        let message = format!("\"{name}\" is not a valid name for a body");
        let cure = "use letters, digits, `-` and `_`, but not the name of a Windows device";
        problems.add(format!("body.{name}"), message, cure);
    }
    is_valid
}

/// Whether there are not too many bodies; reported if there are.
pub(in crate::case) fn number_of_bodies(number: usize, problems: &mut Problems) -> bool {
    if number > MAX_BODIES {
        let message = format!("{number} bodies; at most {MAX_BODIES} are allowed");
        problems.add("body", message, "model fewer of them, or each group in a separate case");
    }
    number <= MAX_BODIES
}

/// Reports too many bodies, and names that are not valid or stand for two bodies.
pub(super) fn bodies(bodies: &[Body], problems: &mut Problems) {
    if !number_of_bodies(bodies.len(), problems) {
        return;
    }
    for (n, body) in bodies.iter().enumerate() {
        body_name(&body.name, problems);
        if bodies[..n].iter().any(|other| other.name == body.name) {
            let message = format!("two bodies are called \"{}\"", body.name);
            problems.add(format!("body.{}", body.name), message, "give each body a name of its own");
        }
    }
}
