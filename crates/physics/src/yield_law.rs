//! The interface of a plasticity model: yield check and return mapping.

use super::Real;
use super::tensor::Symmetric;

/// Result of a return mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Returned {
    /// Admissible stress [Pa].
    pub stress: Symmetric,
    /// Increment of equivalent plastic strain √(⅔ e:e).
    pub plastic_strain: Real,
    /// Increment of stress-free volumetric opening.
    pub gap_strain: Real,
}

/// A yield surface with its flow rule.
///
/// Implementations are free of branches, so that loops over cells vectorise. `plastic_strain` is the accumulated equivalent
/// plastic strain; laws without hardening ignore it.
pub trait YieldLaw {
    /// Whether a stress may lie outside the yield surface: a cheap check without false negatives.
    fn may_yield(&self, stress: Symmetric, plastic_strain: Real) -> bool;

    /// Returns a trial stress [Pa] to the yield surface. Without `dilates`, for soil at its critical density, the dilation
    /// angle is taken as 0.
    fn return_map(&self, trial: Symmetric, plastic_strain: Real, dilates: bool) -> Returned;
}
