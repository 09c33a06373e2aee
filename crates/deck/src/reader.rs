//! From blocks to the model: each block goes to the one reader of its keyword.

use crate::block::Block;
use crate::ledger::{Ledger, Outcome};
use crate::model::{Deck, Region};
use crate::scan::Scanned;
use crate::state::{Read, State, Verdict};
use crate::{generate, materials, mesh, sets, steps, structure, surfaces};

/// The model of a deck.
pub(super) fn deck(scanned: Scanned) -> Deck {
    let mut state = State::default();
    state.deck.regions.push(Region::default());
    let mut ledger = Ledger::new(scanned.blocks.len());
    for (number, wrong) in scanned.wrong {
        ledger.refuse(number, wrong);
    }
    for (number, block) in scanned.blocks.iter().enumerate() {
        if ledger.has(number) {
            continue;
        }
        match read(&mut state, number, block) {
            Ok(Verdict::Settled(what)) => ledger.enter(number, Outcome::Understood(what.to_owned())),
            Ok(Verdict::Pending) => {}
            Ok(Verdict::Unknown) => state.deck.others.push(number),
            Err(wrong) => ledger.refuse(number, wrong),
        }
    }
    let is_open = state.part.is_some() || state.instance.is_some() || state.is_in_step;
    if let (true, Some(last)) = (is_open, scanned.blocks.len().checked_sub(1)) {
        ledger.refuse(last, "a part, an instance or a step is still open at the end of the deck".into());
    }
    Deck { sources: scanned.sources, blocks: scanned.blocks, ledger, ..state.deck }
}

fn read(state: &mut State, number: usize, block: &Block) -> Read {
    match block.keyword.as_str() {
        "HEADING" | "INCLUDE" | "PART" | "END PART" | "ASSEMBLY" | "END ASSEMBLY" | "INSTANCE"
        | "END INSTANCE" | "SYSTEM" => structure::read(state, number, block),
        "NODE" | "ELEMENT" => mesh::read(state, number, block),
        "NGEN" | "NFILL" | "ELGEN" => generate::read(state, number, block),
        "NSET" | "ELSET" => sets::read(state, number, block),
        "SURFACE" | "RIGID BODY" | "ORIENTATION" => surfaces::read(state, number, block),
        "EULERIAN SECTION" | "SOLID SECTION" | "SHELL SECTION" | "MASS" | "ROTARY INERTIA"
        | "CONNECTOR SECTION" | "SPRING" => surfaces::section(state, number, block),
        "MATERIAL"
        | "DENSITY"
        | "ELASTIC"
        | "PLASTIC"
        | "MOHR COULOMB"
        | "MOHR COULOMB HARDENING"
        | "TENSION CUTOFF"
        | "DRUCKER PRAGER"
        | "DRUCKER PRAGER HARDENING" => materials::read(state, number, block),
        "AMPLITUDE"
        | "SURFACE INTERACTION"
        | "FRICTION"
        | "CONTACT PAIR"
        | "CONTACT PROPERTY ASSIGNMENT"
        | "INITIAL CONDITIONS" => materials::tables(state, number, block),
        "STEP" | "END STEP" | "DYNAMIC" | "BOUNDARY" | "CLOAD" | "DLOAD" | "CONNECTOR MOTION"
        | "CONNECTOR LOAD" => steps::read(state, number, block),
        connector if connector.starts_with("CONNECTOR ") => materials::connectors(state, number, block),
        _ => Ok(Verdict::Unknown),
    }
}
