//! The water over the ground.

use super::context::checked;
use crate::case::missing::required;
use crate::case::problem::Problems;
use crate::case::resolved::Water;
use crate::case::typed::Section;
use crate::case::validate;

/// The water, if the case has any; the outer `None` where it was given wrongly.
#[allow(clippy::option_option)]
pub(super) fn water(section: Option<&Section>, problems: &mut Problems) -> Option<Option<Water>> {
    let Some(section) = section else { return Some(None) };
    if section.has("accept_drained") && !section.has("level") {
        let cure = "leave out --accept-drained, or add a section [water] with a `level`";
        problems.add(section.at("accept_drained"), "without water there is nothing to drain", cure);
        return None;
    }
    let optional = |key: &str| match section.has(key) {
        true => section.number(key).map(Some),
        false => Some(None),
    };
    let water = Water {
        level: required(section, "level", problems)?,
        density: section.number("density")?,
        grain_density: section.number("grain_density")?,
        permeability: optional("permeability")?,
        volume_strain: optional("volume_strain")?,
        pore_pressure: section.flag("pore_pressure")?,
        drag_coefficient: section.number("drag_coefficient")?,
        accept_drained: section.flag("accept_drained")?,
    };
    checked(water, problems, validate::water::numbers).map(Some)
}
