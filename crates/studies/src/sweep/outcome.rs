//! What came out of a case.

use super::id::CaseId;
use crate::responses::Figures;
use serde::{Deserialize, Serialize};

/// How a case ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ending {
    /// The case ended with results.
    Done,
    /// The run is broken: its figures are kept, and must not be used.
    Broken,
    /// The case is not valid, or no closed form applies to it.
    Refused,
}

impl Ending {
    /// Word for the ending in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Broken => "broken",
            Self::Refused => "refused",
        }
    }
}

/// The outcome of a case: the same bytes wherever and however often it is run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// The id of the case.
    pub id: CaseId,
    /// How the case ended.
    pub ending: Ending,
    /// Why the case ended so, unless it is done.
    pub reason: String,
    /// Results of the models: of the solver a row for every body, of the closed forms one for every model.
    pub rows: Vec<Figures>,
}
