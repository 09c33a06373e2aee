//! Tables with names.

use crate::table::Table;

/// A table with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedTable {
    /// Name of the file of the table, without ending.
    pub name: String,
    /// Title.
    pub title: String,
    /// The table.
    pub table: Table,
}
