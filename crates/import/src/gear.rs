//! Which body carries which, which are welded into one, and what drives their joints.

use crate::bodies::{self, Body};
use crate::connectors::{Joint, Kind};
use crate::masses::Inertia;
use crate::moves::{self, Dof, Move, StepMoves, update};
use crate::notes::Notes;
use deck::block::{Row, Wrong};
use deck::model::Action;

/// The joints, the first body of each the one that carries; and the welds.
pub(super) struct Gear {
    pub(super) joints: Vec<Joint>,
    /// For each body the one that moves for it: itself, or that to which it is welded.
    pub(super) whole: Vec<usize>,
    /// For each body whether it is a point of another, without mass.
    pub(super) is_mark: Vec<bool>,
}

/// Whether a body never moves so, in no step.
fn is_held(moves: &[StepMoves], body: Option<usize>, number: usize) -> bool {
    body.is_none_or(|body| moves.iter().all(|step| step[body][number].dof == Dof::Held))
}

/// Motions and loads of connectors become those of the body that moves.
fn drive(notes: &mut Notes, joints: &mut [Joint], moves: &mut [StepMoves]) {
    let deck = notes.deck;
    let (mut motions, mut loads): (Vec<&Action>, Vec<&Action>) = (Vec::new(), Vec::new());
    for (number, step) in deck.steps.iter().enumerate() {
        update(deck, step, "CONNECTOR MOTION", &mut motions);
        update(deck, step, "CONNECTOR LOAD", &mut loads);
        for action in motions.iter().chain(&loads) {
            for row in &action.rows {
                match one(notes, action, row, joints, number, moves) {
                    Ok(()) => {
                        notes.understood(action.block, "drive of a joint, as that of the body that it moves")
                    }
                    Err(wrong) => notes.refused(action.block, wrong),
                }
            }
        }
    }
}

fn one(
    notes: &Notes,
    action: &Action,
    row: &Row,
    joints: &mut [Joint],
    step: usize,
    moves: &mut [StepMoves],
) -> Result<(), Wrong> {
    let deck = notes.deck;
    let missing = || Wrong::at(row.place, format!("there is no connector {:?}", row.field(0)));
    let ids = deck.elements(0, row.field(0)).filter(|ids| !ids.is_empty()).ok_or_else(missing)?;
    let (component, value) = (moves::number(row, 1)?, row.number(2)?.unwrap_or(0.0));
    let is_load = deck.blocks[action.block].keyword == "CONNECTOR LOAD";
    for id in ids {
        let joint = joints.iter_mut().find(|joint| joint.element == id).ok_or_else(missing)?;
        let driven = match driven(joint, component, moves) {
            Err(_) if is_load && component == 3 && matches!(joint.kind, Kind::Hinge(_)) => {
                torque(joint, action, value, step).map(|()| None)
            }
            driven => driven.map(Some),
        };
        let driven = driven.map_err(|message| Wrong::at(row.place, message))?;
        let Some((body, number, sense)) = driven else { continue };
        let slot = &mut moves[step][body][number];
        if !is_load && slot.dof != Dof::Free && slot.block != Some(action.block) {
            return Err(Wrong::at(row.place, "the body that it moves is held or moved there already"));
        }
        slot.take(action, row, sense * value, is_load)?;
    }
    Ok(())
}

/// A torque between two bodies that both turn: the same in all steps.
fn torque(joint: &mut Joint, action: &Action, value: f64, step: usize) -> Result<(), String> {
    let value = if joint.is_reversed { -value } else { value };
    let (before, steps) = joint.torque.unwrap_or((value, 0));
    if action.amplitude.is_some() || before != value || steps != step {
        let message =
            "a torque between two bodies that both turn acts from the start to the end, without an amplitude";
        return Err(message.to_owned());
    }
    joint.torque = Some((value, step + 1));
    Ok(())
}

/// The body that a drive moves, its motion, and in which sense.
fn driven(joint: &Joint, component: usize, moves: &[StepMoves]) -> Result<(usize, usize, f64), String> {
    let (first, axis) = match joint.kind {
        Kind::Hinge(axis) if component == 3 => (3, axis),
        Kind::Slider(axis) if component == 0 => (0, axis),
        _ => {
            return Err(
                "of connectors hinges (component 4) and translators (component 1) can be driven".to_owned()
            );
        }
    };
    let along = (0..3)
        .find(|n| axis[*n].abs() > 1.0 - 1e-9)
        .ok_or("its axis is none of the deck: one of them was expected")?;
    let number = first + along;
    let is_still = |end: Option<usize>| (3..6).chain([number]).all(|number| is_held(moves, end, number));
    let sense = if joint.is_reversed { -axis[along] } else { axis[along] };
    match joint.ends {
        [first, Some(second)] if is_still(first) => Ok((second, number, sense)),
        [Some(first), second] if is_still(second) => Ok((first, number, -sense)),
        _ => {
            Err("a drive between two bodies that both move so is not represented: hold one of them"
                .to_owned())
        }
    }
}

