//! Von Mises plasticity with linear isotropic hardening: metals.
//!
//! Yield: q = √(3/2 s:s) = σ_y + H ε̄ₚ (von Mises 1913), ε̄ₚ = ∫√(⅔ ε̇ₚ:ε̇ₚ) dt, with associated flow. The
//! deviator of the trial stress is scaled radially (Wilkins 1964), which for linear hardening is the implicit
//! return in closed form (Krieg & Key 1976): Δε̄ₚ = (q − σ_y − H ε̄ₚ)/(3 G + H). Pressure and hydrostatic
//! tension are unlimited. Free of branches, so that loops vectorise.

use super::Real;
use super::elastic::Elastic;
use super::tensor::{Symmetric, contract, deviator, mean, mises};
use super::yield_law::{Memory, Point, Returned, YieldLaw};

/// Strength parameters, and the moduli of the return mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct VonMises {
    /// σ_y [Pa].
    pub(crate) yield_stress: Real,
    /// H [Pa].
    pub(crate) hardening: Real,
    /// 3 G [Pa].
    pub(crate) stiffness: Real,
    /// 1/(3 G + H) [1/Pa].
    pub(crate) per_return: Real,
}

impl VonMises {
    /// The law from the initial yield stress in uniaxial tension σ_y > 0 [Pa] and the hardening modulus H ≥ 0
    /// [Pa], the slope of the flow stress over the plastic strain.
    #[must_use]
    pub fn new(elastic: Elastic, yield_stress: Real, hardening: Real) -> Self {
        let stiffness = 3.0 * elastic.shear;
        Self { yield_stress, hardening, stiffness, per_return: 1.0 / (stiffness + hardening) }
    }

    /// Double-precision parameters, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::von_mises::VonMises) -> Self {
        Self {
            yield_stress: exact.yield_stress as Real,
            hardening: exact.hardening as Real,
            stiffness: exact.stiffness as Real,
            per_return: exact.per_return as Real,
        }
    }

    /// Flow stress [Pa] at an equivalent plastic strain: the uniaxial stress at which it yields.
    #[inline(always)]
    #[must_use]
    pub fn flow_stress(&self, plastic_strain: Real) -> Real {
        self.yield_stress + self.hardening * plastic_strain
    }
}

impl YieldLaw for VonMises {
    #[inline(always)]
    fn may_yield(&self, stress: Symmetric, point: &Point) -> bool {
        let s = deviator(stress);
        let limit = self.flow_stress(point.plastic_strain);
        1.5 * contract(s, s) > limit * limit
    }

    /// Isochoric at any density.
    #[inline(always)]
    fn return_map(&self, trial: Symmetric, point: &Point) -> Returned {
        let (s, p, q) = (deviator(trial), mean(trial), mises(trial));
        let excess = q - self.flow_stress(point.plastic_strain);
        let flow = if excess > 0.0 { excess * self.per_return } else { 0.0 };
        let scale = 1.0 - self.stiffness * flow / if q > 0.0 { q } else { 1.0 };
        let stress =
            [s[0] * scale + p, s[1] * scale + p, s[2] * scale + p, s[3] * scale, s[4] * scale, s[5] * scale];
        Returned { stress, plastic_strain: flow, gap_strain: 0.0, memory: Memory::default() }
    }
}
