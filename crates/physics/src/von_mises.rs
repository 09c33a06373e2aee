//! Von Mises plasticity with linear isotropic hardening: metals.
//!
//! Yield: q = √(3/2 s:s) = σ_y + H ε̄ₚ (von Mises 1913), ε̄ₚ = ∫√(⅔ ε̇ₚ:ε̇ₚ) dt, with the flow normal to it. The
//! deviator of the trial stress is scaled back along itself (Wilkins 1964), which for a straight hardening curve is the
//! implicit return in closed form (Krieg & Key 1976): Δε̄ₚ = (q − σ_y − H ε̄ₚ)/(3 G + H). Pressure is borne without
//! limit, and so is tension. Written without branches, so that a loop over it vectorises.

use super::Real;
use super::elastic::Elastic;
use super::strength::{Returned, Strength};
use super::tensor::{Symmetric, contract, deviator, mean, mises};

/// Strength parameters, with the sums of moduli that the return needs.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// From the yield stress of an untouched specimen in uniaxial tension σ_y > 0 [Pa] and the slope H ≥ 0 of that
    /// stress over the plastic strain [Pa].
    #[must_use]
    pub fn new(elastic: Elastic, yield_stress: Real, hardening: Real) -> Self {
        let stiffness = 3.0 * elastic.shear;
        Self { yield_stress, hardening, stiffness, per_return: 1.0 / (stiffness + hardening) }
    }

    /// Strength known in double precision, in the one at hand.
    #[must_use]
    pub fn rounded(exact: &crate::double::von_mises::VonMises) -> Self {
        Self {
            yield_stress: exact.yield_stress as Real,
            hardening: exact.hardening as Real,
            stiffness: exact.stiffness as Real,
            per_return: exact.per_return as Real,
        }
    }

    /// Uniaxial stress borne after an equivalent plastic strain [Pa].
    #[inline(always)]
    #[must_use]
    pub fn bears(&self, plastic_strain: Real) -> Real {
        self.yield_stress + self.hardening * plastic_strain
    }
}

impl Strength for VonMises {
    #[inline(always)]
    fn may_yield(&self, stress: Symmetric, plastic_strain: Real) -> bool {
        let s = deviator(stress);
        let borne = self.bears(plastic_strain);
        1.5 * contract(s, s) > borne * borne
    }

    /// The volume does not take part: `dilates` makes no difference.
    #[inline(always)]
    fn return_map(&self, trial: Symmetric, plastic_strain: Real, _dilates: bool) -> Returned {
        let (s, p, q) = (deviator(trial), mean(trial), mises(trial));
        let excess = q - self.bears(plastic_strain);
        let flow = if excess > 0.0 { excess * self.per_return } else { 0.0 };
        let kept = 1.0 - self.stiffness * flow / if q > 0.0 { q } else { 1.0 };
        let stress =
            [s[0] * kept + p, s[1] * kept + p, s[2] * kept + p, s[3] * kept, s[4] * kept, s[5] * kept];
        Returned { stress, plastic_strain: flow, gap_strain: 0.0 }
    }
}
