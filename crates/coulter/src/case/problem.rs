//! What is wrong with a case, where, and what to do about it.

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};
use std::{fmt, ops::Range, sync::Arc};

/// A text that was typed: the case file, or one `--set`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Source {
    /// Its name: the path of the file, or `--set soil.cohesion`.
    pub(super) name: String,
    /// The text.
    pub(super) text: String,
}

/// A range of a source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Location {
    /// Number of the source; 0 is the file.
    pub(super) source: usize,
    /// Range of bytes in its text.
    pub(super) span: Range<usize>,
}

impl Location {
    /// The first byte of the file: for problems that concern the file as a whole.
    pub(super) fn file() -> Self {
        Self { source: 0, span: 0..0 }
    }
}

/// One thing that is wrong.
#[derive(Clone, Debug)]
pub struct Problem {
    /// What is wrong.
    pub message: String,
    /// How to fix it.
    pub cure: String,
    /// Line, counted from 1; 0 where the problem is not in the text.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
    span: Range<usize>,
    source: Arc<NamedSource<String>>,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Problem {}

impl Diagnostic for Problem {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        (!self.cure.is_empty()).then(|| Box::new(&self.cure) as _)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        (self.line > 0).then_some(&*self.source as _)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = LabeledSpan::new(Some("here".into()), self.span.start, self.span.len());
        (self.line > 0).then(|| Box::new(std::iter::once(label)) as _)
    }
}

/// A case that cannot be run: everything that is wrong with it.
#[derive(Clone, Debug)]
pub struct CaseError {
    /// Name of the case: the path of its file.
    pub name: String,
    /// The first few problems, in the order of the file.
    pub problems: Vec<Problem>,
    /// How many more there are.
    pub unseen: usize,
}

/// Problems that are reported at once.
const MAX_REPORTED: usize = 20;

impl CaseError {
    /// A case that could not even be read, e.g. because the file is missing.
    #[must_use]
    pub fn unreadable(name: &str, message: String, cure: &str) -> Self {
        let source = Arc::new(NamedSource::new(name, String::new()));
        let problem = Problem { message, cure: cure.to_owned(), line: 0, column: 0, span: 0..0, source };
        Self { name: name.to_owned(), problems: vec![problem], unseen: 0 }
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.problems.as_slice() {
            [one] => write!(f, "{}: {}", self.name, one.message),
            many => write!(f, "{}: {} problems", self.name, many.len() + self.unseen),
        }
    }
}

impl std::error::Error for CaseError {}

impl Diagnostic for CaseError {
    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn Diagnostic> + 'a>> {
        Some(Box::new(self.problems.iter().map(|p| p as &dyn Diagnostic)))
    }
}

/// Collects problems while a case is read, so that all are reported at once.
#[derive(Debug)]
pub(super) struct Problems {
    sources: Vec<Source>,
    found: Vec<(Location, String, String)>,
}

impl Problems {
    pub(super) fn new(file: Source) -> Self {
        Self { sources: vec![file], found: Vec::new() }
    }

    /// Adds another text; returns its number.
    pub(super) fn add_source(&mut self, source: Source) -> usize {
        self.sources.push(source);
        self.sources.len() - 1
    }

    pub(super) fn text(&self, source: usize) -> &str {
        self.sources.get(source).map_or("", |s| s.text.as_str())
    }

    pub(super) fn add(&mut self, location: &Location, message: impl Into<String>, cure: impl Into<String>) {
        self.found.push((location.clone(), message.into(), cure.into()));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    pub(super) fn len(&self) -> usize {
        self.found.len()
    }

    /// The text at a location, as typed.
    pub(super) fn typed(&self, location: &Location) -> &str {
        self.text(location.source).get(location.span.clone()).unwrap_or_default()
    }

    /// The error with all problems, in the order of the text.
    pub(super) fn into_error(mut self) -> CaseError {
        self.found.sort_by_key(|(location, ..)| (location.source, location.span.start));
        self.found.dedup();
        let unseen = self.found.len().saturating_sub(MAX_REPORTED);
        self.found.truncate(MAX_REPORTED);
        let sources: Vec<_> =
            self.sources.iter().map(|s| Arc::new(NamedSource::new(&s.name, s.text.clone()))).collect();
        let name = self.sources.first().map_or(String::new(), |s| s.name.clone());
        let mut problems = Vec::new();
        for (location, message, cure) in self.found {
            let (Some(source), Some(text)) =
                (sources.get(location.source), self.sources.get(location.source))
            else {
                continue;
            };
            let span = within(&text.text, location.span);
            let (line, column) = line_and_column(&text.text, span.start);
            problems.push(Problem { message, cure, line, column, span, source: source.clone() });
        }
        CaseError { name, problems, unseen }
    }
}

/// The span, moved inside the text and onto character boundaries.
fn within(text: &str, span: Range<usize>) -> Range<usize> {
    let floor = |mut n: usize| {
        n = n.min(text.len());
        while !text.is_char_boundary(n) {
            n -= 1;
        }
        n
    };
    let start = floor(span.start);
    if start == text.len() {
        // There is nothing to point at beyond the end: point at the last character.
        return floor(start.saturating_sub(1))..start;
    }
    start..floor(span.end).max(start)
}

fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = &text[..offset];
    let line_start = before.rfind('\n').map_or(0, |n| n + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}
