//! The rows that are known to fall short, each with its reason: kept in one file, and kept honest.

use super::list::find;
use super::row::Row;
use serde::Deserialize;

const FILE: &str = include_str!("../../../../validation/known.toml");

/// Rows that are known to fall short for one reason.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Known {
    /// Benchmark.
    pub id: String,
    /// Variants, as in the table; of a ledger's row the benchmark's id will do.
    pub cases: Vec<String>,
    /// Quantities, as in the table.
    pub quantities: Vec<String>,
    /// Why they fall short.
    pub reason: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    #[serde(default)]
    row: Vec<Known>,
}

impl Known {
    /// Whether a row is among those that are meant.
    #[must_use]
    pub fn is_about(&self, row: &Row) -> bool {
        self.id == row.id
            && self.quantities.contains(&row.quantity)
            && (self.cases.contains(&row.case) || self.is_about_worst_run(row))
    }

    /// Whether a row is a ledger's, named after its benchmark and the worst run, and meant by the benchmark alone.
    fn is_about_worst_run(&self, row: &Row) -> bool {
        let benchmark = row.case.split(',').next().and_then(find);
        benchmark.is_some_and(|id| self.cases.iter().any(|case| case == id))
    }
}

/// The list; empty if the file is not one (a test sees to it that it is).
#[must_use]
pub fn known() -> Vec<Known> {
    toml::from_str::<List>(FILE).map(|list| list.row).unwrap_or_default()
}

/// What does not agree with the list: rows outside it that fall short, rows in it that pass. The worst run of the `fast`
/// part of a benchmark may pass where that of the whole does not.
#[must_use]
pub fn disagreements(rows: &[Row], known: &[Known], fast: bool) -> Vec<String> {
    let mut all = Vec::new();
    for row in rows {
        let is_known = known.iter().any(|k| k.is_about(row));
        let is_part = fast && known.iter().any(|k| k.is_about(row) && k.is_about_worst_run(row));
        let name = format!("{} · {} · {}", row.id, row.case, row.quantity);
        match row.passes() {
            Some(false) if !is_known => {
                all.push(format!("{name} falls short and is not in validation/known.toml"))
            }
            Some(true) if is_known && !is_part => {
                all.push(format!("{name} passes but is in validation/known.toml"))
            }
            _ => {}
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn about(id: &str, case: &str) -> Known {
        let words = |text: &str| vec![text.to_owned()];
        Known { id: id.into(), cases: words(case), quantities: words("q"), reason: "because".into() }
    }

    #[test]
    fn the_list_can_be_read() {
        let list: List = toml::from_str(FILE).unwrap();
        assert!(list.row.iter().all(|k| !k.reason.trim().is_empty()));
    }

    #[test]
    fn only_what_disagrees_is_told() {
        let known = [about("B1", "a")];
        let row = |case: &str, obtained| Row::note("B1", case, "q", obtained).within(1.0, 0.1, "");
        assert!(disagreements(&[row("a", 2.0), row("b", 1.0)], &known, false).is_empty());
        assert_eq!(disagreements(&[row("a", 1.0), row("b", 2.0)], &known, false).len(), 2);
    }

    #[test]
    fn a_benchmark_stands_for_its_worst_run() {
        let known = about("C4", "B1");
        assert!(known.is_about(&Row::note("C4", "B1, B/h = 8", "q", 1.0)));
        assert!(!known.is_about(&Row::note("C4", "B5, H/h = 8", "q", 1.0)));
        assert!(!known.is_about(&Row::note("C4", "B1", "another", 1.0)));
        let passes = [Row::note("C4", "B1, B/h = 8", "q", 1.0).within(1.0, 0.1, "")];
        assert_eq!(disagreements(&passes, std::slice::from_ref(&known), false).len(), 1);
        assert!(disagreements(&passes, &[known], true).is_empty());
    }
}
