//! What a study asks of its analysis.

use crate::charts::ChartRequest;

/// What to analyse.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnalysisRequest {
    /// Responses by name; empty: those of drag, vertical and sinkage that the table has.
    pub responses: Vec<String>,
    /// Models by name; empty: all. Each costs a surrogate for each response, a second or a few.
    pub models: Vec<String>,
    /// Charts besides those that every study gets.
    pub charts: Vec<ChartRequest>,
    /// Seed of the random numbers of the indices.
    pub seed: u64,
}
