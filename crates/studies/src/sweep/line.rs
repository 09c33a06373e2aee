//! A line of `cases.jsonl`: one case of a study.

use super::id::CaseId;
use crate::study::ModelKind;
use serde::{Deserialize, Serialize};

/// A case of a study. Lines with the same id are the same case and are run once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseLine {
    /// Hash of the case as understood and of what is evaluated.
    pub id: CaseId,
    /// Number of the point in the study, from 1.
    pub point: usize,
    /// The part of the study; empty where it has only one.
    pub part: String,
    /// The case that is varied: its number in the list of the study.
    pub case: usize,
    /// The model that is evaluated.
    pub model: ModelKind,
    /// Meshes from which the intervals of a run follow; `null` without intervals.
    pub meshes: Option<usize>,
    /// The factors and their levels at the point; without those of which the part makes no use.
    pub factors: Vec<FactorLevel>,
    /// What is set in the case, as `--set` takes it.
    pub set: Vec<String>,
    /// Predicted memory of a run [bytes]; 0 of a closed form.
    pub memory_bytes: f64,
    /// Why the case is not valid; empty for one that is.
    pub refused: String,
}

/// The level of a factor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FactorLevel {
    /// Name of the factor.
    pub name: String,
    /// Number of the level in the unit of the factor; `null` for a word.
    pub number: Option<f64>,
    /// The level as typed.
    pub shown: String,
    /// Whether the part varies the factor.
    pub is_varied: bool,
}
