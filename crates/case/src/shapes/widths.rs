//! The width of a body that is a prism along y.

use super::slab::Slab;
use crate::missing::required;
use input::problem::Problems;
use input::typed::Section;

/// Width of a body [m]: the key `width`, or in plane strain that of the slab.
pub(super) fn across(section: &Section, slab: Option<Slab>, problems: &mut Problems) -> Option<f64> {
    match slab {
        None => required(section, "width", problems),
        Some(slab) if !section.has("width") => Some(slab.covering_width()),
        Some(_) => {
            let message = "in plane strain a body is as wide as the slab";
            problems.add(section.at("width"), message, "remove `width`");
            None
        }
    }
}
