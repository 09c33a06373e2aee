//! Rows whose figures are not used, by state and reason.

use crate::table::{Column, Role, Table, Values};
use serde::Serialize;

/// Rows that are named one by one, at most (chosen).
const NAMED: usize = 12;

/// Rows that are not used for the same reason.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Gap {
    /// State of the cases, such as `failed`.
    pub state: String,
    /// The reason; empty where none is given.
    pub reason: String,
    /// Number of the cases.
    pub count: usize,
    /// The cases by the keys of the table: `point 3, point 7 and 12 more`.
    pub which: String,
}

/// All rows of a table whose column `state` is not `done`, by state and by their column `reason`. A row
/// without a state has the state `missing`; a table without that column has no gaps.
#[must_use]
pub fn gaps(table: &Table) -> Vec<Gap> {
    let Some(states) = table.words("state") else { return Vec::new() };
    let reasons = table.words("reason");
    let mut found: Vec<(Gap, Vec<usize>)> = Vec::new();
    for (row, state) in states.iter().enumerate() {
        if table.is_done(row) {
            continue;
        }
        let state = state.clone().unwrap_or_else(|| "missing".to_owned());
        let reason = reasons.and_then(|list| list[row].clone()).unwrap_or_default();
        match found.iter_mut().find(|(gap, _)| gap.state == state && gap.reason == reason) {
            Some((_, rows)) => rows.push(row),
            None => found.push((Gap { state, reason, count: 0, which: String::new() }, vec![row])),
        }
    }
    let complete =
        |(gap, rows): (Gap, Vec<usize>)| Gap { count: rows.len(), which: which(table, &rows), ..gap };
    found.into_iter().map(complete).collect()
}

/// The names of some rows.
fn which(table: &Table, rows: &[usize]) -> String {
    let keys: Vec<&Column> = table.columns.iter().filter(|column| column.role == Role::Key).collect();
    let name = |row: &usize| {
        let parts: Vec<String> = keys.iter().filter_map(|column| part(column, *row)).collect();
        if parts.is_empty() { format!("row {}", row + 1) } else { parts.join(" ") }
    };
    let names: Vec<String> = rows.iter().take(NAMED).map(name).collect();
    let more = rows.len() - names.len();
    if more == 0 { names.join(", ") } else { format!("{} and {more} more", names.join(", ")) }
}

fn part(column: &Column, row: usize) -> Option<String> {
    match &column.values {
        Values::Words(list) => list[row].clone(),
        Values::Numbers(list) => list[row].map(|number| format!("{} {number}", column.name)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::charts::samples::column;

    #[test]
    fn rows_without_a_result_are_gathered_by_reason() {
        let words = |list: &[&str]| {
            Values::Words(list.iter().map(|w| (!w.is_empty()).then(|| (*w).to_owned())).collect())
        };
        let numbers = Values::Numbers((1..=5).map(|n| Some(f64::from(n))).collect());
        let table = Table {
            columns: vec![
                column("point", "-", Role::Key, numbers),
                column("state", "", Role::Remark, words(&["done", "failed", "failed", "", "failed"])),
                column("reason", "", Role::Remark, words(&["", "too deep", "no soil", "", "too deep"])),
            ],
        };
        let found = gaps(&table);
        assert_eq!(found.iter().map(|gap| gap.count).collect::<Vec<_>>(), [2, 1, 1]);
        assert_eq!((found[0].which.as_str(), found[2].state.as_str()), ("point 2, point 5", "missing"));
        assert!(gaps(&Table::default()).is_empty());
    }
}