/// Orders the bodies of each joint, and makes one of those that are welded.
pub(super) fn gear(
    notes: &mut Notes,
    mut joints: Vec<Joint>,
    bodies: &[Body],
    inertias: &[Inertia],
    moves: &mut [StepMoves],
) -> Gear {
    let far = distances(&joints, bodies.len(), moves);
    let at = |end: Option<usize>| end.map_or(0, |body| far[body]);
    let is_point = |end: Option<usize>| end.is_some_and(|body| is_point(notes, &bodies[body]));
    for joint in &mut joints {
        let [a, b] = joint.ends;
        if at(b) < at(a) || at(b) == at(a) && is_point(a) && !is_point(b) {
            joint.ends.reverse();
            joint.at.reverse();
            joint.is_reversed = true;
        }
    }
    let (welds, mut joints): (Vec<Joint>, Vec<Joint>) =
        joints.into_iter().partition(|joint| joint.kind == Kind::Weld);
    let mut gear =
        Gear { joints: Vec::new(), whole: (0..bodies.len()).collect(), is_mark: vec![false; bodies.len()] };
    for weld in welds {
        match welded(notes, &weld, bodies, inertias, moves, &mut gear) {
            Ok(()) => notes.understood(weld.block, format!("joint {}: bodies that move as one", weld.name)),
            Err(message) => notes.refused(weld.block, message),
        }
    }
    for joint in &mut joints {
        joint.ends = joint.ends.map(|end| end.map(|body| gear.whole[body]));
        if joint.ends[0] == joint.ends[1] {
            notes.refused(joint.block, "its ends are welded into one body");
        }
    }
    drive(notes, &mut joints, moves);
    hold_points(notes, &joints, bodies, inertias, moves);
    for step in moves.iter_mut() {
        for body in 0..bodies.len() {
            step[body] = step[gear.whole[body]].clone();
        }
    }
    gear.joints = joints;
    gear
}

/// Whether a body is a node alone.
fn is_point(notes: &Notes, body: &Body) -> bool {
    bodies::is_connector(notes.deck, body.block)
}

/// How far each body is from what is held or moved: by its own free translations, or by joints.
fn distances(joints: &[Joint], bodies: usize, moves: &[StepMoves]) -> Vec<usize> {
    let free = |body: usize| {
        let of = |step: &StepMoves| step[body][..3].iter().filter(|own| own.dof == Dof::Free).count();
        moves.iter().map(of).min().unwrap_or(3)
    };
    let mut far: Vec<usize> =
        (0..bodies).map(|body| if free(body) < 3 { free(body) + 1 } else { bodies + 5 }).collect();
    let carrying: Vec<&Joint> =
        joints.iter().filter(|joint| !matches!(joint.kind, Kind::Spring(_))).collect();
    for _ in 0..bodies {
        let before = far.clone();
        for joint in &carrying {
            for [from, to] in [[joint.ends[0], joint.ends[1]], [joint.ends[1], joint.ends[0]]] {
                let next = from.map_or(0, |body| far[body]) + 1;
                if let Some(to) = to {
                    far[to] = far[to].min(next);
                }
            }
        }
        if far == before {
            break;
        }
    }
    far
}

/// Welds the second body of a joint to the first.
fn welded(
    notes: &Notes,
    weld: &Joint,
    bodies: &[Body],
    inertias: &[Inertia],
    moves: &mut [StepMoves],
    gear: &mut Gear,
) -> Result<(), String> {
    let [Some(mut whole), Some(mut part)] = weld.ends else {
        return Err("a body that is welded to the ground: hold it with *Boundary, encastre".to_owned());
    };
    let is_massless = |body: usize| is_point(notes, &bodies[body]) && inertias[body].mass.is_none();
    let is_free = |moves: &[StepMoves], body: usize| {
        moves.iter().all(|step| step[body].iter().all(|own| own.dof == Dof::Free && own.load.is_none()))
    };
    whole = gear.whole[whole];
    let never_turns = moves.iter().all(|step| step[whole][3..].iter().all(|own| own.dof == Dof::Held));
    if is_massless(whole) && never_turns && is_free(moves, part) {
        // What does not turn moves alike everywhere.
        moves.iter_mut().for_each(|step| step.swap(whole, part));
        std::mem::swap(&mut whole, &mut part);
    } else if !is_free(moves, part) {
        return Err(format!(
            "both {} and {} are held, moved or loaded: one of them was expected",
            bodies[whole].name, bodies[part].name
        ));
    }
    if gear.whole[part] != part || whole == part {
        return Err(format!("{} is welded to two bodies: weld these to one another", bodies[part].name));
    }
    if inertias[part].mass.is_none() && !is_massless(part) {
        return Err(format!(
            "{} moves as one with {}, and its mass is not given: give its reference node *Mass",
            bodies[part].name, bodies[whole].name
        ));
    }
    gear.is_mark[part] = is_massless(part);
    gear.whole.iter_mut().filter(|other| **other == part).for_each(|other| *other = whole);
    Ok(())
}

/// A node alone that nothing could turn does not: only springs and balls are at it.
fn hold_points(
    notes: &Notes,
    joints: &[Joint],
    bodies: &[Body],
    inertias: &[Inertia],
    moves: &mut [StepMoves],
) {
    for (number, body) in bodies.iter().enumerate() {
        let mut at = joints.iter().filter(|joint| joint.ends.contains(&Some(number)));
        let is_turned = at.any(|joint| matches!(joint.kind, Kind::Hinge(_) | Kind::Slider(_)));
        if is_point(notes, body) && inertias[number].moments.is_none() && !is_turned {
            let turns = moves.iter_mut().flat_map(|step| &mut step[number][3..]);
            turns.filter(|own| own.dof == Dof::Free && own.load.is_none()).for_each(Move::hold);
        }
    }
}
