//! Lines and fields of a text, each with its place, so that a problem can point at it.

use std::ops::Range;

/// Lines over which a quoted field may go, as names of columns from a spreadsheet do.
const QUOTED_LINES: usize = 10;

/// A field of a line, without blanks and quotes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field<'a> {
    /// Text of the line.
    pub text: &'a str,
    /// Where the field stands in the text [bytes].
    pub at: Range<usize>,
    /// Whether the field stood in quotes.
    pub is_quoted: bool,
}

/// A line that is neither empty nor a comment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line<'a> {
    /// Fields of the line.
    pub fields: Vec<Field<'a>>,
    /// Where the line stands in the text [bytes].
    pub at: Range<usize>,
}

/// What separates the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    Semicolon,
    Tab,
    Comma,
    /// Runs of spaces and tabs.
    Blanks,
}

/// The lines of a text from a byte on that hold something: no comments, no lines of blanks and separators
/// alone.
pub(super) fn contents(text: &str, from: usize) -> impl Iterator<Item = Field<'_>> {
    let mut start = from;
    std::iter::from_fn(move || {
        while start < text.len() {
            let whole = whole_line(&text[start..]);
            let line = spaces_trimmed(whole, start);
            start += whole.len();
            let is_empty = line.text.chars().all(|c| c.is_whitespace() || matches!(c, ';' | ','));
            if !is_empty && !line.text.trim_start().starts_with('#') {
                return Some(line);
            }
        }
        None
    })
}

/// The comments of a text, without their `#`.
pub(super) fn comments(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| line.trim().strip_prefix('#')).map(str::trim)
}

/// The first line of a text with its end; more than one where a field in quotes goes on.
fn whole_line(text: &str) -> &str {
    let first = text.find('\n').map_or(text.len(), |n| n + 1);
    let (mut end, mut quotes) = (first, text[..first].matches('"').count());
    for _ in 1..QUOTED_LINES {
        if quotes % 2 == 0 {
            return &text[..end];
        }
        let next = text[end..].find('\n').map_or(text.len(), |n| end + n + 1);
        quotes += text[end..next].matches('"').count();
        end = next;
    }
    // A mark of inches, and no quote.
    &text[..first]
}

/// A field without line ends and spaces around it; a tab may stand for an empty field.
fn spaces_trimmed(text: &str, start: usize) -> Field<'_> {
    trimmed(text, start, |c| matches!(c, ' ' | '\n'))
}

fn trimmed(text: &str, start: usize, is_blank: impl Fn(char) -> bool) -> Field<'_> {
    let from = text.len() - text.trim_start_matches(&is_blank).len();
    let inner = text.trim_matches(&is_blank);
    Field { text: inner, at: start + from..start + from + inner.len(), is_quoted: false }
}

fn unquoted(field: Field<'_>) -> Field<'_> {
    match field.text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inner) => Field { is_quoted: true, ..trimmed(inner, field.at.start + 1, char::is_whitespace) },
        None => field,
    }
}

impl Separator {
    /// The fields of a line of numbers.
    pub(super) fn split<'a>(self, line: &Field<'a>) -> Vec<Field<'a>> {
        match self {
            Self::Semicolon => split_at(line, ';'),
            Self::Tab => split_at(line, '\t'),
            Self::Comma => split_at(line, ','),
            Self::Blanks => words(line, |_, c| c.is_whitespace()),
        }
    }

    /// The names in a header above lines of so many fields.
    pub(super) fn split_names<'a>(self, line: &Field<'a>, fields: usize) -> Vec<Field<'a>> {
        if self != Self::Blanks {
            return self.split(line);
        }
        // A name may have spaces in it; runs of them and brackets that close end it.
        let by_units =
            words(line, |before, c| c == '\t' || (c == ' ' && before.ends_with([' ', ']', ')', '\t'])));
        let by_words = words(line, |_, c| c.is_whitespace());
        if by_units.len() != fields && by_words.len() == fields { by_words } else { by_units }
    }
}

/// The line cut wherever `ends` says so of a blank and what stands before it; brackets and quotes are not
/// cut.
fn words<'a>(line: &Field<'a>, ends: impl Fn(&str, char) -> bool) -> Vec<Field<'a>> {
    let text = line.text;
    let (mut found, mut begin, mut depth, mut quoted) = (Vec::new(), 0, 0_i32, false);
    let mut push = |from: usize, to: usize| {
        let field = trimmed(&text[from..to], line.at.start + from, char::is_whitespace);
        if !field.text.is_empty() {
            found.push(unquoted(field));
        }
    };
    for (n, c) in text.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '[' | '(' => depth += 1,
            ']' | ')' => depth -= 1,
            _ if depth <= 0 && !quoted && ends(&text[begin..n], c)
                // A bracket that opens after blanks is the unit of what stands before them.
                && !text[n..].trim_start().starts_with(['[', '(']) =>
            {
                push(begin, n);
                begin = n;
            }
            _ => {}
        }
    }
    push(begin, text.len());
    found
}

fn split_at<'a>(line: &Field<'a>, separator: char) -> Vec<Field<'a>> {
    let has_quotes = line.text.contains('"');
    let mut is_quoted = false;
    let (mut found, mut begin, mut last) = (Vec::new(), 0, ' ');
    let field = |from: usize, to: usize| {
        unquoted(trimmed(&line.text[from..to], line.at.start + from, char::is_whitespace))
    };
    for (n, c) in line.text.char_indices() {
        if has_quotes && c == '"' {
            let opens = line.text[begin..n].trim().is_empty() || last == '"';
            is_quoted = !is_quoted && opens;
        }
        if c == separator && !is_quoted {
            found.push(field(begin, n));
            begin = n + c.len_utf8();
        }
        last = c;
    }
    if is_quoted {
        // A quote that nothing closes is none.
        let plain = line.text.split(separator);
        let mut start = line.at.start;
        return plain
            .map(|text| {
                let field = trimmed(text, start, char::is_whitespace);
                start += text.len() + separator.len_utf8();
                field
            })
            .collect();
    }
    found.push(field(begin, line.text.len()));
    found
}
