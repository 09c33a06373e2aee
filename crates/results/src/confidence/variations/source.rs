//! Where the uncertainty of a result comes from.

use serde::{Deserialize, Serialize};

/// A source of uncertainty. All but the last are examined by variations of the case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorSource {
    /// Cells of finite size.
    #[default]
    Mesh,
    /// A domain that ends near the bodies.
    Domain,
    /// A motion that is faster than a quasi-static one.
    Speed,
    /// Numbers of finite precision.
    Precision,
    /// A window of finite length, over which forces fluctuate.
    Statistics,
}

impl ErrorSource {
    /// All sources of uncertainty, in the order in which they are shown.
    pub const ALL: [Self; 5] = [Self::Mesh, Self::Domain, Self::Speed, Self::Precision, Self::Statistics];

    /// Word of the source, as in `summary.json` and on the command line.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Mesh => "mesh",
            Self::Domain => "domain",
            Self::Speed => "speed",
            Self::Precision => "precision",
            Self::Statistics => "statistics",
        }
    }
}
