//! The rows that are known to fall short, each with its reason: kept in one file, and kept honest.

use super::row::Row;
use serde::Deserialize;

const FILE: &str = include_str!("../../../../validation/known.toml");

/// A row that is known to fall short.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Known {
    /// Benchmark.
    pub id: String,
    /// Variant, as in the table; of a ledger's row its beginning up to the comma will do.
    pub case: String,
    /// Quantity, as in the table.
    pub quantity: String,
    /// Why it falls short.
    pub reason: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    #[serde(default)]
    row: Vec<Known>,
}

impl Known {
    /// Whether a row is the one that is meant.
    #[must_use]
    pub fn is_about(&self, row: &Row) -> bool {
        let case = row.case == self.case || row.case.split(',').next() == Some(self.case.as_str());
        self.id == row.id && case && self.quantity == row.quantity
    }
}

/// The list; empty if the file is not one (a test sees to it that it is).
#[must_use]
pub fn known() -> Vec<Known> {
    toml::from_str::<List>(FILE).map(|list| list.row).unwrap_or_default()
}

/// What does not agree with the list: rows outside it that fall short, rows in it that pass.
#[must_use]
pub fn disagreements(rows: &[Row], known: &[Known]) -> Vec<String> {
    let mut all = Vec::new();
    for row in rows {
        let is_known = known.iter().any(|k| k.is_about(row));
        let name = format!("{} · {} · {}", row.id, row.case, row.quantity);
        match row.passes() {
            Some(false) if !is_known => {
                all.push(format!("{name} falls short and is not in validation/known.toml"))
            }
            Some(true) if is_known => all.push(format!("{name} passes but is in validation/known.toml")),
            _ => {}
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_can_be_read() {
        let list: List = toml::from_str(FILE).unwrap();
        assert!(list.row.iter().all(|k| !k.reason.trim().is_empty()));
    }

    #[test]
    fn only_what_disagrees_is_told() {
        let known =
            [Known { id: "B1".into(), case: "a".into(), quantity: "q".into(), reason: "because".into() }];
        let row = |case: &str, obtained| Row::note("B1", case, "q", obtained).within(1.0, 0.1, "");
        assert!(disagreements(&[row("a", 2.0), row("b", 1.0)], &known).is_empty());
        assert_eq!(disagreements(&[row("a", 1.0), row("b", 2.0)], &known).len(), 2);
    }
}
