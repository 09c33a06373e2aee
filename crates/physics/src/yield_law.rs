//! The interface of a plasticity model: yield check and return mapping.

use super::Real;
use super::tensor::Symmetric;

/// What soil remembers of its past besides its plastic strain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Memory {
    /// Largest mobilised stress ratio q/(g p).
    pub stress_ratio: Real,
    /// Preconsolidation pressure: the largest mean pressure [Pa].
    pub preconsolidation: Real,
    /// Nonlocal relative density less that of the point; the law does not change it.
    pub nonlocal_density: Real,
    /// Undrained shear strength of intact clay [Pa]; the law does not change it.
    pub intact_strength: Real,
}

/// State of a point of the soil at the start of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Stress [Pa].
    pub stress: Symmetric,
    /// Density [kg/m³].
    pub density: Real,
    /// Whether the soil is at the critical density of a law with a constant dilation angle, which is then
    /// taken as 0.
    pub is_critical: bool,
    /// Equivalent plastic strain.
    pub plastic_strain: Real,
    /// What the soil remembers, for laws that depend on it.
    pub memory: Memory,
    /// Length of the step [s]: 0 in a remap, infinite where the soil is strained so slowly that its rate
    /// plays no role.
    pub duration: Real,
}

/// Result of a return mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Returned {
    /// Admissible stress [Pa].
    pub stress: Symmetric,
    /// Increment of equivalent plastic strain √(⅔ e:e).
    pub plastic_strain: Real,
    /// Increment of stress-free volumetric opening.
    pub gap_strain: Real,
    /// What the soil remembers at the end of the step, for laws that depend on it.
    pub memory: Memory,
}

/// A yield surface with its flow rule.
///
/// Implementations are free of branches, so that loops over cells vectorise. Laws use what they depend on of
/// the point.
pub trait YieldLaw {
    /// Whether the law depends on stress, density and memory of the point, and changes the memory.
    const REMEMBERS: bool = false;

    /// Whether the law depends on the strength of the intact soil at the point, and on the length of the
    /// step.
    const HAS_STRENGTH: bool = false;

    /// Whether a stress may lie outside the yield surface: a cheap check without false negatives.
    fn may_yield(&self, stress: Symmetric, point: &Point) -> bool;

    /// Returns a trial stress [Pa] to the yield surface.
    fn return_map(&self, trial: Symmetric, point: &Point) -> Returned;
}
