//! A design from a table: points that are run first, such as those of an earlier calibration (`runs.csv`).

use super::space::Space;
use crate::files;
use coulter::case::CaseError;
use coulter::case::table_file::{TableColumn, TableFile};
use std::path::Path;

/// Largest file that is read [bytes].
const MAX_BYTES: u64 = 1 << 20;

/// The points of a file whose columns are the unknowns with their units; other columns are left alone.
///
/// # Errors
/// [`CaseError`] says what is wrong with the file.
pub fn read_design(path: &Path, space: &Space) -> Result<Vec<Vec<f64>>, CaseError> {
    let name = path.display().to_string();
    let refuse = |why: String| {
        CaseError::unreadable(&name, why, "give a CSV file such as the runs.csv of a calibration")
    };
    let bytes = files::read(path, MAX_BYTES).map_err(|error| refuse(error.to_string()))?;
    let table = TableFile::read(bytes).map_err(|error| refuse(format!("{name}: {}", error.message)))?;
    let mut columns = Vec::new();
    for unknown in &space.unknowns {
        let unit = if unknown.unit.is_empty() { "-" } else { &unknown.unit };
        let is_it =
            |column: &TableColumn| column.name == unknown.name && column.unit.as_deref() == Some(unit);
        let found = table.columns().iter().position(is_it);
        columns.push(found.ok_or_else(|| {
            refuse(format!(
                "{name}: the column {} [{unit}] is missing; it has {}",
                unknown.name,
                table.titles()
            ))
        })?);
    }
    let body = table.numbers(&columns, "give every line a number for every parameter");
    if !body.problems.is_empty() {
        return Err(CaseError::in_text(&name, table.text(), body.problems));
    }
    Ok((0..body.lines.len()).map(|n| body.columns.iter().map(|column| column[n]).collect()).collect())
}
