//! A design from a CSV file: points that are run first, such as those of an earlier calibration (`runs.csv`).

use super::space::Space;
use crate::files;
use coulter::case::{CaseError, Problem};
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
    let text = String::from_utf8(bytes).map_err(|_| refuse(format!("{name}: not a text file in UTF-8")))?;
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| refuse(error.to_string()))?.clone();
    let column = |unknown: &super::space::Unknown| {
        let unit = if unknown.unit.is_empty() { "-" } else { &unknown.unit };
        let wanted = format!("{} [{unit}]", unknown.name);
        header.iter().position(|found| found == wanted).ok_or(wanted)
    };
    let columns: Vec<usize> = space
        .unknowns
        .iter()
        .map(column)
        .collect::<Result<_, _>>()
        .map_err(|wanted| refuse(format!("{name}: the column {wanted} is missing")))?;
    let mut points = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| refuse(error.to_string()))?;
        let start = record.position().map_or(0, |place| usize::try_from(place.byte()).unwrap_or(0));
        let number =
            |n: &usize| record.get(*n).and_then(|field| field.parse().ok()).filter(|v: &f64| v.is_finite());
        let values: Option<Vec<f64>> = columns.iter().map(number).collect();
        points.push(values.ok_or_else(|| {
            let problem = Problem::new("", "not a number for every parameter", "give every line all of them");
            CaseError::in_text(&name, &text, vec![(start..start + 1, problem)])
        })?);
    }
    Ok(points)
}
