//! From the text of a CSV file to a record in SI units, or to everything that is wrong with it.

use super::header::{Content, columns};
use super::text::{Field, Line, Placed, lines, placed};
use super::{Channel, Quantity, Record};
use crate::files;
use coulter::case::CaseError;
use std::path::Path;

/// Largest file that is read [bytes]: some 200 000 lines of five columns.
pub const MAX_BYTES: u64 = 16 << 20;
/// Least number of lines of a curve.
const MIN_LINES: usize = 2;
/// Problems after which reading ends; more would not be shown.
const MAX_PROBLEMS: usize = 40;
/// What begins a comment that sets a key of the case for this measurement.
const SETTING: &str = "set ";

/// Reads a measured curve.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong with the file, with its line and a cure.
pub fn read(path: &Path) -> Result<Record, CaseError> {
    let name = path.display().to_string();
    let bytes = files::read(path, MAX_BYTES).map_err(|error| {
        let cure =
            "check the path; a measured curve is a CSV file of at most 16 MB, with fewer lines if need be";
        CaseError::unreadable(&name, error.to_string(), cure)
    })?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = valid.iter().filter(|byte| **byte == b'\n').count() + 1;
        let message = format!("{name}: not a text file: line {line} is not UTF-8");
        CaseError::unreadable(&name, message, "save it as CSV in UTF-8")
    })?;
    parse(&text, &name)
}

/// As [`read`], from the text of the file; `name` is what to call it in messages.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, name: &str) -> Result<Record, CaseError> {
    let mut problems = Vec::new();
    let record = record(text, name, &mut problems);
    match record {
        Some(record) if problems.is_empty() => Ok(record),
        _ => Err(CaseError::in_text(name, text, problems)),
    }
}

fn record(text: &str, name: &str, problems: &mut Vec<Placed>) -> Option<Record> {
    let (lines, comments) = lines(text);
    let Some((header, body)) = lines.split_first() else {
        let cure = "begin with a header such as sinkage [mm],vertical [N], then lines of numbers";
        problems.push(placed(0..0, "the file is empty", cure));
        return None;
    };
    let contents = columns(header, problems);
    if !problems.is_empty() {
        return None;
    }
    let mut values = vec![Vec::with_capacity(body.len()); contents.len()];
    for line in body {
        row(line, &contents, &mut values, problems);
        if problems.len() > MAX_PROBLEMS {
            return None;
        }
    }
    if body.len() < MIN_LINES {
        let message = format!("{} lines of numbers are not a curve", body.len());
        problems.push(placed(header.at.clone(), message, "give it two lines or more below the header"));
    }
    rising(body, &contents, &values, problems);
    let settings = comments.iter().filter_map(|comment| comment.text.strip_prefix(SETTING));
    Some(Record {
        name: name.to_owned(),
        channels: channels(&contents, &values),
        settings: settings.map(|setting| setting.trim().to_owned()).collect(),
        lines: numbers(text, body),
    })
}

/// The numbers of lines, from 1.
fn numbers(text: &str, lines: &[Line<'_>]) -> Vec<usize> {
    let (mut number, mut from) = (1, 0);
    let count = |line: &Line<'_>| {
        number += text.as_bytes()[from..line.at.start].iter().filter(|byte| **byte == b'\n').count();
        from = line.at.start;
        number
    };
    lines.iter().map(count).collect()
}

/// Reads a line into the columns.
fn row(line: &Line<'_>, contents: &[Content], values: &mut [Vec<f64>], problems: &mut Vec<Placed>) {
    if line.fields.len() != contents.len() {
        let message = format!("{} fields, but the header has {}", line.fields.len(), contents.len());
        let cure = "give every line a number for each column; decimals are written with a point";
        problems.push(placed(line.at.clone(), message, cure));
        return;
    }
    for ((field, content), column) in line.fields.iter().zip(contents).zip(values) {
        let (factor, is_deviation) = match content {
            Content::Values(_, factor) => (*factor, false),
            Content::Deviations(_, factor) => (*factor, true),
            Content::Ignored => continue,
        };
        match number(field, is_deviation) {
            Ok(number) => column.push(factor * number),
            Err(problem) => problems.push(problem),
        }
    }
}

fn number(field: &Field<'_>, is_deviation: bool) -> Result<f64, Placed> {
    let at = field.at.clone();
    if field.text.is_empty() {
        // Nothing stands there: point at the separator.
        return Err(placed(at.start..at.start + 1, "an empty field", "give a number, or leave the line out"));
    }
    let Ok(number) = field.text.replace('−', "-").parse::<f64>() else {
        let cure = if field.text.contains(',') {
            "write decimals with a point, such as 12.5"
        } else {
            "give a number such as 12.5 or 1.25e-3; units stand in the header"
        };
        return Err(placed(at, format!("\"{}\" is not a number", field.text), cure));
    };
    if !number.is_finite() {
        return Err(placed(at, format!("\"{}\" is not a finite number", field.text), "leave the line out"));
    }
    if is_deviation && number <= 0.0 {
        let cure = "give the standard deviation of the value, in its unit, or leave the column out";
        return Err(placed(at, format!("a standard deviation of {number} is not above 0"), cure));
    }
    Ok(number)
}

/// Refuses times that do not rise.
fn rising(lines: &[Line<'_>], contents: &[Content], values: &[Vec<f64>], problems: &mut Vec<Placed>) {
    let is_time = |content: &Content| matches!(content, Content::Values(Quantity::Time, _));
    let Some(column) = contents.iter().position(is_time) else { return };
    // Without a number in every line they cannot be matched.
    if values[column].len() != lines.len() {
        return;
    }
    if let Some(n) = values[column].windows(2).position(|pair| pair[1] <= pair[0]) {
        let at = lines[n + 1].fields[column].at.clone();
        problems.push(placed(at, "the time does not rise", "sort the lines by time, each time once"));
    }
}

fn channels(contents: &[Content], values: &[Vec<f64>]) -> Vec<Channel> {
    let deviations = |wanted: Quantity| {
        let is_it = |content: &Content| matches!(content, Content::Deviations(q, _) if *q == wanted);
        contents.iter().position(is_it).map(|n| values[n].clone())
    };
    let channel = |(content, values): (&Content, &Vec<f64>)| match content {
        Content::Values(quantity, _) => {
            Some(Channel { quantity: *quantity, values: values.clone(), deviations: deviations(*quantity) })
        }
        _ => None,
    };
    contents.iter().zip(values).filter_map(channel).collect()
}
