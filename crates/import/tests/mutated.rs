//! Decks changed at random: no panic, and an entry for every block.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod small;

use coulter_import::{Units, import};
use deck::Outcome;
use std::path::Path;

/// Numbers that follow from a seed (xorshift).
struct Dice(u64);

impl Dice {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % most.max(1) as u64).unwrap()
    }
}

const NUMBERS: [&str; 10] = ["-1", "0", "1e300", "nan", "9999999999", "1.5", "", "x", "4294967295", "1e-300"];

/// Deletes, doubles, swaps or garbles some lines.
fn mutated(text: &str, dice: &mut Dice) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..1 + dice.below(4) {
        let (a, b) = (dice.below(lines.len()), dice.below(lines.len()));
        match dice.below(6) {
            0 => drop(lines.remove(a)),
            1 => lines.insert(b, lines[a].clone()),
            2 => lines.swap(a, b),
            3 => {
                let mut fields: Vec<&str> = lines[a].split(',').collect();
                let at = dice.below(fields.len());
                fields[at] = NUMBERS[dice.below(NUMBERS.len())];
                lines[a] = fields.join(",");
            }
            4 => {
                let keywords: Vec<usize> = (0..lines.len()).filter(|n| lines[*n].starts_with('*')).collect();
                let at = keywords[dice.below(keywords.len())];
                let letter = dice.below(lines[at].len());
                lines[at].remove(letter);
            }
            _ => lines[a] = lines[a].chars().rev().collect(),
        }
    }
    lines.join("\n")
}

/// A hinge that is driven and a cable, in the assembly, the model and the step.
const CONNECTORS: [&str; 3] = [
    "*Orientation, name=O\n0., 1., 0., 0., 0., 1.\n1, 0.\n*Element, type=CONN3D2, elset=LINK\n9, A.9, B.9\n\
     *Connector Section, elset=LINK\nHinge,\nO,\n*Node\n7, 1.9, 0., 0.35\n*Element, type=CONN3D2, elset=LINE\n10, 7, B.9\n\
     *Connector Section, elset=LINE, behavior=LINE\nAxial,\n",
    "*Connector Behavior, name=LINE\n*Connector Elasticity, component=1, nonlinear\n0., -1.\n0., 0.1\n200., 0.2\n\
     *Connector Damping, component=1\n30.,\n",
    "*Boundary\nA.RP, 1, 6\n7, 1, 3\n*Connector Motion, type=velocity\nLINK, 4, 3.\n",
];

#[test]
fn changed_decks_neither_panic_nor_lose_a_keyword() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("decks");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    assert_eq!(paths.len(), 10);
    let mut dice = Dice(0x9e37_79b9_7f4a_7c15);
    let (mut imported, mut refused) = (0, 0);
    let mut texts: Vec<String> = paths.iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
    texts.push(small::deck(CONNECTORS[0], CONNECTORS[1], CONNECTORS[2]));
    for text in &texts {
        for _ in 0..20 {
            let text = mutated(text, &mut dice);
            let deck = deck::read_with(&text, "deck.inp", |_| Err("there is no such file".to_owned()));
            // What begins with one asterisk is a keyword, and has an entry.
            let is_keyword = |line: &&str| line.trim().starts_with('*') && !line.trim().starts_with("**");
            let keywords = text.lines().filter(is_keyword).count();
            let own = deck.blocks.iter().filter(|block| block.keyword != "(DATA)").count();
            assert_eq!(own, keywords, "{text}");
            let units: Units = "m-kg-s".parse().unwrap();
            let entries = match import(&deck, Some(&units), "case") {
                Ok(done) => {
                    imported += 1;
                    let is_refused = |e: &&deck::Entry| matches!(e.outcome, Outcome::Refused(_));
                    assert_eq!(done.entries.iter().filter(is_refused).count(), 0);
                    done.entries
                }
                Err(failed) => {
                    refused += 1;
                    let is_refused = |e: &deck::Entry| matches!(e.outcome, Outcome::Refused(_));
                    assert!(!failed.missing.is_empty() || failed.entries.iter().any(is_refused));
                    failed.entries
                }
            };
            assert_eq!(entries.len(), deck.blocks.len());
            assert!(entries.iter().all(|entry| !entry.outcome.text().is_empty()));
        }
    }
    // Most lines of so small a deck matter: few changed ones can still be imported.
    assert!(imported > 0 && refused > 0, "{imported} imported, {refused} refused");
}
