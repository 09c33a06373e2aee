//! Tables of numbers in text files: a header line, comma-separated fields, an empty field for no value.

use crate::files::{Inside, OutputError, read_text};
use std::fmt::Write as _;
use std::path::Path;

/// A table of numbers, column by column.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Names of the columns, with their units.
    pub header: Vec<String>,
    /// The columns, all of one length; an empty field is not-a-number.
    pub columns: Vec<Vec<f64>>,
}

impl Table {
    /// Reads a comma-separated file; lines that begin with `#` are skipped.
    ///
    /// # Errors
    /// When the file cannot be read, a line has too many or too few fields, or a field is not a number.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        Self::parse(&read_text(&Inside::at(path))?).map_err(|problem| OutputError::content(path, problem))
    }

    /// Reads the table of a run; for a killed run (not `is_whole`) without an incomplete last line.
    pub(super) fn read_history(file: &Inside, is_whole: bool) -> Result<Self, OutputError> {
        let text = read_text(file)?;
        let end = if is_whole { text.len() } else { text.rfind('\n').map_or(0, |n| n + 1) };
        Self::parse(&text[..end]).map_err(|problem| OutputError::content(&file.path(), problem))
    }

    fn parse(text: &str) -> Result<Self, String> {
        let mut lines =
            text.lines().enumerate().filter(|(_, line)| !line.starts_with('#') && !line.trim().is_empty());
        let Some((_, first)) = lines.next() else { return Err("the file is empty".to_owned()) };
        let header: Vec<String> = first.split(',').map(|name| name.trim().to_owned()).collect();
        let mut columns = vec![Vec::new(); header.len()];
        for (n, line) in lines {
            let fields: Vec<&str> = line.split(',').collect();
            if fields.len() != header.len() {
                return Err(format!("line {}: {} fields, expected {}", n + 1, fields.len(), header.len()));
            }
            for (column, field) in columns.iter_mut().zip(fields) {
                column.push(
                    parse_number(field)
                        .ok_or_else(|| format!("line {}: `{field}` is not a number", n + 1))?,
                );
            }
        }
        Ok(Self { header, columns })
    }

    /// The column whose header is `name`, or begins with `name` and then its unit.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let index = self.header.iter().position(|h| h == name).or_else(|| {
            self.header.iter().position(|h| h.strip_prefix(name).is_some_and(|rest| rest.starts_with(" [")))
        })?;
        self.columns.get(index).map(Vec::as_slice)
    }

    /// Number of lines below the header.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }
}

fn parse_number(field: &str) -> Option<f64> {
    let field = field.trim();
    if field.is_empty() { Some(f64::NAN) } else { field.parse().ok() }
}

/// Appends one line to a table's text.
pub fn push_line(text: &mut String, values: &[f64]) {
    for (n, value) in values.iter().enumerate() {
        if n > 0 {
            text.push(',');
        }
        push_number(text, *value);
    }
    text.push('\n');
}

/// Nine significant digits without trailing zeros; nothing for not-a-number.
fn push_number(text: &mut String, value: f64) {
    if !value.is_finite() {
        return;
    }
    let rounded: f64 = format!("{value:.8e}").parse().unwrap_or(value);
    let size = rounded.abs();
    // Writing to a string cannot fail.
    let _ = if size != 0.0 && !(1e-4..1e10).contains(&size) {
        write!(text, "{rounded:e}")
    } else {
        write!(text, "{}", rounded + 0.0)
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        let mut text = String::from("a [m],b,c,d,e\n");
        push_line(&mut text, &[0.1 + 0.2, f64::NAN, 1.234_567_891_23e-7, -0.0, -1500.0]);
        assert_eq!(text.lines().nth(1), Some("0.3,,1.23456789e-7,0,-1500"));
        let table = Table::parse(&text).unwrap();
        assert_eq!(table.rows(), 1);
        assert_eq!(table.column("a"), Some(&[0.3][..]));
        assert!(table.columns[1][0].is_nan());
    }

    #[test]
    fn broken_tables_are_refused_with_the_line() {
        assert!(Table::parse("").is_err());
        assert!(Table::parse("a,b\n1,2\n3\n").unwrap_err().contains("line 3"));
        assert!(Table::parse("a\nx\n").unwrap_err().contains("`x` is not a number"));
    }
}
