//! The yield law of a soil. Each law is one file, with its parameters, their keys and all that a case has to know of it.

mod elastic;
mod mohr_coulomb;
mod sand;
mod tresca;
mod von_mises;

pub use mohr_coulomb::{MohrCoulomb, Potential};
pub use sand::Sand;
pub use tresca::{ClaySoftening, Tresca};
pub use von_mises::VonMises;

use super::Soil;
use crate::case::keys::{Key, count, in_ranges, joined};
use crate::case::problem::Problems;
use crate::case::typed::Section;
use elastic::Elastic;
use physics::elastic::Elastic as Moduli;
use physics::law::Law as ConstitutiveLaw;
use serde::Serialize;
use solver::material::Material;
use std::ops::Deref;

macro_rules! laws {
    ($($law:ident: $about:literal;)*) => {
        /// The yield law of the soil.
        #[derive(Clone, Copy, Debug, PartialEq, Serialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum Law {
            $(#[doc = $about] $law($law),)*
            /// Linear elastic.
            Elastic,
        }

        /// The words of the laws.
        pub(in crate::case) const WORDS: &[&str] = &[$($law::WORD,)* Elastic::WORD];

        /// The keys that the laws declare.
        const LISTS: &[&[Key]] = &[$($law::DECLARED),*];

        /// Whether the law of a word has a key.
        pub(super) fn has_key(word: &str, key: &str) -> bool {
            $(word == $law::WORD && $law::FIELDS.iter().any(|own| own.key.name == key))||*
        }

        /// The law of this word as typed; `None` with problems added.
        pub(super) fn typed(word: &str, section: &Section, problems: &mut Problems) -> Option<Law> {
            match word {
                $($law::WORD => $law::typed(section, problems).map(Law::$law),)*
                _ => Some(Law::Elastic),
            }
        }

        impl Deref for Law {
            type Target = dyn SoilLaw;

            fn deref(&self) -> &Self::Target {
                match self {
                    $(Self::$law(law) => law,)*
                    Self::Elastic => &Elastic,
                }
            }
        }
    };
}

laws! {
    MohrCoulomb: "Frictional soil with constant angles.";
    Sand: "Sand whose strength and stiffness follow its density and pressure.";
    Tresca: "Undrained clay.";
    VonMises: "Metal that hardens.";
}

/// The keys of all laws, each once.
pub(super) const KEYS: &[Key] = &joined::<{ count(LISTS) }>(LISTS);

/// What a law says of itself. Angles are in rad, stresses in Pa.
pub trait SoilLaw {
    /// Parameters of the law, each with the name of its key.
    fn numbers(&self) -> Vec<(&'static str, f64)>;

    /// What soil of this law is called in messages.
    fn kind(&self) -> &'static str;

    /// Reports parameters in range that contradict each other.
    fn contradictions(&self, _path: &str, _problems: &mut Problems) {}

    /// Reports what contradicts the rest of the soil.
    fn check_in(&self, _soil: &Soil, _path: &str, _problems: &mut Problems) {}

    /// Friction angle φ, of sand that of the critical state; `None` for a strength that does not depend on the pressure.
    fn friction_angle(&self) -> Option<f64> {
        None
    }

    /// Dilation angle ψ; 0 for isochoric flow.
    fn dilation_angle(&self) -> f64 {
        0.0
    }

    /// Shear strength without normal stress: c, s_u, or about half of σ_y; `None` for soil that does not fail.
    fn cohesion(&self) -> Option<f64>;

    /// Whether it sustains these principal stresses, compression positive, the largest first.
    fn sustains(&self, principal: [f64; 3]) -> bool;

    /// Coefficient of earth pressure at rest under level ground: Jaky's (1944), or that of elastic soil that cannot expand sideways.
    fn level_k0(&self, poisson_ratio: f64) -> f64 {
        self.friction_angle().map_or(poisson_ratio / (1.0 - poisson_ratio), |angle| 1.0 - angle.sin())
    }

    /// Whether its stress is that of the grains, beside which water in the pores has a pressure of its own.
    fn bears_effective_stress(&self) -> bool {
        self.friction_angle().is_some()
    }

    /// Whether it may lose, and take up, volume as it is sheared, without limit on the way.
    fn changes_volume(&self) -> [bool; 2] {
        [false, self.dilation_angle() > 0.0]
    }

    /// Volume strain of a soil from the start to failure, positive where it dilates; `None` where it does not follow from the law.
    fn volume_strain(&self, _soil: &Soil) -> Option<f64> {
        Some(0.0)
    }

    /// The largest Young's modulus over that of the soil.
    fn stiffening(&self) -> f64 {
        1.0
    }

    /// The law of the solver, for elastic moduli.
    fn yield_law(&self, elastic: Moduli) -> Option<ConstitutiveLaw>;

    /// Enters into the solver's material what is not in its law.
    fn complete(&self, _soil: &Soil, _material: &mut Material) {}

    /// Law and strength of a soil in a few words, with three digits, for the top of a report.
    fn summary(&self, soil: &Soil) -> String;

    /// Law and all parameters of a soil, with four digits.
    fn spelled_out(&self, soil: &Soil) -> String;

    /// The soil as the closed forms see it, with remarks on what that neglects.
    ///
    /// # Errors
    /// In words, where there are none for it.
    fn for_closed_forms(&self, _soil: &Soil, _remarks: &mut Vec<String>) -> Result<Strength, String> {
        Err(format!(
            "the soil is {}; the closed forms are for sand, Mohr-Coulomb soil and undrained clay",
            self.kind()
        ))
    }
}

/// Strength of a soil in closed forms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strength {
    /// Friction angle φ [rad]; 0 for undrained soil.
    pub friction_angle: f64,
    /// Dilation angle ψ [rad].
    pub dilation_angle: f64,
    /// Cohesion, or undrained shear strength at the top of the soil [Pa].
    pub cohesion: f64,
    /// Growth of the undrained shear strength with depth [Pa/m].
    pub gradient: f64,
}

impl Law {
    /// Reports what is wrong with the law of the section at a path.
    pub(in crate::case) fn check(&self, path: &str, problems: &mut Problems) {
        let before = problems.len();
        in_ranges(path, &self.numbers(), problems);
        if problems.len() == before {
            self.contradictions(path, problems);
        }
    }

    /// Parameters of the law if it is that of sand.
    #[must_use]
    pub fn sand(&self) -> Option<&Sand> {
        if let Self::Sand(sand) = self { Some(sand) } else { None }
    }

    /// The law at a depth below the top of its layer [m]: with the strength that undrained soil has there.
    #[must_use]
    pub fn at_depth(self, depth: f64) -> Self {
        if let Self::Tresca(law) = self { Self::Tresca(law.at_depth(depth)) } else { self }
    }

    /// Density [kg/m³] at a relative density, of sand.
    #[must_use]
    pub fn density_at(&self, relative_density: f64) -> Option<f64> {
        self.sand().map(|sand| sand.density_at(relative_density))
    }
}
