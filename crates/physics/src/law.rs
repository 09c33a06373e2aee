//! The constitutive laws that the soil may have, as one type.

use super::clay::Clay;
use super::menetrey_willam::MenetreyWillam;
use super::mohr_coulomb::MohrCoulomb;
use super::sand::Sand;
use super::tensor::Symmetric;
use super::von_mises::VonMises;
use super::yield_law::{Point, Returned, YieldLaw};

/// A constitutive law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Mohr–Coulomb with a flow potential of the same form; closed-form return mapping.
    MohrCoulomb(MohrCoulomb),
    /// Mohr–Coulomb with the smooth flow potential of Menétrey and Willam.
    MenetreyWillam(MenetreyWillam),
    /// Von Mises with linear isotropic hardening.
    VonMises(VonMises),
    /// Sand whose strength, dilatancy and stiffness follow its density and pressure.
    Sand(Sand),
    /// Undrained clay whose strength differs from point to point and changes with remoulding and rate.
    Clay(Clay),
}

impl Law {
    /// A double-precision law, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::law::Law) -> Self {
        use crate::double::law::Law as Exact;
        match exact {
            Exact::MohrCoulomb(law) => Self::MohrCoulomb(MohrCoulomb::cast(law)),
            Exact::MenetreyWillam(law) => Self::MenetreyWillam(MenetreyWillam::cast(law)),
            Exact::VonMises(law) => Self::VonMises(VonMises::cast(law)),
            Exact::Sand(law) => Self::Sand(Sand::cast(law)),
            Exact::Clay(law) => Self::Clay(Clay::cast(law)),
        }
    }
}

impl YieldLaw for Law {
    fn may_yield(&self, stress: Symmetric, point: &Point) -> bool {
        match self {
            Self::MohrCoulomb(law) => law.may_yield(stress, point),
            Self::MenetreyWillam(law) => law.may_yield(stress, point),
            Self::VonMises(law) => law.may_yield(stress, point),
            Self::Sand(law) => law.may_yield(stress, point),
            Self::Clay(law) => law.may_yield(stress, point),
        }
    }

    fn return_map(&self, trial: Symmetric, point: &Point) -> Returned {
        match self {
            Self::MohrCoulomb(law) => law.return_map(trial, point),
            Self::MenetreyWillam(law) => law.return_map(trial, point),
            Self::VonMises(law) => law.return_map(trial, point),
            Self::Sand(law) => law.return_map(trial, point),
            Self::Clay(law) => law.return_map(trial, point),
        }
    }
}
