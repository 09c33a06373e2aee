//! The rows of a table that belong to a part of a study.

use crate::study::Part;
use crate::table::{Column, Table, Values};

/// The rows of a part, with the factors that it varies.
pub(super) fn of_part(table: &Table, part: &Part) -> Table {
    if part.name.is_empty() {
        return table.clone();
    }
    let names = table.words("part").unwrap_or_default();
    let keep: Vec<bool> = names.iter().map(|name| name.as_deref() == Some(part.name.as_str())).collect();
    rows(table, &keep)
}

/// The rows of a table that are kept.
pub(super) fn rows(table: &Table, keep: &[bool]) -> Table {
    let columns =
        table.columns.iter().map(|column| Column { values: kept(&column.values, keep), ..column.clone() });
    Table { columns: columns.collect() }
}

fn kept(values: &Values, keep: &[bool]) -> Values {
    match values {
        Values::Numbers(list) => Values::Numbers(
            list.iter().zip(keep).filter(|(_, keep)| **keep).map(|(value, _)| *value).collect(),
        ),
        Values::Words(list) => Values::Words(
            list.iter().zip(keep).filter(|(_, keep)| **keep).map(|(word, _)| word.clone()).collect(),
        ),
    }
}
