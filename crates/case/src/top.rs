//! What stands at the top of the file: the name of the case and its gravity.

use crate::key::allowed::NOT_NEGATIVE;
use crate::key::checked;
use crate::key::usual::GRAVITY as USUAL;
use crate::names;
use input::key::DefaultValue::{Derived, Quantity, Required};
use input::key::{Key, Kind, key};
use input::names::case_name;
use input::problem::Problems;
use input::quantity::ACCELERATION;
use input::typed::Section;

const GRAVITY: Key = key(
    "gravity",
    Kind::Quantity(ACCELERATION),
    Quantity("9.81 m/s^2"),
    "Acceleration of gravity, downwards.",
)
.within(NOT_NEGATIVE)
.usually(USUAL);

/// Keys at the top of the file.
pub(crate) const KEYS: &[Key] = &[
    key("format", Kind::Format, Required, "Version of the case-file format."),
    key(
        "name",
        Kind::Text,
        Derived("the name of the file"),
        "Name of the results folder: letters, digits, `-` and `_`.",
    ),
    key("title", Kind::Text, Derived("the name"), "One line for the report."),
    GRAVITY,
];

/// The name of the case, which becomes that of a folder.
pub(crate) fn name(top: &Section, source_name: &str, problems: &mut Problems) -> Option<String> {
    let name = if top.has("name") { top.text("name")? } else { case_name(source_name) };
    checked(name, problems, |name, problems| names::case_name(name, problems))
}

/// Whether an acceleration of gravity [m/s²] is one; reported if not.
pub(crate) fn check_gravity(gravity: f64, problems: &mut Problems) -> bool {
    GRAVITY.admits(GRAVITY.name, gravity, problems)
}
