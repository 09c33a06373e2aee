//! The materials of the soil.

use crate::fields::Kinds;
use physics::elastic::{Elastic, Stiffening};
use physics::law::Law;
use physics::tensor::Symmetric;
use physics::viscosity::BulkViscosity;

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
    /// Length over which the density that governs the strength is averaged [m]; `None` for the density of
    /// each cell alone.
    pub characteristic_length: Option<f64>,
    /// Coefficient of earth pressure at rest K₀: ratio of horizontal to vertical stress at the start.
    pub k0: f64,
    /// Largest mean pressure that sand has borne before the start [Pa].
    pub preconsolidation: f64,
    /// Strength of the intact soil at the start, for laws with a strength at each point.
    pub strength: Option<StrengthProfile>,
    /// Density of the undeformed soil where it grows with depth; `density` then is that at the top.
    pub density_profile: Option<DensityProfile>,
}

/// A relative density of sand that grows with depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DensityProfile {
    /// Height from which the relative density grows downwards [m].
    pub top: f64,
    /// Relative density there and above.
    pub at_top: f64,
    /// Growth of the density per depth [1/m].
    pub gradient: f64,
    /// Densities in the loosest and the densest state [kg/m³].
    pub limits: [f64; 2],
}

impl DensityProfile {
    /// Density at a height [kg/m³].
    #[must_use]
    pub fn at(&self, z: f64) -> f64 {
        let [loosest, densest] = self.limits;
        let relative = self.at_top + self.gradient * (self.top - z).max(0.0);
        loosest * densest / (densest - relative * (densest - loosest))
    }
}

/// An undrained shear strength that grows with depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrengthProfile {
    /// Height from which the strength grows downwards [m].
    pub top: f64,
    /// Strength there and above [Pa].
    pub at_top: f64,
    /// Growth per depth k [Pa/m].
    pub gradient: f64,
}

impl StrengthProfile {
    /// Strength at a height [Pa].
    #[must_use]
    pub fn at(&self, z: f64) -> f64 {
        self.at_top + self.gradient * (self.top - z).max(0.0)
    }
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
            preconsolidation: 0.0,
            strength: None,
            density_profile: None,
        }
    }

    /// Density of the undeformed soil at a height [kg/m³].
    #[must_use]
    pub fn density_at(&self, z: f64) -> f64 {
        self.density_profile.map_or(self.density, |profile| profile.at(z))
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

    /// Bulk modulus at a mean pressure [Pa].
    #[must_use]
    pub fn bulk_modulus(&self, pressure: f64) -> f64 {
        self.elastic.bulk * self.stiffening().map_or(1.0, |stiffening| stiffening.factor(pressure))
    }

    /// Whether the material opens where it cannot bear the tension, so that a gap must close before it bears
    /// pressure again.
    #[must_use]
    pub fn opens(&self) -> bool {
        matches!(self.yield_law, Some(Law::MohrCoulomb(_) | Law::MenetreyWillam(_) | Law::Sand(_)))
    }

    /// Density in the densest state without pressure [kg/m³]. The laws other than that of sand do not
    /// compact.
    #[must_use]
    pub fn densest(&self) -> f64 {
        match self.yield_law {
            Some(Law::Sand(law)) => law.densest(),
            _ => self.density,
        }
    }

    /// Density below which the soil is no longer one body [kg/m³], so that it must be compressed before it
    /// bears pressure; 0 of soil that does not open. Cracks along one or two axes leave no gap, which would
    /// free the third axis of stress, too: without this cohesive soil that is torn again and again expanded
    /// to a tenth of its density. Chosen: rubble has a little more than half the density of what it was.
    #[must_use]
    pub fn loosest(&self) -> f64 {
        if self.opens() { 0.5 * self.density } else { 0.0 }
    }

    /// Elastic energy density at a stress [J/m³].
    #[must_use]
    pub fn elastic_energy(&self, stress: Symmetric) -> f64 {
        match self.stiffening() {
            Some(stiffening) => stiffening.energy(self.elastic, stress),
            None => self.elastic.energy(stress),
        }
    }

    /// The kinds, besides the usual ones, to which the material belongs.
    #[must_use]
    pub fn kinds(&self) -> Kinds {
        Kinds {
            sand: matches!(self.yield_law, Some(Law::Sand(_))),
            clay: matches!(self.yield_law, Some(Law::Clay(_))),
            water: false,
        }
    }

    /// Undrained shear strength [Pa] up to the reference rate, of soil that has one, from that of the intact
    /// soil [Pa] and the equivalent plastic strain.
    #[must_use]
    pub fn shear_strength(&self, intact: f64, plastic_strain: f64) -> Option<f64> {
        match self.yield_law? {
            Law::MohrCoulomb(law) => law.undrained_strength(),
            Law::Clay(law) => Some(law.slow_strength(intact, plastic_strain)),
            _ => None,
        }
    }

    /// Bulk viscosity with coefficients b₁ and b₂.
    #[must_use]
    pub fn viscosity(&self, [b1, b2]: [f64; 2]) -> BulkViscosity {
        BulkViscosity::new(b1, b2, self.density, self.wave_speed())
    }
}
