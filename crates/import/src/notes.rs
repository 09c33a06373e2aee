//! What is said of the blocks while a deck is imported, and whether to go on.

use deck::block::Wrong;
use deck::{Deck, Ledger, Outcome};

/// The account so far.
pub(super) struct Notes<'a> {
    /// The deck.
    pub(super) deck: &'a Deck,
    /// What became of its blocks.
    pub(super) ledger: Ledger,
    /// What is to be said of the whole.
    pub(super) remarks: Vec<String>,
    /// What is wrong with the whole.
    pub(super) missing: Vec<String>,
}

impl<'a> Notes<'a> {
    /// For a deck that was read.
    pub(super) fn new(deck: &'a Deck) -> Self {
        Self { deck, ledger: deck.ledger.clone(), remarks: Vec::new(), missing: Vec::new() }
    }

    /// A block means this.
    pub(super) fn understood(&mut self, block: usize, what: impl Into<String>) {
        self.ledger.enter(block, Outcome::Understood(what.into()));
    }

    /// A block is represented by this, which differs so.
    pub(super) fn approximated(&mut self, block: usize, how: impl Into<String>) {
        self.ledger.enter(block, Outcome::Approximated(how.into()));
    }

    /// A block is left out, which may change this.
    pub(super) fn ignored(&mut self, block: usize, effect: impl Into<String>) {
        if let Some(block) = self.deck.blocks.get(block) {
            block.see_all();
        }
        self.ledger.enter(block, Outcome::Ignored(effect.into()));
    }

    /// A block cannot be represented.
    pub(super) fn refused(&mut self, block: usize, wrong: impl Into<Wrong>) {
        self.ledger.refuse(block, wrong.into());
    }

    /// The deck as a whole lacks something.
    pub(super) fn lacks(&mut self, what: impl Into<String>) {
        self.missing.push(what.into());
    }

    /// Something to be said of the whole.
    pub(super) fn remark(&mut self, text: impl Into<String>) {
        self.remarks.push(text.into());
    }

    /// `deck.inp:12 *KEYWORD`, where a line of the case comes from.
    pub(super) fn origin(&self, block: usize) -> String {
        let found = self.deck.blocks.get(block);
        found.map_or_else(String::new, |b| {
            format!("{} *{}", self.deck.place(b.place), b.keyword.to_lowercase())
        })
    }
}
