//! Gravity: which way is up, and whom it pulls.

use crate::notes::Notes;
use deck::block::{Row, Wrong};
use deck::model::Id;
use std::collections::HashSet;

/// Gravity of a deck.
pub(super) struct Gravity {
    /// Acceleration, in units of the deck; 0 without gravity.
    pub(super) size: f64,
    /// The axis that points up: 0, 1, 2, and whether it does so in its own sense.
    pub(super) up: (usize, bool),
    /// Block that says so.
    pub(super) block: Option<usize>,
    /// Elements that it pulls; `None`: all.
    pub(super) pulled: Option<HashSet<Id>>,
}

/// Gravity from the loads of all steps.
pub(super) fn gravity(notes: &mut Notes) -> Gravity {
    let mut found = Gravity { size: 0.0, up: (2, true), block: None, pulled: Some(HashSet::new()) };
    let deck = notes.deck;
    let loads = deck.steps.iter().flat_map(|step| &step.actions);
    for action in loads.filter(|action| deck.blocks[action.block].keyword == "DLOAD") {
        let mut entered = false;
        for row in &action.rows {
            match one(notes, row, &mut found) {
                Ok(()) => entered = true,
                Err(wrong) => notes.refused(action.block, wrong),
            }
        }
        let Some(first) = entered.then_some(action.block) else { continue };
        found.block.get_or_insert(first);
        let text = "gravity; the ground begins at rest under it, so that it acts from the start in full";
        match &action.amplitude {
            Some(_) => notes.approximated(first, text),
            None => notes.understood(first, text),
        }
    }
    if found.block.is_none() {
        notes.remark("No gravity in the deck: z is taken to point up, and soil and bodies have no weight.");
    }
    found
}

/// Takes a row: set, `GRAV`, size, direction.
fn one(notes: &Notes, row: &Row, found: &mut Gravity) -> Result<(), Wrong> {
    if !row.field(1).eq_ignore_ascii_case("GRAV") {
        let message = format!("of distributed loads only GRAV is represented, not {:?}", row.field(1));
        return Err(Wrong::at(row.place, message));
    }
    let mut size = row.number(2)?.unwrap_or(0.0);
    let mut direction = [0.0; 3];
    for (axis, value) in direction.iter_mut().enumerate() {
        *value = row.number(axis + 3)?.unwrap_or(0.0);
    }
    if size < 0.0 {
        (size, direction) = (-size, direction.map(|x: f64| -x));
    }
    let axis = (0..3).find(|axis| direction[*axis] != 0.0);
    let only = axis.filter(|axis| (0..3).all(|other| other == *axis || direction[other] == 0.0));
    let Some(axis) = only else {
        let cure = "turn the model, or use ground.slope in the case";
        return Err(Wrong::at(row.place, format!("gravity along one axis was expected; {cure}")));
    };
    let up = (axis, direction[axis] < 0.0);
    if found.size > 0.0 && (found.up != up || (found.size / size - 1.0).abs() > 1e-9) {
        return Err(Wrong::at(row.place, "gravity differs from that of an earlier line"));
    }
    (found.size, found.up) = (size, up);
    match row.field(0) {
        "" => found.pulled = None,
        name => {
            let missing = || Wrong::at(row.place, format!("there is no element set {name}"));
            let ids = notes.deck.elements(0, name).ok_or_else(missing)?;
            if let Some(pulled) = &mut found.pulled {
                pulled.extend(ids);
            }
        }
    }
    Ok(())
}
