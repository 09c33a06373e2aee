//! What stress soil bears, and how the rest of a trial stress flows away.

use super::Real;
use super::menetrey_willam::MenetreyWillam;
use super::mohr_coulomb::MohrCoulomb;
use super::tensor::Symmetric;
use super::von_mises::VonMises;

/// What a return to the admissible set gives back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Returned {
    /// Admissible stress [Pa].
    pub stress: Symmetric,
    /// Increment of equivalent plastic strain √(⅔ e:e).
    pub plastic_strain: Real,
    /// Increment of stress-free volumetric opening.
    pub gap_strain: Real,
}

/// A yield surface with its flow rule. Both functions are written without branches, so that a loop over cells vectorises.
/// Strength may depend on the equivalent plastic strain so far; laws that do not harden take no notice of it.
pub trait Strength {
    /// Whether a stress may lie outside the admissible set. Cheap, and never wrong in saying no.
    fn may_yield(&self, stress: Symmetric, plastic_strain: Real) -> bool;

    /// Brings a trial stress back to the admissible set. Soil at its critical density no longer `dilates`: its
    /// dilation angle counts as 0.
    fn return_map(&self, trial: Symmetric, plastic_strain: Real, dilates: bool) -> Returned;
}

/// The strengths that soil may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Mohr–Coulomb with a flow potential of the same form: closed-form return.
    MohrCoulomb(MohrCoulomb),
    /// Mohr–Coulomb with the smooth flow potential of Menétrey and Willam.
    MenetreyWillam(MenetreyWillam),
    /// Von Mises with linear isotropic hardening.
    VonMises(VonMises),
}

impl Law {
    /// A law known in double precision, in the one at hand.
    #[must_use]
    pub fn rounded(exact: &crate::double::strength::Law) -> Self {
        use crate::double::strength::Law as Exact;
        match exact {
            Exact::MohrCoulomb(law) => Self::MohrCoulomb(MohrCoulomb::rounded(law)),
            Exact::MenetreyWillam(law) => Self::MenetreyWillam(MenetreyWillam::rounded(law)),
            Exact::VonMises(law) => Self::VonMises(VonMises::rounded(law)),
        }
    }
}

impl Strength for Law {
    fn may_yield(&self, stress: Symmetric, plastic_strain: Real) -> bool {
        match self {
            Self::MohrCoulomb(law) => law.may_yield(stress, plastic_strain),
            Self::MenetreyWillam(law) => law.may_yield(stress, plastic_strain),
            Self::VonMises(law) => law.may_yield(stress, plastic_strain),
        }
    }

    fn return_map(&self, trial: Symmetric, plastic_strain: Real, dilates: bool) -> Returned {
        match self {
            Self::MohrCoulomb(law) => law.return_map(trial, plastic_strain, dilates),
            Self::MenetreyWillam(law) => law.return_map(trial, plastic_strain, dilates),
            Self::VonMises(law) => law.return_map(trial, plastic_strain, dilates),
        }
    }
}
