//! Input decks of Abaqus: lines, keyword blocks, a model, and a ledger in which every block is accounted for.
//!
//! [`read`] opens a deck and what it includes, [`read_with`] takes the files from elsewhere. Neither fails:
//! what cannot be read is [refused](ledger::Outcome::Refused) in the [`Ledger`], with file and line. A deck
//! has no units; whoever uses the model must know them.
//!
//! ```
//! let deck = deck::read_with("*Heading\nA pipe\n*Node\n1, 0., 0., 0.5\n", "pipe.inp", |_|
//! Err("none".into()));
//! assert_eq!(deck.title, "A pipe");
//! assert_eq!(deck.regions[0].nodes[&1], [0.0, 0.0, 0.5]);
//! ```

pub mod block;
pub mod ledger;
pub mod model;

mod folder;
mod generate;
mod materials;
mod mesh;
mod placement;
mod reader;
mod scan;
mod sets;
mod state;
mod steps;
mod structure;
mod surfaces;

pub use block::{Block, Place};
pub use ledger::{Entry, Ledger, Outcome};
pub use model::Deck;

use std::path::Path;

/// Reads a deck and the files below its folder that it includes; links out of the folder are refused.
///
/// # Errors
/// The deck itself cannot be opened: why.
pub fn read(path: &Path) -> Result<Deck, String> {
    let (text, files) = folder::open(path)?;
    Ok(read_with(&text, &path.display().to_string(), |name| files.read(name)))
}

/// Reads the text of a deck; `include` gives the text of a file that it names, or says why not.
pub fn read_with(text: &str, name: &str, include: impl Fn(&str) -> Result<String, String>) -> Deck {
    reader::deck(scan::scan(text, name, &include))
}
