//! Where the keys of a case stand in the texts that were typed: from the path of a problem to a line.

use super::error::{CaseError, LocatedProblem, source};
use super::problem::{Aim, Problem};
use miette::NamedSource;
use std::collections::BTreeMap;
use std::{ops::Range, sync::Arc};

/// A range of a text that was typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextSpan {
    /// Number of the text; 0 is the case file, the others are one `--set` each.
    pub source: usize,
    /// Range of bytes in the text.
    pub span: Range<usize>,
}

/// Where an entry stands.
#[derive(Clone, Debug)]
struct EntryPlace {
    name: TextSpan,
    value: TextSpan,
}

/// The texts that were typed, and where every entry stands in them.
#[derive(Debug)]
pub struct Places {
    sources: Vec<Arc<NamedSource<String>>>,
    entries: BTreeMap<String, EntryPlace>,
}

impl Places {
    /// The places of a case file with this name and text, without an entry yet.
    pub(super) fn new(name: &str, text: &str) -> Self {
        Self { sources: vec![source(name, text)], entries: BTreeMap::new() }
    }

    /// Adds another text; returns its number.
    pub(super) fn add_source(&mut self, name: &str, text: &str) -> usize {
        self.sources.push(source(name, text));
        self.sources.len() - 1
    }

    /// Enters where the entry at a path stands.
    pub(super) fn insert(&mut self, path: &str, name: TextSpan, value: TextSpan) {
        self.entries.insert(path.to_owned(), EntryPlace { name, value });
    }

    /// Forgets what stands below a path: it has been replaced.
    pub(super) fn forget_below(&mut self, path: &str) {
        let is_below =
            |known: &str| known.strip_prefix(path).is_some_and(|rest| rest.starts_with(['.', '[']));
        self.entries.retain(|known, _| !is_below(known));
    }

    /// Where the entry at a path stands; of a key that is not given, its section; otherwise the start of the
    /// file.
    pub(super) fn place(&self, path: &str, aim: Aim) -> TextSpan {
        if let Some(entry) = self.entries.get(path) {
            return match aim {
                Aim::Value => entry.value.clone(),
                Aim::Name => entry.name.clone(),
            };
        }
        if let Some((list, _)) = path.rsplit_once('[') {
            return self.place(list, aim);
        }
        match path.rsplit_once('.') {
            Some((section, _)) => self.place(section, Aim::Name),
            None => TextSpan { source: 0, span: 0..0 },
        }
    }

    /// The error with all these problems, in the order of the texts.
    pub fn error(&self, problems: Vec<(Aim, Problem)>) -> CaseError {
        let placed = problems.into_iter().map(|(aim, problem)| (self.place(&problem.path, aim), problem));
        self.error_at(placed.collect())
    }

    /// The error with problems whose places are known, in the order of the texts.
    pub fn error_at(&self, mut problems: Vec<(TextSpan, Problem)>) -> CaseError {
        problems.sort_by_key(|(place, _)| (place.source, place.span.start));
        problems.dedup();
        let located = problems.into_iter().filter_map(|(place, problem)| {
            let source = self.sources.get(place.source)?;
            Some(LocatedProblem::in_text(problem, source, place.span))
        });
        let name = self.sources.first().map_or("", |file| file.name());
        CaseError::of(name, located.collect())
    }
}
