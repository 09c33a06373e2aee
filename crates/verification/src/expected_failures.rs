//! The rows that are expected to fail, each with its reason.
//!
//! Expected failures stand in one file. A row that fails without being listed, and one that is listed but
//! passes, are both reported.

use crate::list::find;
use crate::row::Row;
use serde::Deserialize;

const FILE: &str = include_str!("../validation/expected_failures.toml");

/// Rows that are expected to fail for one reason.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct ExpectedFailure {
    /// Benchmark.
    pub id: String,
    /// Variants, as in the table; for a row on the balances the id of the benchmark is enough.
    pub cases: Vec<String>,
    /// Quantities, as in the table.
    pub quantities: Vec<String>,
    /// Why the figures fail.
    pub reason: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    #[serde(default)]
    row: Vec<ExpectedFailure>,
}

impl ExpectedFailure {
    /// Whether a row is one of these failures.
    #[must_use]
    pub fn is_about(&self, row: &Row) -> bool {
        self.id == row.id
            && self.quantities.contains(&row.quantity)
            && (self.cases.contains(&row.case) || self.is_about_worst_run(row))
    }

    /// Whether a row is on the balances of the worst run of a benchmark that is listed by its id alone.
    fn is_about_worst_run(&self, row: &Row) -> bool {
        let benchmark = row.case.split(',').next().and_then(find);
        benchmark.is_some_and(|id| self.cases.iter().any(|case| case == id))
    }
}

/// The list; empty if the file cannot be read as one (a test makes sure that it can).
#[must_use]
pub fn expected_failures() -> Vec<ExpectedFailure> {
    toml::from_str::<List>(FILE).map(|list| list.row).unwrap_or_default()
}

/// Where the rows disagree with the list: rows that fail without being listed, and listed rows that pass. The
/// worst run of the `fast` part of a benchmark may pass where that of the whole benchmark does not.
#[must_use]
pub fn disagreements(rows: &[Row], expected: &[ExpectedFailure], fast: bool) -> Vec<String> {
    let mut all = Vec::new();
    for row in rows {
        let is_expected = expected.iter().any(|k| k.is_about(row));
        let is_part = fast && expected.iter().any(|k| k.is_about(row) && k.is_about_worst_run(row));
        let name = format!("{} · {} · {}", row.id, row.case, row.quantity);
        match row.passes() {
            Some(false) if !is_expected => {
                all.push(format!("{name} fails and is not in validation/expected_failures.toml"))
            }
            Some(true) if is_expected && !is_part => {
                all.push(format!("{name} passes but is in validation/expected_failures.toml"))
            }
            _ => {}
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn about(id: &str, case: &str) -> ExpectedFailure {
        let words = |text: &str| vec![text.to_owned()];
        ExpectedFailure {
            id: id.into(),
            cases: words(case),
            quantities: words("q"),
            reason: "because".into(),
        }
    }

    #[test]
    fn the_list_can_be_read() {
        let list: List = toml::from_str(FILE).unwrap();
        assert!(list.row.iter().all(|k| !k.reason.trim().is_empty()));
    }

    #[test]
    fn only_disagreements_are_reported() {
        let expected = [about("B1", "a")];
        let row = |case: &str, obtained| Row::info("B1", case, "q", obtained).within(1.0, 0.1, "");
        assert!(disagreements(&[row("a", 2.0), row("b", 1.0)], &expected, false).is_empty());
        assert_eq!(disagreements(&[row("a", 1.0), row("b", 2.0)], &expected, false).len(), 2);
    }

    #[test]
    fn a_benchmark_stands_for_its_worst_run() {
        let expected = about("C4", "B1");
        assert!(expected.is_about(&Row::info("C4", "B1, B/h = 8", "q", 1.0)));
        assert!(!expected.is_about(&Row::info("C4", "B5, H/h = 8", "q", 1.0)));
        assert!(!expected.is_about(&Row::info("C4", "B1", "another", 1.0)));
        let passes = [Row::info("C4", "B1, B/h = 8", "q", 1.0).within(1.0, 0.1, "")];
        assert_eq!(disagreements(&passes, std::slice::from_ref(&expected), false).len(), 1);
        assert!(disagreements(&passes, &[expected], true).is_empty());
    }
}
