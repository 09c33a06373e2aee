//! The ledger: every block of a deck ends as understood, approximated, ignored or refused.
//!
//! A block in which nobody entered anything is refused when the ledger is [closed](Ledger::close), and so is
//! one with a parameter that nobody asked for. Forgetting a keyword therefore cannot lose it.

use crate::block::{Block, Place, Wrong};

/// What became of a block.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// It means this.
    Understood(String),
    /// It was left out, which may change this.
    Ignored(String),
    /// It is represented by something else: by what, and how that differs.
    Approximated(String),
    /// It cannot be represented: why.
    Refused(String),
}

impl Outcome {
    /// What it says.
    pub fn text(&self) -> &str {
        match self {
            Self::Understood(text) | Self::Ignored(text) | Self::Approximated(text) | Self::Refused(text) => {
                text
            }
        }
    }

    /// How grave it is, from 0 for understood to 3 for refused.
    pub fn rank(&self) -> u8 {
        match self {
            Self::Understood(_) => 0,
            Self::Ignored(_) => 1,
            Self::Approximated(_) => 2,
            Self::Refused(_) => 3,
        }
    }

    /// One outcome of two: the graver one, with what both say.
    fn and(self, other: Self) -> Self {
        let same_text = self.text() == other.text() || other.text().is_empty();
        let graver = if other.rank() > self.rank() { &other } else { &self };
        let lesser = if other.rank() > self.rank() { &self } else { &other };
        // What is refused needs no account of what else it meant.
        let alone = same_text || lesser.text().is_empty() || graver.rank() == 3 && lesser.rank() < 3;
        let text =
            if alone { graver.text().to_owned() } else { format!("{}; {}", self.text(), other.text()) };
        match graver {
            Self::Understood(_) => Self::Understood(text),
            Self::Ignored(_) => Self::Ignored(text),
            Self::Approximated(_) => Self::Approximated(text),
            Self::Refused(_) => Self::Refused(text),
        }
    }
}

/// A block with its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Keyword of the block.
    pub keyword: String,
    /// Where the keyword stands, or, of what is refused, the line of data that is meant.
    pub place: Place,
    /// What became of it.
    pub outcome: Outcome,
}

/// What became of the blocks of a deck, by their numbers.
#[derive(Clone, Debug, Default)]
pub struct Ledger {
    outcomes: Vec<Option<(Outcome, Option<Place>)>>,
}

impl Ledger {
    /// One for so many blocks.
    pub(super) fn new(blocks: usize) -> Self {
        Self { outcomes: vec![None; blocks] }
    }

    /// Enters an outcome of a block; several become one, the gravest.
    pub fn enter(&mut self, block: usize, outcome: Outcome) {
        self.enter_at(block, outcome, None);
    }

    /// Refuses a block for what is wrong with it.
    pub fn refuse(&mut self, block: usize, wrong: Wrong) {
        self.enter_at(block, Outcome::Refused(wrong.message), wrong.place);
    }

    fn enter_at(&mut self, block: usize, outcome: Outcome, place: Option<Place>) {
        let Some(slot) = self.outcomes.get_mut(block) else { return };
        *slot = Some(match slot.take() {
            None => (outcome, place),
            Some((before, at)) => (before.and(outcome), at.or(place)),
        });
    }

    /// Whether something was entered for a block.
    pub fn has(&self, block: usize) -> bool {
        self.outcomes.get(block).is_some_and(Option::is_some)
    }

    /// The account of all blocks, in their order: one entry for each.
    pub fn close(&self, blocks: &[Block]) -> Vec<Entry> {
        let of = |number: usize| self.outcomes.get(number).cloned().flatten();
        blocks.iter().enumerate().map(|(number, block)| entry(block, of(number))).collect()
    }
}

fn entry(block: &Block, found: Option<(Outcome, Option<Place>)>) -> Entry {
    let nothing = || (Outcome::Refused("nothing is known of this keyword here".to_owned()), None);
    let is_known = found.is_some();
    let (mut outcome, place) = found.unwrap_or_else(nothing);
    let unseen: Vec<&str> = block.unseen().map(|parameter| parameter.name.as_str()).collect();
    if is_known && !unseen.is_empty() && matches!(outcome, Outcome::Understood(_) | Outcome::Approximated(_))
    {
        let message = format!("nothing is known of its parameter {}", unseen.join(", "));
        outcome = outcome.and(Outcome::Refused(message));
    }
    Entry { keyword: block.keyword.clone(), place: place.unwrap_or(block.place), outcome }
}
