//! What moves each body in each step, along and about the axes of the deck.

use crate::bodies::Body;
use crate::eulerian::Eulerian;
use crate::notes::Notes;
use crate::walls::{Held, HeldNodes};
use deck::Deck;
use deck::block::{Row, Wrong, label};
use deck::model::{Action, Id, Step};

/// One of six motions in a step.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Dof {
    /// The forces decide.
    Free,
    /// No motion.
    Held,
    /// This velocity, times an amplitude.
    Velocity(f64, Option<String>),
    /// This displacement, times an amplitude.
    Displacement(f64, Option<String>),
}

/// A motion with the load on it, and the blocks that say so.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Move {
    /// The motion.
    pub(super) dof: Dof,
    /// Block that prescribes it.
    pub(super) block: Option<usize>,
    /// Load and amplitude.
    pub(super) load: Option<(f64, Option<String>)>,
    /// Block of the load.
    pub(super) load_block: Option<usize>,
}

impl Move {
    /// Ends it.
    pub(super) fn hold(&mut self) {
        self.dof = Dof::Held;
    }

    /// Takes a load or a prescribed value.
    pub(super) fn take(
        &mut self,
        action: &Action,
        row: &Row,
        value: f64,
        is_load: bool,
    ) -> Result<(), Wrong> {
        if !is_load {
            (self.dof, self.block) = (prescribed(action, row, value)?, Some(action.block));
        } else if self.load.is_some() && self.load_block != Some(action.block) {
            return Err(Wrong::at(row.place, "a second load on the same motion; one was expected"));
        } else {
            (self.load, self.load_block) = (Some((value, action.amplitude.clone())), Some(action.block));
        }
        Ok(())
    }
}

const FREE: Move = Move { dof: Dof::Free, block: None, load: None, load_block: None };

/// The motions of all bodies in a step: three along, three about the axes.
pub(super) type StepMoves = Vec<[Move; 6]>;

/// The motions in all steps, and the faces of the mesh that are held.
pub(super) fn moves(notes: &mut Notes, bodies: &[Body], mesh: &Eulerian) -> (Vec<StepMoves>, Held) {
    let deck = notes.deck;
    let mut held = HeldNodes::new(mesh);
    let (mut boundaries, mut loads): (Vec<&Action>, Vec<&Action>) =
        (deck.always.iter().collect(), Vec::new());
    let mut all = Vec::new();
    for step in &deck.steps {
        for action in step.actions.iter().filter(|action| action.rows.is_empty() && action.replaces) {
            if deck.blocks[action.block].keyword != "DLOAD" {
                notes.understood(action.block, "what acted before ends");
            }
        }
        for (keyword, active) in [("BOUNDARY", &mut boundaries), ("CLOAD", &mut loads)] {
            update(deck, step, keyword, active);
        }
        let mut moves = vec![[FREE; 6]; bodies.len()];
        for action in boundaries.iter().chain(&loads) {
            for row in &action.rows {
                if let Err(wrong) = act(notes, action, row, bodies, &mut moves, &mut held) {
                    notes.refused(action.block, wrong);
                }
            }
        }
        all.push(moves);
    }
    (all, held.faces(notes))
}

/// The actions of a keyword that act in a step, from those of the step before.
pub(super) fn update<'a>(deck: &Deck, step: &'a Step, keyword: &str, active: &mut Vec<&'a Action>) {
    let of = |action: &&Action| deck.blocks[action.block].keyword == keyword;
    if step.actions.iter().filter(of).any(|action| action.replaces) {
        active.clear();
    }
    active.extend(step.actions.iter().filter(of));
}

fn act(
    notes: &mut Notes,
    action: &Action,
    row: &Row,
    bodies: &[Body],
    moves: &mut StepMoves,
    held: &mut HeldNodes,
) -> Result<(), Wrong> {
    let missing = || Wrong::at(row.place, format!("there is no node set or node {:?}", row.field(0)));
    let ids = notes.deck.nodes(0, row.field(0)).ok_or_else(missing)?;
    let is_load = notes.deck.blocks[action.block].keyword == "CLOAD";
    let (dofs, value) = if is_load { load(row)? } else { freedom(row)? };
    let mut is_used = ids.is_empty();
    for (number, body) in bodies.iter().enumerate().filter(|(_, body)| ids.contains(&body.reference)) {
        is_used = true;
        for dof in &dofs {
            moves[number][*dof].take(action, row, value, is_load)?;
        }
        let words = if is_load { "load on" } else { "motion of" };
        notes.understood(action.block, format!("{words} {}", body.name));
    }
    let own: Vec<Id> = ids.iter().filter(|id| held.has(**id)).copied().collect();
    if !own.is_empty() {
        is_used = true;
        let is_at_rest =
            value == 0.0 && !is_load && ["DISPLACEMENT", "VELOCITY"].contains(&action.kind.as_str());
        if !is_at_rest {
            return Err(Wrong::at(row.place, "soil that flows in or is loaded at a face is not represented"));
        }
        for dof in dofs.iter().filter(|dof| **dof < 3) {
            held.hold(notes, action.block, row, &own, *dof)?;
        }
    }
    let others = ids.len() - own.len() - bodies.iter().filter(|body| ids.contains(&body.reference)).count();
    if !is_used || others > 0 {
        let message = "nodes that are neither reference nodes of rigid bodies nor of the Eulerian mesh";
        return Err(Wrong::at(row.place, message));
    }
    Ok(())
}

fn prescribed(action: &Action, row: &Row, value: f64) -> Result<Dof, Wrong> {
    match action.kind.as_str() {
        _ if value == 0.0 => Ok(Dof::Held),
        "VELOCITY" => Ok(Dof::Velocity(value, action.amplitude.clone())),
        "DISPLACEMENT" if action.amplitude.is_none() => Err(Wrong::at(
            row.place,
            "a displacement without an amplitude is none in Abaqus/Explicit: give it an amplitude",
        )),
        "DISPLACEMENT" => Ok(Dof::Displacement(value, action.amplitude.clone())),
        kind => Err(Wrong::at(row.place, format!("of prescribed motions {kind} is not represented"))),
    }
}

/// A degree of freedom, counted from 0.
pub(super) fn number(row: &Row, field: usize) -> Result<usize, Wrong> {
    let found = label(row.field(field)).filter(|dof| (1..=6).contains(dof));
    found
        .map(|dof| dof as usize - 1)
        .ok_or_else(|| Wrong::at(row.place, "a degree of freedom from 1 to 6 was expected"))
}

fn load(row: &Row) -> Result<(Vec<usize>, f64), Wrong> {
    Ok((vec![number(row, 1)?], row.number(2)?.unwrap_or(0.0)))
}

/// The degrees of freedom of a boundary condition, and its value.
fn freedom(row: &Row) -> Result<(Vec<usize>, f64), Wrong> {
    let word = row.field(1).to_uppercase();
    let dofs = match word.as_str() {
        "ENCASTRE" => vec![0, 1, 2, 3, 4, 5],
        "PINNED" => vec![0, 1, 2],
        "XSYMM" => vec![0, 4, 5],
        "YSYMM" => vec![1, 3, 5],
        "ZSYMM" => vec![2, 3, 4],
        _ => {
            let first = number(row, 1)?;
            let last = if row.field(2).is_empty() { first } else { number(row, 2)? };
            return Ok(((first..=last).collect(), row.number(3)?.unwrap_or(0.0)));
        }
    };
    Ok((dofs, 0.0))
}
