//! Water over the ground: its properties, and what soil and bodies weigh in it.

use super::rigid_body::{Body, PLANE_STRAIN_WIDTH};
use glam::DVec3;
use physics::shape::Shape as Solid;
use serde::Serialize;

/// Water over the ground. Soil and bodies are in it as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Water {
    /// Height of its surface [m].
    pub level: f64,
    /// Density ρ_w [kg/m³].
    pub density: f64,
    /// Density of the soil's grains ρ_s [kg/m³].
    pub grain_density: f64,
    /// Permeability of the soil k [m/s].
    pub permeability: Option<f64>,
    /// Volume strain ε of the soil as it fails, positive where it dilates; `None` for that which follows from its law.
    pub volume_strain: Option<f64>,
    /// Whether the pore pressure is computed; otherwise the soil is drained.
    pub pore_pressure: bool,
    /// Drag coefficient C_d of the bodies.
    pub drag_coefficient: f64,
    /// Whether the soil is taken for drained, whatever its drainage number.
    pub accept_drained: bool,
}

impl Water {
    /// Largest drainage number up to which results for drained soil are good, and up to which they are doubtful: beyond, pore pressures
    /// rule the forces. In closed form with suction a free disc sinks some 4 % less at 0.5 and 28 % less at 5.
    pub const DRAINED: [f64; 2] = [0.5, 5.0];

    /// Weight per mass of solids in water [m/s²]: g (1 − ρ_w/ρ_s).
    #[must_use]
    pub fn soil_gravity(&self, gravity: f64) -> f64 {
        gravity * (1.0 - self.density / self.grain_density)
    }

    /// Mass of the water that a solid displaces [kg], in plane strain that of its width there, and the centre of its volume [m].
    #[must_use]
    pub(in crate::case) fn displaced_by(&self, solid: &dyn Solid, plane_strain: bool) -> (f64, DVec3) {
        if !solid.has_surface() {
            return (0.0, DVec3::ZERO);
        }
        let properties = solid.mass_properties();
        (self.density * of_width(solid, plane_strain) * properties.volume, properties.centroid)
    }

    /// The same for a body with its parts, the centre from its reference point.
    #[must_use]
    pub(in crate::case) fn displaced(&self, body: &Body, plane_strain: bool) -> (f64, DVec3) {
        let parts = body.parts.iter().map(|part| {
            let (mass, centre) = self.displaced_by(part.solid().as_ref(), plane_strain);
            (mass, part.offset + part.rotation * centre)
        });
        let own = std::iter::once(self.displaced_by(body.own_solid().as_ref(), plane_strain));
        let (mass, moment) = own
            .chain(parts)
            .fold((0.0, DVec3::ZERO), |(sum, moment), (mass, centre)| (sum + mass, moment + mass * centre));
        (mass, if mass > 0.0 { moment / mass } else { DVec3::ZERO })
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
