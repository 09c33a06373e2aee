//! What the reader knows between two blocks: which part, step or material is open.

use crate::block::Wrong;
use crate::model::{Deck, Id, Region};
use crate::placement::Moved;
use std::collections::HashMap;

/// Most nodes and elements of a deck, and entries of its sets.
pub(super) const MOST: usize = 20_000_000;

/// What becomes of a block that was read.
pub(super) enum Verdict {
    /// It gives the deck its form; nothing more is to be said of it.
    Settled(&'static str),
    /// It is in the model; whoever uses that says what became of it.
    Pending,
    /// The reader knows nothing of it.
    Unknown,
}

/// Verdict of a block, or what is wrong with it.
pub(super) type Read = Result<Verdict, Wrong>;

/// What is open.
#[derive(Default)]
pub(super) struct State {
    pub(super) deck: Deck,
    /// Parts by name, in coordinates of their own.
    pub(super) parts: HashMap<String, Region>,
    pub(super) part: Option<Region>,
    /// An instance that is open, with its place.
    pub(super) instance: Option<Region>,
    pub(super) moved: Moved,
    pub(super) is_in_assembly: bool,
    pub(super) is_in_step: bool,
    pub(super) material: Option<usize>,
    pub(super) behaviour: Option<String>,
    /// Interaction to which friction belongs.
    pub(super) interaction: Option<usize>,
    /// Coordinate system of nodes that follow.
    pub(super) system: Option<Moved>,
    /// Nodes, elements and entries of sets so far.
    pub(super) count: usize,
}

impl State {
    /// The region that is open: a part, an instance, or the assembly.
    pub(super) fn region(&mut self) -> &mut Region {
        match (&mut self.part, &mut self.instance) {
            (Some(part), _) => part,
            (_, Some(instance)) => instance,
            _ => &mut self.deck.regions[0],
        }
    }

    /// Number of the region that is open; that of a part is known only when it is instanced, and 0 until
    /// then.
    pub(super) fn number(&self) -> usize {
        if self.part.is_none() && self.instance.is_some() { self.deck.regions.len() } else { 0 }
    }

    /// Id of a node or element of the region that is open.
    pub(super) fn id(&self, label: u32) -> Id {
        Id { region: self.number(), label }
    }

    /// Counts what is added.
    pub(super) fn grow(&mut self, by: usize) -> Result<(), Wrong> {
        let count = self.count.saturating_add(by);
        if count > MOST {
            return Err(format!("more than {MOST} nodes, elements and entries of sets").into());
        }
        self.count = count;
        Ok(())
    }
}
