//! From the model of a deck to the text of a case.

use crate::bodies::{self, Body};
use crate::body_keys;
use crate::box_keys;
use crate::case_text::{CaseText, digits, quantity, quoted};
use crate::connectors;
use crate::contact;
use crate::eulerian::{self, Eulerian};
use crate::facts::Facts;
use crate::fill::{self, Box3};
use crate::gear;
use crate::gravity::{self, Gravity};
use crate::ground_keys;
use crate::joint_keys;
use crate::masses;
use crate::moves::{Dof, StepMoves, moves};
use crate::notes::Notes;
use crate::orient::{Setup, setup};
use crate::others::{self, Asked};
use crate::parameters;
use crate::report::{self, Imported, Refused};
use crate::soil;
use crate::units::Units;
use deck::{Deck, Outcome};
use std::collections::HashSet;

/// A case made of a deck, in these units or in those that gravity and density give away.
///
/// # Errors
/// What cannot be represented, or lacks.
pub fn import(deck: &Deck, units: Option<&Units>, name: &str) -> Result<Imported, Box<Refused>> {
    let mut notes = Notes::new(deck);
    parameters::parameters(&mut notes);
    let asked = others::others(&mut notes);
    let written = write(&mut notes, units, name, &asked);
    if written.is_none() {
        // Keywords that the reader knows are no mistakes of the deck.
        let unread: HashSet<usize> = deck.others.iter().copied().collect();
        for block in (0..deck.blocks.len()).filter(|block| !unread.contains(block)) {
            if !notes.ledger.has(block) {
                notes.ledger.enter(block, Outcome::Ignored("not looked at, for what is refused".to_owned()));
            }
        }
    }
    let entries = notes.ledger.close(&deck.blocks);
    let is_refused = entries.iter().any(|entry| matches!(entry.outcome, Outcome::Refused(_)));
    let (Some(written), false, true) = (written, is_refused, notes.missing.is_empty()) else {
        return Err(Box::new(Refused { entries, missing: notes.missing, sources: deck.sources.clone() }));
    };
    let title = if deck.title.is_empty() { name } else { &deck.title };
    let report = report::text(deck, title, &entries, &notes.remarks);
    Ok(Imported { case: written.text, files: written.files, entries, cells: written.cells, report })
}

struct WrittenCase {
    text: String,
    files: Vec<(String, Vec<u8>)>,
    cells: [usize; 3],
}

fn write(notes: &mut Notes, units: Option<&Units>, name: &str, asked: &Asked) -> Option<WrittenCase> {
    let deck = notes.deck;
    let gravity = gravity::gravity(notes);
    let mut bodies = bodies::bodies(notes);
    bodies::add_points(notes, &mut bodies);
    let frictions = contact::frictions(notes, &bodies);
    let inertias = masses::inertias(notes, &bodies);
    let found = eulerian::mesh(notes);
    steps(notes);
    let mesh = found?;
    let units = known_units(notes, units, &gravity, &mesh)?;
    let (mut moves, held) = moves(notes, &bodies, &mesh);
    for body in bodies.iter().filter(|body| body.is_frame() && mesh.nodes.contains(&body.reference)) {
        notes.refused(body.block, "a connector to a node of the soil: nodes of bodies were expected");
    }
    let joints = connectors::joints(notes, &bodies);
    let gear = gear::gear(notes, joints, &bodies, &inertias, &mut moves);
    let setup = setup(&mesh, &held, &bodies, &moves, gravity.up);
    let first = first_step(notes, &moves);
    let facts =
        Facts { units, gravity, mesh: &mesh, bodies: &bodies, inertias, moves, held, setup, gear, first };
    say_setup(notes, &facts);
    let at = Box3::new(&mesh, &facts.setup.frame);
    let solid = bodies.iter().filter(|body| !body.is_frame());
    let skipped: Vec<[[f64; 2]; 3]> = solid.map(|body| turned_bounds(body, &facts.setup)).collect();
    let ground = fill::ground(notes, &mesh, &at, &skipped)?;
    let mut text = CaseText::default();
    let title = if deck.title.is_empty() { name } else { &deck.title };
    text.set("", "format", "2", "");
    text.set("", "title", quoted(title), "*heading");
    let block = facts.gravity.block.map_or_else(|| "no *dload grav".to_owned(), |block| notes.origin(block));
    text.set("", "gravity", quantity(facts.gravity.size * facts.units.acceleration(), "m/s^2"), &block);
    ground_keys::soils(notes, &mut text, &facts, &at, &ground)?;
    box_keys::domain(notes, &mut text, &facts, &at);
    box_keys::grid(notes, &mut text, &facts, &at);
    // Stages follow one another as they stand in the file: before any motion of a later one.
    body_keys::durations(notes, &mut text, &facts);
    let files = body_keys::all_bodies(notes, &mut text, &facts, &frictions, &ground);
    joint_keys::joints(notes, &mut text, &facts, ground.surface * facts.units.length);
    output(notes, &mut text, &facts, asked);
    Some(WrittenCase { text: text.written(), files, cells: at.counts() })
}

