//! The error for a case that cannot be run: everything that is wrong with it, with its place in the text that
//! was typed.

use super::problem::Problem;
use crate::printed::{masked, plain};
use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};
use std::{fmt, ops::Range, sync::Arc};

/// One thing that is wrong, and where it stands in the text, if the case was read from one.
#[derive(Clone, Debug)]
pub struct LocatedProblem {
    /// Path of the key; empty where the problem concerns the whole case.
    pub path: String,
    /// What is wrong with the case.
    pub message: String,
    /// How to fix the problem.
    pub cure: String,
    /// Line, counted from 1; 0 where the problem is not in a text.
    pub line: usize,
    /// Column in characters, counted from 1; 0 where the problem is not in a text.
    pub column: usize,
    span: Range<usize>,
    source: Arc<NamedSource<String>>,
}

impl LocatedProblem {
    /// A problem at a range of bytes of a text; the range is moved inside the text and onto character
    /// boundaries.
    pub(super) fn in_text(problem: Problem, source: &Arc<NamedSource<String>>, span: Range<usize>) -> Self {
        let text = source.inner();
        let span = within(text, span);
        let (line, column) = line_and_column(text, span.start);
        Self { line, column, span, ..Self::nowhere(problem, source) }
    }

    fn nowhere(Problem { path, message, cure }: Problem, source: &Arc<NamedSource<String>>) -> Self {
        let [path, message, cure] = [path, message, cure].map(|text| plain(&text).into_owned());
        Self { path, message, cure, line: 0, column: 0, span: 0..0, source: source.clone() }
    }
}

/// A text that was typed, as it may be shown.
pub(super) fn source(name: &str, text: &str) -> Arc<NamedSource<String>> {
    Arc::new(NamedSource::new(plain(name), masked(text)))
}

impl fmt::Display for LocatedProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Where there is no line to show, the path says what is meant.
        if self.line == 0 && !self.path.is_empty() && !self.message.contains(&self.path) {
            write!(f, "{}: ", self.path)?;
        }
        f.write_str(&self.message)
    }
}

impl std::error::Error for LocatedProblem {}

impl Diagnostic for LocatedProblem {
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
    pub problems: Vec<LocatedProblem>,
    /// Number of further problems.
    pub unseen: usize,
}

/// Problems that are reported at once.
const MAX_REPORTED: usize = 20;

impl CaseError {
    /// A case that could not even be read, e.g. because the file is missing.
    #[must_use]
    pub fn unreadable(name: &str, message: String, cure: &str) -> Self {
        Self::new(name, vec![Problem::new("", message, cure)])
    }

    /// A case that was not read from a text, with these problems.
    #[must_use]
    pub fn new(name: &str, problems: Vec<Problem>) -> Self {
        let source = source(name, "");
        let located = problems.into_iter().map(|problem| LocatedProblem::nowhere(problem, &source));
        Self::of(name, located.collect())
    }

    /// A text that cannot be used, with these problems, each at a range of its bytes.
    #[must_use]
    pub fn in_text(name: &str, text: &str, problems: Vec<(Range<usize>, Problem)>) -> Self {
        let source = source(name, text);
        let located = problems.into_iter().map(|(at, problem)| LocatedProblem::in_text(problem, &source, at));
        Self::of(name, located.collect())
    }

    /// The first few of these problems.
    pub(super) fn of(name: &str, mut problems: Vec<LocatedProblem>) -> Self {
        let unseen = problems.len().saturating_sub(MAX_REPORTED);
        problems.truncate(MAX_REPORTED);
        Self { name: plain(name).into_owned(), problems, unseen }
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.problems.as_slice() {
            [one] => write!(f, "{}: {one}", self.name),
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
