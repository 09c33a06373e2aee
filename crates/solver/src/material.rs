//! The materials of the soil.

use physics::elastic::{Elastic, Stiffening};
use physics::law::Law;
use physics::tensor::Symmetric;
use physics::viscosity::BulkViscosity;
#[cfg(doc)]
use physics::yield_law::YieldLaw;

/// A soil, with its elastic moduli, yield law and density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Elastic moduli.
    pub elastic: Elastic,
    /// Yield law; `None` for linear elastic soil.
    pub yield_law: Option<Law>,
    /// Critical density, below which the soil no longer dilates [kg/m³].
    pub critical_density: Option<f64>,
    /// Density of the undeformed soil [kg/m³].
    pub density: f64,
    /// Length over which the density that governs the strength is averaged [m]; `None` for the density of each cell alone.
    pub characteristic_length: Option<f64>,
    /// Coefficient of earth pressure at rest K₀: ratio of horizontal to vertical stress at the start.
    pub k0: f64,
}

impl Material {
    /// Linear elastic soil.
    #[must_use]
    pub fn linear_elastic(elastic: Elastic, density: f64) -> Self {
        Self {
            elastic,
            yield_law: None,
            critical_density: None,
            density,
            characteristic_length: None,
            k0: 1.0,
        }
    }

    /// Speed of the compression wave [m/s].
    #[must_use]
    pub fn wave_speed(&self) -> f64 {
        self.elastic.wave_speed(self.density)
    }

    /// How the elastic moduli grow with the pressure, if they do; `elastic` holds the largest.
    #[must_use]
    pub fn stiffening(&self) -> Option<Stiffening> {
        match self.yield_law {
            Some(Law::Sand(law)) => Some(law.stiffening),
            _ => None,
        }
    }

    /// Density in the densest state without pressure [kg/m³]. The laws other than that of sand do not compact.
    #[must_use]
    pub fn densest(&self) -> f64 {
        match self.yield_law {
            Some(Law::Sand(law)) => law.densest(),
            _ => self.density,
        }
    }

    /// Elastic energy density at a stress [J/m³].
    #[must_use]
    pub fn elastic_energy(&self, stress: Symmetric) -> f64 {
        match self.stiffening() {
            Some(stiffening) => stiffening.energy(self.elastic, stress),
            None => self.elastic.energy(stress),
        }
    }

    /// Whether its law depends on what the soil remembers (see [`YieldLaw::REMEMBERS`]).
    #[must_use]
    pub fn remembers(&self) -> bool {
        matches!(self.yield_law, Some(Law::Sand(_)))
    }

    /// Bulk viscosity with coefficients b₁ and b₂.
    #[must_use]
    pub fn viscosity(&self, [b1, b2]: [f64; 2]) -> BulkViscosity {
        BulkViscosity::new(b1, b2, self.density, self.wave_speed())
    }
}
