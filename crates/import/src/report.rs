//! What an import hands over, and the report of it.

use deck::block::Source;
use deck::{Deck, Entry, Outcome};
use std::fmt::Write;

/// A case made of a deck.
#[derive(Clone, Debug)]
pub struct Imported {
    /// Text of the case.
    pub case: String,
    /// Names and bytes of the files that the case names.
    pub files: Vec<(String, Vec<u8>)>,
    /// What became of every block of the deck.
    pub entries: Vec<Entry>,
    /// Cells of the deck along the axes of the case.
    pub cells: [usize; 3],
    /// The report, in Markdown.
    pub report: String,
}

/// A deck that cannot be imported.
#[derive(Clone, Debug)]
pub struct Refused {
    /// What became of every block of the deck; some are refused, unless `missing` says what is.
    pub entries: Vec<Entry>,
    /// What is wrong with the deck as a whole.
    pub missing: Vec<String>,
    /// The files of the deck.
    pub sources: Vec<Source>,
}

/// The report: counts, remarks, and the blocks by what became of them.
pub(super) fn text(deck: &Deck, title: &str, entries: &[Entry], remarks: &[String]) -> String {
    let mut text = format!("# Import of {title}\n\n");
    for remark in remarks {
        let _ = writeln!(text, "* {remark}");
    }
    let sections = [
        ("Approximated", "represented by something else"),
        ("Ignored", "left out, with what that may change"),
        ("Understood", "represented as it is"),
    ];
    for (name, meaning) in sections {
        let own: Vec<&Entry> = entries.iter().filter(|entry| word(&entry.outcome) == name).collect();
        let _ = writeln!(text, "\n## {name}: {}\n\n{meaning}\n", own.len());
        if own.is_empty() {
            continue;
        }
        text.push_str("| line | keyword | what |\n|---|---|---|\n");
        for entry in own {
            let what = entry.outcome.text().replace('|', "\\|");
            let _ = writeln!(
                text,
                "| {} | `*{}` | {what} |",
                deck.place(entry.place),
                entry.keyword.to_lowercase()
            );
        }
    }
    text
}

fn word(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Understood(_) => "Understood",
        Outcome::Approximated(_) => "Approximated",
        Outcome::Ignored(_) => "Ignored",
        Outcome::Refused(_) => "Refused",
    }
}
