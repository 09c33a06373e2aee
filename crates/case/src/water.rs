//! Water over the ground: its properties, and what soil and bodies weigh in it.

use super::shapes::slab::PLANE_STRAIN_WIDTH;
use crate::key::allowed::{NOT_NEGATIVE, POSITIVE, VOLUME_STRAIN};
use crate::key::usual::{GRAIN_DENSITY, PERMEABILITY, WATER_DENSITY};
use DefaultValue::{Flag, Number, Quantity};
use geometry::Shape as Solid;
use glam::DVec3;
use input::key::{DefaultValue, Key, KeyOf, Kind, Place, declared, in_ranges, numbers, read};
use input::problem::Problems;
use input::quantity::{DENSITY, LENGTH, SPEED, plain};
use input::typed::Section;
use serde::Serialize;

/// Water over the ground. Soil and bodies are in it as a whole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Water {
    /// Height of the surface of the water [m].
    pub level: f64,
    /// Density ρ_w [kg/m³].
    pub density: f64,
    /// Density of the soil's grains ρ_s [kg/m³].
    pub grain_density: f64,
    /// Permeability of the soil k [m/s].
    pub permeability: Option<f64>,
    /// Volume strain ε of the soil as it fails, positive where it dilates; `None` for that which follows from
    /// its law.
    pub volume_strain: Option<f64>,
    /// Whether the pore pressure is computed; otherwise the soil is drained.
    pub pore_pressure: bool,
    /// Drag coefficient C_d of the bodies.
    pub drag_coefficient: f64,
    /// Whether the soil is taken for drained, whatever its drainage number.
    pub accept_drained: bool,
}

/// Keys of the water, and where their values lie.
type Field = KeyOf<Water>;

const FIELDS: &[Field] = &[
    Field::new("level", Kind::Quantity(LENGTH), Place::Number(|water| &mut water.level))
        .means("Height of the surface of the water; soil and bodies lie below it."),
    Field::new("density", Kind::Quantity(DENSITY), Place::Number(|water| &mut water.density))
        .default(Quantity("1000 kg/m^3"))
        .within(POSITIVE)
        .usually(WATER_DENSITY)
        .means("Density of the water ρ_w; some 1025 kg/m^3 at sea."),
    Field::new("grain_density", Kind::Quantity(DENSITY), Place::Number(|water| &mut water.grain_density))
        .default(Quantity("2650 kg/m^3"))
        .within(POSITIVE)
        .usually(GRAIN_DENSITY)
        .means(
            "Density of the grains ρ_s; the submerged unit weight of soil is γ′ = ρ g (1 − ρ_w/ρ_s), ρ its \
             dry density.",
        ),
    Field::new("permeability", Kind::Quantity(SPEED), Place::Optional(|water| &mut water.permeability))
        .derived("required for frictional soil")
        .within(POSITIVE)
        .usually(PERMEABILITY)
        .means(
            "Permeability of the soil k (hydraulic conductivity): about 1e-5 m/s in silty sand, 1e-4 in \
             fine, 1e-3 in coarse sand.",
        ),
    Field::new("volume_strain", Kind::Number, Place::Optional(|water| &mut water.volume_strain))
        .derived("ρ/ρ_crit − 1; required for mohr-coulomb without critical_density")
        .within(VOLUME_STRAIN)
        .means(
            "Volume strain ε of the soil as it fails, positive where it dilates: (n_max − n)/(1 − n_max); \
             for the drainage number.",
        ),
    Field::new("pore_pressure", Kind::Flag, Place::Flag(|water| &mut water.pore_pressure))
        .default(Flag(false))
        .means(
            "Whether the pressure of the pore water is computed; otherwise the soil is drained, without \
             excess pore pressure.",
        ),
    Field::new("drag_coefficient", Kind::Number, Place::Number(|water| &mut water.drag_coefficient))
        .default(Number(1.0))
        .within(NOT_NEGATIVE)
        .means(
            "Drag coefficient C_d of the bodies, for their frontal area at the start; 0 for no drag of the \
             water.",
        ),
    Field::new("accept_drained", Kind::Flag, Place::Flag(|water| &mut water.accept_drained))
        .default(Flag(false))
        .means("Run although the soil does not drain at this speed; `--accept-drained` sets it."),
];

impl Water {
    pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    /// The water, if the case has any; the outer `None` where it was given wrongly.
    #[allow(clippy::option_option)]
    pub(crate) fn typed(section: Option<&Section>, problems: &mut Problems) -> Option<Option<Self>> {
        let Some(section) = section else { return Some(None) };
        if section.has("accept_drained") && !section.has("level") {
            let cure = "leave out --accept-drained, or add a section [water] with a `level`";
            problems.add(section.at("accept_drained"), "without water there is nothing to drain", cure);
            return None;
        }
        let water = read(FIELDS, Self::default(), section, problems)?;
        let before = problems.len();
        water.check(problems);
        (problems.len() == before).then_some(Some(water))
    }

    /// Reports what is wrong with the numbers of the water.
    pub(crate) fn check(&self, problems: &mut Problems) {
        let before = problems.len();
        in_ranges("water", &numbers(FIELDS, self), problems);
        if problems.len() == before && self.grain_density <= self.density {
            let message = format!(
                "the grains, {} kg/m³, are not heavier than the water, {} kg/m³",
                plain(self.grain_density),
                plain(self.density)
            );
            problems.add("water.grain_density", message, "quartz sand has 2650 kg/m^3");
        }
    }

    /// Largest drainage number up to which results for drained soil are good, and up to which they are
    /// doubtful: beyond, pore pressures rule the forces. In closed form with suction a free disc sinks some 4
    /// % less at 0.5 and 28 % less at 5.
    pub const DRAINED: [f64; 2] = [0.5, 5.0];

    /// Weight per mass of solids in water [m/s²]: g (1 − ρ_w/ρ_s).
    #[must_use]
    pub fn soil_gravity(&self, gravity: f64) -> f64 {
        gravity * (1.0 - self.density / self.grain_density)
    }

    /// Mass of the water that a solid displaces [kg], in plane strain that of its width there, and the centre
    /// of its volume [m].
    #[must_use]
    pub(crate) fn displaced_by(&self, solid: &dyn Solid, plane_strain: bool) -> (f64, DVec3) {
        if !solid.has_surface() {
            return (0.0, DVec3::ZERO);
        }
        let properties = solid.mass_properties();
        (self.density * of_width(solid, plane_strain) * properties.volume, properties.centroid)
    }

    /// Unit weight γ_w [N/m³] under gravity [m/s²].
    #[must_use]
    pub fn unit_weight(&self, gravity: f64) -> f64 {
        self.density * gravity
    }
}

/// Width of a body in plane strain over that of the solid that stands for it; 1 otherwise.
pub(super) fn of_width(solid: &dyn Solid, plane_strain: bool) -> f64 {
    let (low, high) = solid.bounds();
    if plane_strain { PLANE_STRAIN_WIDTH / (high.y - low.y) } else { 1.0 }
}
