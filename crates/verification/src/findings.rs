//! The results of the suite.

use crate::row::Row;
use crate::run_balances::RunBalances;

/// The results of the suite.
#[derive(Debug, Default)]
pub struct Findings {
    /// The balances of the runs.
    pub balances: Vec<RunBalances>,
    /// The rows, in the order of the benchmarks.
    pub rows: Vec<Row>,
    /// Benchmarks that produced no figures, and why.
    pub broken: Vec<(&'static str, String)>,
}
