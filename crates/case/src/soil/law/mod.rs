//! The yield law of a soil. Each law is one file, with its parameters, their keys and all that a case has to
//! know of it.

mod elastic;
mod mohr_coulomb;
mod sand;
mod soil_law;
mod tresca;
mod von_mises;

pub use mohr_coulomb::{MohrCoulomb, Potential};
pub use sand::Sand;
pub use soil_law::{Initial, SoilLaw, Strength};
pub use tresca::{ClaySoftening, Tresca};
pub use von_mises::VonMises;

use elastic::Elastic;
use input::key::{Key, count, in_ranges, joined};
use input::problem::Problems;
use input::typed::Section;
use serde::Serialize;
use std::ops::Deref;

macro_rules! laws {
    ($($law:ident: $about:literal;)*) => {
        /// The yield law of the soil.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum Law {
            $(#[doc = $about] $law($law),)*
            /// Linear elastic.
            #[default]
            Elastic,
        }

        /// The words of the laws.
        pub(crate) const WORDS: &[&str] = &[$($law::WORD,)* Elastic::WORD];

        /// The keys that the laws declare.
        const LISTS: &[&[Key]] = &[$($law::DECLARED),*];

        /// Whether the law of a word has a key.
        pub(crate) fn has_key(word: &str, key: &str) -> bool {
            $(word == $law::WORD && $law::FIELDS.iter().any(|own| own.key.name == key))||*
        }

        /// The law of this word as typed; `None` with problems added.
        pub(crate) fn typed(word: &str, section: &Section, problems: &mut Problems) -> Option<Law> {
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
pub(crate) const KEYS: &[Key] = &joined::<{ count(LISTS) }>(LISTS);

impl Law {
    /// Reports what is wrong with the law of the section at a path.
    pub(crate) fn check(&self, path: &str, problems: &mut Problems) {
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
