//! Layers of the ground below the uppermost soil.

use crate::key::all;
use crate::key::allowed::POSITIVE;
use crate::soil::{Conditions, KEYS as SOIL, Soil, soil};
use input::key::{Key, KeyOf, Kind, Place, count, declared, in_ranges, joined, numbers, required};
use input::problem::Problems;
use input::quantity::LENGTH;
use input::typed::Section;
use serde::Serialize;

/// A layer of the ground below the uppermost soil.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Layer {
    /// Name of the layer.
    pub name: String,
    /// Depth of the top of the layer below the surface [m].
    pub top: f64,
    /// Soil of the layer.
    pub soil: Soil,
}

/// Keys of a layer but for its soil, and where their values lie.
const FIELDS: &[KeyOf<Layer>] =
    &[KeyOf::new("top", Kind::Quantity(LENGTH), Place::Number(|layer: &mut Layer| &mut layer.top))
        .within(POSITIVE)
        .means("Depth of the top of the layer below the surface.")];

const LISTS: &[&[Key]] = &[&declared::<_, { FIELDS.len() }>(FIELDS), SOIL];

impl Layer {
    pub(crate) const KEYS: &[Key] = &joined::<{ count(LISTS) }>(LISTS);

    /// The layers from the top down, or `None` with problems added.
    pub(crate) fn all(
        sections: &[Section],
        conditions: Conditions,
        problems: &mut Problems,
    ) -> Option<Vec<Self>> {
        let layer = |section: &Section| {
            let top = required(FIELDS, "top", section, problems);
            let soil = soil(section, conditions, problems);
            let name = section.path.trim_start_matches("layer.").to_owned();
            Some(Self { name, top: top?, soil: soil? })
        };
        let mut layers = all(sections, layer)?;
        layers.sort_by(|a, b| a.top.total_cmp(&b.top));
        Some(layers)
    }

    /// Path of the layer's section.
    pub(crate) fn path(&self) -> String {
        format!("layer.{}", self.name)
    }

    /// Reports numbers that are out of range, but for those of its soil.
    pub(crate) fn check(&self, problems: &mut Problems) {
        in_ranges(&self.path(), &numbers(FIELDS, self), problems);
    }
}
