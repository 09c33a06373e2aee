//! What a table must be before it is written.

use super::Table;
use super::error::TableError;
use std::collections::BTreeSet;

/// Refuses a table with columns of one name or of different length.
pub(super) fn check(table: &Table) -> Result<(), TableError> {
    let mut names = BTreeSet::new();
    for column in &table.columns {
        if !names.insert(&column.name) {
            return Err(TableError::SameName(column.name.clone()));
        }
        if column.values.len() != table.rows() {
            return Err(TableError::Length(column.name.clone()));
        }
    }
    Ok(())
}
