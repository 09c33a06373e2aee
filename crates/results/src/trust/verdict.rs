//! The verdict on a figure or a run.

use serde::{Deserialize, Serialize};

/// How far a result can be trusted, from best to worst.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Within the limit that an experienced user would set.
    #[default]
    Good,
    /// Usable with care; the advice says why.
    Doubtful,
    /// Not to be used.
    Broken,
}

impl Verdict {
    /// The word in tables and in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Doubtful => "doubtful",
            Self::Broken => "broken",
        }
    }
}
