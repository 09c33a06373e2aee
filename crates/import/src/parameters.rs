//! Parameters of keywords that change nothing in a case, or something that is said.

use crate::notes::Notes;
use deck::Outcome;

/// Keyword, parameter, and what leaving it out may change; empty: nothing.
const KNOWN: [(&str, &str, &str); 25] = [
    ("PART", "INTERNAL", ""),
    ("STEP", "NLGEOM", ""),
    ("STEP", "INC", ""),
    ("STEP", "UNSYMM", ""),
    ("DYNAMIC", "SCALE FACTOR", "the time step has numerics.courant"),
    ("DYNAMIC", "DIRECT USER CONTROL", "the time step follows from cells and wave speed"),
    ("DYNAMIC", "FIXED TIME INCREMENTATION", "the time step follows from cells and wave speed"),
    ("DYNAMIC", "ELEMENT BY ELEMENT", "the time step follows from cells and wave speed"),
    ("DYNAMIC", "IMPROVED DT METHOD", "the time step follows from cells and wave speed"),
    ("DYNAMIC", "ADIABATIC", "there are no temperatures"),
    ("EULERIAN SECTION", "CONTROLS", "hourglass control is that of the case"),
    ("EULERIAN SECTION", "ADVECTION", "advection is that of the case, of second order"),
    ("SOLID SECTION", "CONTROLS", ""),
    ("SOLID SECTION", "ORIENTATION", ""),
    ("SHELL SECTION", "CONTROLS", ""),
    ("CONNECTOR SECTION", "CONTROLS", ""),
    ("SURFACE", "COMBINE", ""),
    ("RIGID BODY", "POSITION", "the reference node stays where the deck puts it"),
    ("SURFACE", "FILLET RADIUS", "edges of the profile stay sharp"),
    ("BOUNDARY", "REGION TYPE", ""),
    ("CONTACT PAIR", "TYPE", ""),
    ("CONTACT PAIR", "MECHANICAL CONSTRAINT", "contact by impulses instead"),
    ("CONTACT PAIR", "CPSET", ""),
    ("FRICTION", "SLIP TOLERANCE", ""),
    ("MATERIAL", "RTOL", ""),
];

/// Sees the parameters that are known, and enters what leaving them out may change.
pub(super) fn parameters(notes: &mut Notes) {
    let deck = notes.deck;
    for (number, block) in deck.blocks.iter().enumerate() {
        for (keyword, name, effect) in KNOWN {
            if block.keyword == keyword && block.has(name) && !effect.is_empty() {
                notes.ledger.enter(number, Outcome::Ignored(format!("{name}: {effect}")));
            }
        }
    }
}
