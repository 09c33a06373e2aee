//! A whole case as typed: its sections.

use input::typed::Section;
use std::path::Path;

/// A whole case as typed.
#[derive(Clone, Debug)]
pub(crate) struct Schema {
    pub(crate) top: Section,
    /// `None` where the case has no such section.
    pub(crate) water: Option<Section>,
    pub(crate) soil: Section,
    pub(crate) ground: Section,
    pub(crate) height_map: Option<Section>,
    pub(crate) furrows: Option<Section>,
    pub(crate) domain: Section,
    pub(crate) grid: Section,
    pub(crate) bodies: Vec<Section>,
    pub(crate) layers: Vec<Section>,
    pub(crate) soil_bodies: Vec<Section>,
    pub(crate) joints: Vec<Section>,
    pub(crate) stages: Vec<Section>,
    pub(crate) run: Section,
    pub(crate) output: Section,
    pub(crate) numerics: Section,
    pub(crate) forecast: Section,
}

impl Schema {
    /// Says in which folder the files lie that the case names.
    pub(crate) fn lie_in(&mut self, folder: &Path) {
        let in_stages = self.stages.iter_mut().flat_map(|stage| &mut stage.inner);
        let of_ground = self.soil_bodies.iter_mut().chain(&mut self.height_map);
        for section in self.bodies.iter_mut().chain(in_stages).chain(of_ground) {
            section.folder = folder.to_path_buf();
        }
    }
}
