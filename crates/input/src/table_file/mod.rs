//! Tables of numbers under a header, in whatever dialect a program writes them: measured curves, motions over
//! time, heights, designs.
//!
//! Fields are separated by semicolons, tabs, commas or runs of spaces, whichever the first line has; lines
//! end in LF, CR LF or CR. `#` begins a comment. Where the separator is no comma, or a number stands in
//! quotes, decimals may have a comma. The header names the columns, each with its unit in square or round
//! brackets or in a line of units below it. What had to be guessed is a remark;
//! docs/reference/tables.md describes the dialect.

mod header;
mod lines;
mod number;
mod placed;
mod separator;
mod text;
mod words;

pub use header::{TableColumn, plain_name};
pub use lines::{Field, Line};
pub(crate) use placed::line_of;
pub use placed::{Placed, placed};
pub use text::TableText;
pub(crate) use words::Words;

use super::data_file::FileProblem;
use lines::{Separator, comments, contents};
use number::Numbers;
use separator::separator_of;
use std::ops::Range;

/// Problems after which reading ends; more would not be shown.
const MAX_PROBLEMS: usize = 40;
/// Lines from which the dialect is known.
const SAMPLE: usize = 20;

/// A table: its text, and how that is to be read.
#[derive(Clone, Debug)]
pub struct TableFile {
    text: TableText,
    separator: Separator,
    columns: Vec<TableColumn>,
    header: Range<usize>,
    /// Where the lines of numbers begin [bytes].
    body: usize,
}

/// The numbers of a table without a header, line by line; the numbers of its columns and lines, and what is
/// to be said of how they were read.
type Grid = (Vec<f64>, [usize; 2], Option<String>);

/// Numbers of a table.
#[derive(Clone, Debug, Default)]
pub struct TableNumbers {
    /// The columns that were asked for, in the units of the file.
    pub columns: Vec<Vec<f64>>,
    /// Where each line begins [bytes].
    pub lines: Vec<usize>,
    /// What is wrong with the numbers.
    pub problems: Vec<Placed>,
    /// A remark on how the numbers were read.
    pub remark: Option<String>,
}

