//! What a study asks of its analysis.

/// What to analyse.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnalysisRequest {
    /// Responses by name; empty: those of drag, vertical and sinkage that the table has.
    pub responses: Vec<String>,
    /// Models by name; empty: all. Each costs a surrogate for each response, a second or a few.
    pub models: Vec<String>,
    /// Whether the collapse of drag over depth, both dimensionless, is shown elsewhere.
    pub has_collapse: bool,
    /// Seed of the random numbers of the indices.
    pub seed: u64,
}
