//! From the text of a table to a record in SI units, or to everything that is wrong with it.

use super::choice::ColumnChoice;
use super::header::{Content, columns};
use super::signs::settle_depth;
use super::{Channel, Quantity, Record};
use crate::files;
use coulter::case::CaseError;
use coulter::case::table_file::{Placed, TableFile, TableNumbers, TableText, placed};
use std::path::Path;

/// Largest file that is read [bytes]: some 200 000 lines of five columns.
pub const MAX_BYTES: u64 = 16 << 20;
/// Least number of lines of a curve.
const MIN_LINES: usize = 2;
/// What begins a comment that sets a key of the case for this measurement.
const SETTING: &str = "set ";
const ABSENT: &str = "give a number, leave the line out, or leave the column out with --column NAME=-";

/// Reads a measured curve; `choices` say what its columns are where its header does not.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong with the file, with its line and a cure.
pub fn read(path: &Path, choices: &[ColumnChoice]) -> Result<Record, CaseError> {
    let name = path.display().to_string();
    let bytes = files::read(path, MAX_BYTES).map_err(|error| {
        let cure =
            "check the path; a measured curve is a CSV file of at most 16 MB, with fewer lines if need be";
        CaseError::unreadable(&name, error.to_string(), cure)
    })?;
    let text = TableText::decode(bytes)
        .map_err(|error| CaseError::unreadable(&name, format!("{name}: {}", error.message), &error.cure))?;
    record(TableFile::new(text), &name, choices)
}

/// Reads measurements, like [`read`], from the text of the file; `name` is what to call it in messages.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, name: &str) -> Result<Record, CaseError> {
    record(TableFile::new(TableText::from(text)), name, &[])
}

fn record(table: TableFile, name: &str, choices: &[ColumnChoice]) -> Result<Record, CaseError> {
    let mut problems = Vec::new();
    let record = filled(&table, name, choices, &mut problems);
    match record {
        Some(record) if problems.is_empty() => Ok(record),
        _ => Err(CaseError::in_text(name, table.text(), problems)),
    }
}

fn filled(
    table: &TableFile,
    name: &str,
    choices: &[ColumnChoice],
    problems: &mut Vec<Placed>,
) -> Option<Record> {
    if table.columns().is_empty() && table.lines().next().is_none() {
        let cure = "begin with a header such as sinkage [mm],vertical [N], then lines of numbers";
        problems.push(placed(0..0, "the file is empty", cure));
        return None;
    }
    let header = columns(table, choices, problems);
    if !problems.is_empty() {
        return None;
    }
    let is_wanted = |n: &usize| header.contents[*n] != Content::Ignored;
    let wanted: Vec<usize> = (0..header.contents.len()).filter(is_wanted).collect();
    let contents: Vec<Content> = wanted.iter().map(|n| header.contents[*n]).collect();
    let mut body = table.numbers(&wanted, ABSENT);
    problems.append(&mut body.problems);
    if body.lines.len() < MIN_LINES {
        let message = format!("{} lines of numbers are not a curve", body.lines.len());
        problems.push(placed(table.header(), message, "give it two lines or more below the header"));
    }
    if !problems.is_empty() {
        return None;
    }
    rules(table, (&wanted, &contents), &body, problems);
    let mut remarks: Vec<String> = table.remark().map(str::to_owned).into_iter().collect();
    remarks.extend(header.remarks);
    remarks.extend(body.remark.take());
    let mut record = Record {
        name: name.to_owned(),
        channels: Vec::new(),
        settings: table
            .comments()
            .filter_map(|c| c.strip_prefix(SETTING))
            .map(|s| s.trim().to_owned())
            .collect(),
        titles: table.columns().iter().map(|column| column.title.clone()).collect(),
        lines: table.line_numbers(&body.lines),
        remarks,
    };
    channels(table, (&wanted, &contents), &body, (&mut record, problems));
    Some(record)
}

/// Fills a record with the values, in SI units and counted as the quantity is.
fn channels(
    table: &TableFile,
    (wanted, contents): (&[usize], &[Content]),
    body: &TableNumbers,
    (record, problems): (&mut Record, &mut Vec<Placed>),
) {
    for ((content, values), n) in contents.iter().zip(&body.columns).zip(wanted) {
        let Content::Values(found) = content else { continue };
        let values: Vec<f64> = values.iter().map(|value| found.factor * value).collect();
        let column = &table.columns()[*n];
        let values = match settle_depth(found, values, column, &mut record.remarks) {
            Ok(values) => values,
            Err(problem) => {
                problems.push(problem);
                continue;
            }
        };
        record.channels.push(Channel {
            quantity: found.quantity,
            values,
            deviations: deviations(found.quantity, contents, body),
            group: found.group,
            title: column.title.clone(),
            is_stated: found.is_stated(),
        });
    }
}

fn deviations(wanted: Quantity, contents: &[Content], body: &TableNumbers) -> Option<Vec<f64>> {
    contents.iter().zip(&body.columns).find_map(|(content, values)| match content {
        Content::Deviations(quantity, factor) if *quantity == wanted => {
            Some(values.iter().map(|value| factor * value).collect())
        }
        _ => None,
    })
}

/// Refuses standard deviations that are not above 0, and times that do not rise.
fn rules(
    table: &TableFile,
    (wanted, contents): (&[usize], &[Content]),
    body: &TableNumbers,
    problems: &mut Vec<Placed>,
) {
    for ((content, values), column) in contents.iter().zip(&body.columns).zip(wanted) {
        match content {
            Content::Deviations(..) => {
                let cure = "give the standard deviation of the value, in its unit, or leave the column out";
                for n in (0..values.len()).filter(|n| values[*n] <= 0.0) {
                    let message = format!("a standard deviation of {} is not above 0", values[n]);
                    problems.push(placed(table.place(body.lines[n], *column), message, cure));
                }
            }
            Content::Values(found) if found.quantity == Quantity::Time => {
                if let Some(n) = values.windows(2).position(|pair| pair[1] <= pair[0]) {
                    let at = table.place(body.lines[n + 1], *column);
                    problems.push(placed(
                        at,
                        "the time does not rise",
                        "sort the lines by time, each time once",
                    ));
                }
            }
            _ => {}
        }
    }
}
