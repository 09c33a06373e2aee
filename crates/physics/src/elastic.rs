//! Isotropic linear elasticity, in rate form.
//!
//! σ̇ = λ tr(D) I + 2 G D (hypoelastic with the Jaumann rate). Valid for small elastic strains,
//! as in soil at these pressures (p/E ≈ 10⁻³).

use super::Real;
use super::tensor::{Symmetric, contract, deviator, mean};

/// Isotropic elastic moduli.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Elastic {
    /// Bulk modulus K [Pa].
    pub bulk: Real,
    /// Shear modulus G [Pa].
    pub shear: Real,
}

impl Elastic {
    /// Elastic moduli from Young's modulus E > 0 [Pa] and Poisson's ratio −1 < ν < ½.
    #[must_use]
    pub fn new(young_modulus: Real, poisson_ratio: Real) -> Self {
        Self {
            bulk: young_modulus / (3.0 * (1.0 - 2.0 * poisson_ratio)),
            shear: young_modulus / (2.0 * (1.0 + poisson_ratio)),
        }
    }

    /// Double-precision moduli, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::elastic::Elastic) -> Self {
        Self { bulk: exact.bulk as Real, shear: exact.shear as Real }
    }

    /// Modulus of constrained compression M = K + 4 G/3 [Pa].
    #[must_use]
    pub fn constrained(&self) -> Real {
        self.bulk + 4.0 * self.shear / 3.0
    }

    /// Speed of the compression wave √(M/ρ) [m/s] at density ρ [kg/m³].
    #[must_use]
    pub fn wave_speed(&self, density: Real) -> Real {
        (self.constrained() / density).sqrt()
    }

    /// Contraction of a stress with the elastic strain of another: `a : C⁻¹ : b` [Pa], for stresses in [Pa].
    #[inline(always)]
    #[must_use]
    pub fn compliance(&self, a: Symmetric, b: Symmetric) -> Real {
        let (per_shear, per_bulk) = (0.5 / self.shear, 1.0 / self.bulk);
        contract(deviator(a), deviator(b)) * per_shear + mean(a) * mean(b) * per_bulk
    }

    /// Elastic energy density ½ σ : C⁻¹ : σ [J/m³].
    #[inline(always)]
    #[must_use]
    pub fn energy(&self, stress: Symmetric) -> Real {
        0.5 * self.compliance(stress, stress)
    }
}

/// How elastic moduli grow with the mean pressure: with its square root, between two pressures beyond which
/// they are constant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Stiffening {
    /// Lowest pressure at which the moduli change [Pa].
    pub least: Real,
    /// Pressure to which the moduli of the material refer, and at which they stop growing [Pa].
    pub most: Real,
}

impl Stiffening {
    /// Double-precision pressures, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::elastic::Stiffening) -> Self {
        Self { least: exact.least as Real, most: exact.most as Real }
    }

    /// Moduli at a mean pressure [Pa] over those at [`Stiffening::most`].
    #[inline(always)]
    #[must_use]
    pub fn factor(&self, pressure: Real) -> Real {
        let low = if pressure > self.least { pressure } else { self.least };
        let within = if low < self.most { low } else { self.most };
        (within * (1.0 / self.most)).sqrt()
    }

    /// Moduli at a mean pressure [Pa], from those at [`Stiffening::most`].
    #[inline(always)]
    #[must_use]
    pub fn moduli(&self, elastic: Elastic, pressure: Real) -> Elastic {
        let factor = self.factor(pressure);
        Elastic { bulk: elastic.bulk * factor, shear: elastic.shear * factor }
    }

    /// Elastic energy density at a stress [J/m³]: p²/(1.5 K) + q²/(6 G) with the moduli at its pressure,
    /// where these grow; the first term is ∫ p dp/K for K ~ √p.
    #[inline(always)]
    #[must_use]
    pub fn energy(&self, elastic: Elastic, stress: Symmetric) -> Real {
        let pressure = -mean(stress);
        let s = deviator(stress);
        let (per_bulk, per_shear) = (1.0 / (1.5 * elastic.bulk), 0.25 / elastic.shear);
        (pressure * pressure * per_bulk + contract(s, s) * per_shear) / self.factor(pressure)
    }
}