impl TableFile {
    /// Finds the dialect and the header of a text.
    #[must_use]
    pub fn new(text: TableText) -> Self {
        let sample: Vec<Field<'_>> = contents(&text.text, 0).take(SAMPLE).collect();
        let separator = separator_of(&sample);
        let is_numeric = |line: &Field<'_>| {
            let fields = separator.split(line);
            fields.iter().all(|field| field.text.is_empty() || number::is_number(field, separator))
        };
        let mut table =
            Self { separator, columns: Vec::new(), header: 0..0, body: 0, text: TableText::default() };
        if let Some(first) = sample.first().filter(|first| !is_numeric(first)) {
            // Below a line of units there are numbers.
            let fields = sample.last().map_or(0, |line| separator.split(line).len());
            table.columns = header::columns(&separator.split_names(first, fields));
            table.header = first.at.clone();
            table.body = first.at.end;
            if let Some(second) = sample.get(1) {
                let line = Line { fields: separator.split(second), at: second.at.clone() };
                if header::take_units(&mut table.columns, &line, separator) {
                    table.body = second.at.end;
                }
            }
        }
        table.text = text;
        table
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`FileProblem`] where it is no text.
    pub fn read(bytes: Vec<u8>) -> Result<Self, FileProblem> {
        TableText::decode(bytes).map(Self::new)
    }

    /// Text of the file; places of problems refer to it.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text.text
    }

    /// A remark on how the text was read.
    #[must_use]
    pub fn remark(&self) -> Option<&str> {
        self.text.remark.as_deref()
    }

    /// The columns that the header of the table names; none where the table begins with numbers.
    #[must_use]
    pub fn columns(&self) -> &[TableColumn] {
        &self.columns
    }

    /// Where the header stands [bytes].
    #[must_use]
    pub fn header(&self) -> Range<usize> {
        self.header.clone()
    }

    /// The titles of the columns, for messages.
    #[must_use]
    pub fn titles(&self) -> String {
        self.columns.iter().map(|column| format!("\"{}\"", column.title)).collect::<Vec<_>>().join(", ")
    }

    /// Comments of the file, without their `#`.
    pub fn comments(&self) -> impl Iterator<Item = &str> {
        comments(&self.text.text)
    }

    /// The lines below the header.
    pub fn lines(&self) -> impl Iterator<Item = Line<'_>> {
        contents(&self.text.text, self.body)
            .map(|line| Line { fields: self.separator.split(&line), at: line.at })
    }

    /// Whether a column holds text: none of its first fields is a number.
    #[must_use]
    pub fn is_text(&self, column: usize) -> bool {
        let is_number = |line: Line<'_>| {
            line.fields.get(column).is_some_and(|field| number::is_number(field, self.separator))
        };
        !self.lines().take(SAMPLE).any(is_number)
    }

    /// The numbers in some columns; `absent` says what is to be done about a field without one.
    #[must_use]
    pub fn numbers(&self, wanted: &[usize], absent: &'static str) -> TableNumbers {
        let mut body = TableNumbers { columns: vec![Vec::new(); wanted.len()], ..TableNumbers::default() };
        let mut numbers = Numbers::new(self.separator, absent);
        for line in self.lines() {
            match self.count(&line, wanted) {
                Some(problem) => body.problems.push(problem),
                None => {
                    for (column, n) in body.columns.iter_mut().zip(wanted) {
                        match numbers.read(&line.fields[*n]) {
                            Ok(number) => column.push(number),
                            Err(problem) => body.problems.push(problem),
                        }
                    }
                }
            }
            body.lines.push(line.at.start);
            if body.problems.len() > MAX_PROBLEMS {
                break;
            }
        }
        body.remark = numbers.remark();
        body
    }

    /// What is wrong with the number of fields of a line: those that are wanted must be there, and none
    /// beyond the header.
    fn count(&self, line: &Line<'_>, wanted: &[usize]) -> Option<Placed> {
        // Without a header a line has as many as it has.
        let names = if self.columns.is_empty() { line.fields.len() } else { self.columns.len() };
        let beyond = line.fields.iter().skip(names).filter(|field| !field.text.is_empty()).count();
        let lacks = wanted.iter().any(|n| *n >= line.fields.len());
        if beyond == 0 && !lacks {
            return None;
        }
        let fields = line.fields.iter().rposition(|field| !field.text.is_empty()).map_or(0, |n| n + 1);
        let message = format!("{fields} fields, but the header has {names}");
        let cure = match self.separator {
            Separator::Comma => {
                "give every line a number for each column; decimals are written with a point where commas separate"
            }
            _ => "give every line a number for each column",
        };
        Some(placed(line.at.clone(), message, cure))
    }

    /// Every number of a table without a header, line by line; the numbers of its columns and lines, and what
    /// is to be said of how they were read.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn grid(&self, absent: &'static str) -> Result<Grid, Placed> {
        let mut numbers = Numbers::new(self.separator, absent);
        let (mut all, mut size) = (Vec::new(), [0, 0]);
        for line in self.lines() {
            let mut fields = &line.fields[..];
            // A separator at the end of a line separates nothing.
            if let [inner @ .., last] = fields
                && last.text.is_empty()
                && (size[1] == 0 || inner.len() == size[0])
            {
                fields = inner;
            }
            if size[1] > 0 && fields.len() != size[0] {
                let message = format!("{} fields, but the first line has {}", fields.len(), size[0]);
                return Err(placed(line.at, message, "give every line as many numbers as the first"));
            }
            for field in fields {
                all.push(numbers.read(field)?);
            }
            size = [fields.len(), size[1] + 1];
        }
        Ok((all, size, numbers.remark()))
    }

    /// Where a field of the line that begins at a byte stands; of an empty one the separator behind it.
    #[must_use]
    pub fn place(&self, line: usize, column: usize) -> Range<usize> {
        let found = contents(&self.text.text, line).next().map(|line| self.separator.split(&line));
        found.and_then(|fields| Some(fields.get(column)?.at.clone())).unwrap_or(line..line + 1)
    }

    /// The numbers, from 1, of the lines that begin at these bytes, which rise.
    #[must_use]
    pub fn line_numbers(&self, starts: &[usize]) -> Vec<usize> {
        let (mut number, mut from) = (1, 0);
        let count = |start: &usize| {
            number += self.text.text.as_bytes()[from..*start].iter().filter(|byte| **byte == b'\n').count();
            from = *start;
            number
        };
        starts.iter().map(count).collect()
    }

    /// The line of a byte, counted from 1.
    #[must_use]
    pub fn line_of(&self, at: usize) -> usize {
        line_of(&self.text.text, at)
    }

    /// A problem with its line in words.
    #[must_use]
    pub fn in_words(&self, (at, problem): Placed) -> FileProblem {
        let message = format!("line {}: {}", self.line_of(at.start), problem.message);
        FileProblem { message, cure: problem.cure }
    }
}
