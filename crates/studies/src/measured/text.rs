//! The lines and fields of a CSV text, each with its place, so that a problem can point at it.

use coulter::case::Problem;
use std::ops::Range;

/// What is wrong, and at which bytes of the text.
pub(super) type Placed = (Range<usize>, Problem);

/// A problem at a place.
pub(super) fn placed(at: Range<usize>, message: impl Into<String>, cure: impl Into<String>) -> Placed {
    (at, Problem::new("", message, cure))
}

/// A field of a line, without blanks and quotes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Field<'a> {
    pub(super) text: &'a str,
    pub(super) at: Range<usize>,
}

/// A line that is neither empty nor a comment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Line<'a> {
    pub(super) fields: Vec<Field<'a>>,
    pub(super) at: Range<usize>,
}

/// The lines of a text and its comments. Fields are separated by semicolons where the first line has one, otherwise by commas.
pub(super) fn lines(text: &str) -> (Vec<Line<'_>>, Vec<Field<'_>>) {
    let (mut found, mut comments) = (Vec::new(), Vec::new());
    let mut separator = None;
    let mut start = 0;
    for whole in text.split_inclusive('\n') {
        let line = trimmed(whole, start);
        start += whole.len();
        if let Some(comment) = line.text.strip_prefix('#') {
            comments.push(trimmed(comment, line.at.start + 1));
        } else if !line.text.is_empty() {
            let separator = *separator.get_or_insert_with(|| if line.text.contains(';') { ';' } else { ',' });
            found.push(Line { fields: fields(&line, separator), at: line.at });
        }
    }
    (found, comments)
}

fn fields<'a>(line: &Field<'a>, separator: char) -> Vec<Field<'a>> {
    let mut start = line.at.start;
    let field = |text: &'a str| {
        let found = trimmed(text, start);
        start += text.len() + separator.len_utf8();
        unquoted(found)
    };
    line.text.split(separator).map(field).collect()
}

/// A piece of text that begins at a byte, without the blanks and the mark of byte order around it.
fn trimmed(text: &str, start: usize) -> Field<'_> {
    let is_blank = |c: char| c.is_whitespace() || c == '\u{feff}';
    let from = text.len() - text.trim_start_matches(is_blank).len();
    let inner = text.trim_matches(is_blank);
    Field { text: inner, at: start + from..start + from + inner.len() }
}

fn unquoted(field: Field<'_>) -> Field<'_> {
    match field.text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inner) => trimmed(inner, field.at.start + 1),
        None => field,
    }
}
