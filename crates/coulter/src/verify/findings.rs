//! What the suite found.

use super::row::Row;
use super::run_ledgers::Ledgers;

/// What the suite found.
#[derive(Debug, Default)]
pub struct Findings {
    /// The ledgers of the runs.
    pub ledgers: Vec<Ledgers>,
    /// The rows, in the order of the benchmarks.
    pub rows: Vec<Row>,
    /// Benchmarks that gave no figures, and why.
    pub broken: Vec<(&'static str, String)>,
}
