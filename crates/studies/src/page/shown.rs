//! Tables as the page shows them.

use crate::analysis::NamedTable;
use crate::charts::axis_label;
use crate::table::{Column, Values};
use coulter::case::quantity::short;
use serde::Serialize;

/// Rows of a table on the page, at most (chosen); all are in its file.
const MOST_ROWS: usize = 200;

/// A table of texts.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ShownTable {
    name: String,
    title: String,
    columns: Vec<ShownColumn>,
    rows: Vec<ShownRow>,
    left_out: usize,
}

/// A row of texts.
#[derive(Clone, Debug, Serialize)]
struct ShownRow {
    cells: Vec<String>,
    /// Whether the figures of the row are in no mean, chart or index.
    unused: bool,
}

/// The head of a column.
#[derive(Clone, Debug, Serialize)]
struct ShownColumn {
    label: String,
    /// Whether the column is set to the right.
    number: bool,
}

/// A table as it is shown: without columns that have no value at all.
pub(super) fn shown_table(named: &NamedTable) -> ShownTable {
    let columns: Vec<&Column> = named.table.columns.iter().filter(|column| has_values(column)).collect();
    let count = named.table.rows().min(MOST_ROWS);
    let row = |row: usize| ShownRow {
        cells: columns.iter().map(|column| cell(column, row)).collect(),
        unused: !named.table.is_done(row),
    };
    ShownTable {
        name: named.name.clone(),
        title: named.title.clone(),
        columns: columns.iter().map(|column| head(column)).collect(),
        rows: (0..count).map(row).collect(),
        left_out: named.table.rows() - count,
    }
}

fn has_values(column: &Column) -> bool {
    match &column.values {
        Values::Numbers(list) => list.iter().any(Option::is_some),
        Values::Words(list) => list.iter().any(Option::is_some),
    }
}

fn head(column: &Column) -> ShownColumn {
    let label = axis_label(column);
    // Plain numbers need no unit in a table.
    let label = label.strip_suffix(" [–]").unwrap_or(&label).to_owned();
    ShownColumn { label, number: matches!(column.values, Values::Numbers(_)) }
}

fn cell(column: &Column, row: usize) -> String {
    match &column.values {
        Values::Words(list) => list[row].clone().unwrap_or_default(),
        Values::Numbers(list) => match list[row] {
            None => String::new(),
            // Points and ids are counted, not measured.
            Some(number) if number.fract() == 0.0 && number.abs() < 1e6 => {
                format!("{number}").replace('-', "\u{2212}")
            }
            // A portion that is all round-off.
            Some(number) if column.unit == "-" && number.abs() < 1e-9 => "0".to_owned(),
            Some(number) => short(number).replace('-', "\u{2212}"),
        },
    }
}
