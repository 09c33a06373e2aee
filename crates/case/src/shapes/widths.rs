//! The width of a body that is a prism or a body of revolution along y.

use super::keys::KEYS;
use super::slab::Slab;
use crate::key::required;
use input::problem::Problems;
use input::typed::Section;

/// What is said of a body with a `width`.
pub(super) const WIDE: &str = "a body is as wide as the slab";

/// Width of a body along y [m]: that of a key, or in plane strain that of the slab, which is `said` of it.
pub(super) fn across(
    section: &Section,
    key: &str,
    said: &str,
    slab: Option<Slab>,
    problems: &mut Problems,
) -> Option<f64> {
    match slab {
        None => required(KEYS, section, key, problems),
        Some(slab) if !section.has(key) => Some(slab.covering_width()),
        Some(_) => {
            let message = format!("in plane strain {said}");
            problems.add(section.at(key), message, format!("remove `{key}`"));
            None
        }
    }
}