/// Where a body is in axes of the case and units of the deck.
fn turned_bounds(body: &Body, setup: &Setup) -> [[f64; 2]; 3] {
    let bounds = body.hull.bounds();
    let [low, high] = [0, 1].map(|side| setup.frame.point(bounds.map(|range| range[side])));
    [0, 1, 2].map(|n| [low[n].min(high[n]), low[n].max(high[n])])
}

fn known_units(
    notes: &mut Notes,
    given: Option<&Units>,
    gravity: &Gravity,
    mesh: &Eulerian,
) -> Option<Units> {
    if let Some(units) = given {
        notes.remark(format!("Units {}, as asked for.", units.name));
        return Some(units.clone());
    }
    let material =
        mesh.materials.first().and_then(|[_, name]| notes.deck.materials.iter().find(|m| m.name == *name));
    let found = material.and_then(soil::density).and_then(|density| Units::inferred(gravity.size, density));
    match found {
        Some(units) => {
            notes.remark(format!(
                "Units {}: in these gravity is that of the Earth, and the soil weighs what soil does.",
                units.name
            ));
            Some(units)
        }
        None => {
            notes.lacks("A deck has no units, and gravity and density do not give them away: state them with --units, such as --units mm-t-s.");
            None
        }
    }
}

/// Every step has a procedure.
fn steps(notes: &mut Notes) {
    let deck = notes.deck;
    if deck.steps.is_empty() {
        notes.lacks("There is no *Step.");
    }
    for step in &deck.steps {
        match step.procedure {
            Some(procedure) => {
                notes.understood(step.block, "a step");
                notes.understood(procedure, "its duration");
            }
            None => notes.refused(step.block, "a step with *Dynamic, explicit was expected"),
        }
    }
}

/// The first step that does more than let gravity act.
fn first_step(notes: &mut Notes, moves: &[StepMoves]) -> usize {
    let is_at_rest =
        |step: &StepMoves| step.iter().flatten().all(|own| own.dof == Dof::Held && own.load.is_none());
    let first = moves.first().filter(|step| moves.len() > 1 && !step.is_empty() && is_at_rest(step));
    let Some(step) = first.and_then(|_| notes.deck.steps.first()) else { return 0 };
    notes.approximated(
        step.block,
        "left out: no body moves in it, and the ground of a case begins at rest under its weight",
    );
    1
}

fn say_setup(notes: &mut Notes, facts: &Facts) {
    let setup = &facts.setup;
    if setup.frame.is_plain() {
        notes.remark("Axes as in the deck.");
    } else {
        notes.remark(format!("Axes turned: {}.", setup.frame.words()));
    }
    if setup.frame.origin != [0.0; 3] {
        let moved = setup.frame.origin.map(|x| digits(x * facts.units.length));
        notes.remark(format!(
            "The origin of the case is at ({}) m along its axes, in the planes of symmetry.",
            moved.join(", ")
        ));
    }
    let share = facts.share();
    if setup.symmetric != [false; 2] {
        notes.remark("Part of a symmetric whole: forces of the case are those of the whole body, masses and loads of the deck are multiplied accordingly.");
    }
    if setup.is_plane_strain {
        notes.remark(
            "Plane strain: the deck is one element wide; forces, masses and loads are per metre of width.",
        );
    }
    if share != 1.0 {
        notes.remark(format!("Masses and loads of the deck times {}.", digits(share)));
    }
}

fn output(notes: &mut Notes, text: &mut CaseText, facts: &Facts, asked: &Asked) {
    for (key, interval) in [("field_interval", asked.field), ("history_interval", asked.history)] {
        if let Some((interval, block)) = interval {
            text.set("output", key, quantity(interval * facts.units.time, "s"), &notes.origin(block));
        }
    }
    if let Some(([linear, quadratic], block)) = asked.viscosity {
        text.set("numerics", "bulk_viscosity_linear", digits(linear), &notes.origin(block));
        text.set("numerics", "bulk_viscosity_quadratic", digits(quadratic), &notes.origin(block));
    }
}
