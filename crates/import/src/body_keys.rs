//! The bodies of a case and what moves them: `[body.NAME]`, `[stage.NAME]`, durations.

use crate::bodies::{self, Body};
use crate::case_text::{CaseText, digits, quantity};
use crate::connectors::{Joint, Kind};
use crate::contact::Friction;
use crate::facts::Facts;
use crate::fill::Ground;
use crate::motion::{self, KEYS, Mover, Span};
use crate::moves::{Dof, StepMoves};
use crate::notes::Notes;
use crate::written_body::{self, Place};

pub(super) fn all_bodies(
    notes: &mut Notes,
    text: &mut CaseText,
    facts: &Facts,
    frictions: &[Friction],
    ground: &Ground,
) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    let surface = ground.surface * facts.units.length;
    let gear = &facts.gear;
    for (number, body) in facts.bodies.iter().enumerate().filter(|(number, _)| !gear.is_mark[*number]) {
        let is_free = |step: &StepMoves, key: usize| {
            let (own, _) = motion::of_axis(&step[number], &facts.setup.frame, key);
            own.dof != Dof::Held && !facts.is_ruled_out(key)
        };
        let turns = facts.moves.iter().any(|step| (3..6).any(|key| is_free(step, key)));
        let place = Place { setup: &facts.setup, length: facts.units.length, surface, turns };
        files.extend(written_body::shape(notes, text, body, &place));
        if !body.is_frame() {
            friction(notes, text, facts, body, &frictions[number], ground);
        }
        weight(notes, text, facts, number);
        if gear.whole[number] != number {
            one_friction(notes, facts, frictions, number);
            let whole = format!("\"{}\"", facts.bodies[gear.whole[number]].name);
            text.set(&format!("body.{}", body.name), "welded_to", whole, "");
            continue;
        }
        for step in facts.first..facts.moves.len() {
            files.extend(step_motions(notes, text, facts, number, step));
        }
    }
    files
}

/// A body that is welded to another has the friction of all that is welded to it.
fn one_friction(notes: &mut Notes, facts: &Facts, frictions: &[Friction], number: usize) {
    let whole = &facts.gear.whole;
    let solid = (0..number).chain([whole[number]]).filter(|other| !facts.bodies[*other].is_frame());
    let of = |body: usize| (frictions[body].coefficient, frictions[body].most_shear);
    let other = solid.into_iter().find(|other| whole[*other] == whole[number] && of(*other) != of(number));
    if let Some(other) = other.filter(|_| !facts.bodies[number].is_frame()) {
        let message = format!("it is welded to {}, and its friction differs", facts.bodies[other].name);
        notes.refused(facts.bodies[number].block, message);
    }
}

fn friction(
    notes: &mut Notes,
    text: &mut CaseText,
    facts: &Facts,
    body: &Body,
    found: &Friction,
    ground: &Ground,
) {
    let section = format!("body.{}", body.name);
    let origin = found.block.map_or_else(|| "none in the deck".to_owned(), |block| notes.origin(block));
    let value =
        if found.coefficient.is_finite() { digits(found.coefficient) } else { "\"rough\"".to_owned() };
    text.set(&section, "friction", value, &origin);
    let (Some(most), Some(block)) = (found.most_shear, found.block) else { return };
    let name = ground.layers.first().map(|(material, _)| &facts.mesh.materials[*material][1]);
    let material = notes.deck.materials.iter().find(|material| Some(&material.name) == name);
    let strength = material
        .filter(|m| m.properties.get("MOHR COULOMB").and_then(|p| p.rows.first()?.first()) == Some(&0.0));
    let strength = strength.and_then(|m| m.properties.get("MOHR COULOMB HARDENING")?.rows.first()?.first());
    match strength.filter(|strength| **strength > 0.0) {
        Some(strength) => {
            text.set(&section, "adhesion_factor", digits((most / strength).min(1.0)), &origin);
            notes.understood(
                block,
                if most > *strength {
                    "the largest shear stress is more than the soil bears: its undrained strength limits it"
                } else {
                    "largest shear stress, as a factor of the undrained strength"
                },
            );
        }
        None => notes.approximated(
            block,
            "TAUMAX is left out: only undrained soil (Mohr–Coulomb with φ = 0) limits friction",
        ),
    }
}

/// Mass and moment about the axle, and whether a body that moves freely has them.
fn weight(notes: &mut Notes, text: &mut CaseText, facts: &Facts, number: usize) {
    let (body, inertia) = (&facts.bodies[number], &facts.inertias[number]);
    let section = format!("body.{}", body.name);
    let is_free = (0..3).filter(|key| !facts.is_ruled_out(*key)).any(|key| {
        facts
            .moves
            .iter()
            .any(|step| motion::of_axis(&step[number], &facts.setup.frame, key).0.dof == Dof::Free)
    });
    match inertia.mass {
        Some((mass, block)) => {
            let value = mass * facts.units.mass * facts.share();
            text.set(&section, "mass", quantity(value, "kg"), &notes.origin(block));
        }
        None if is_free => notes.refused(
            body.block,
            format!("{} moves freely and has no mass: give its reference node *Mass, or hold it", body.name),
        ),
        None => {}
    }
    let turns = |key: &usize| {
        !facts.is_ruled_out(*key)
            && facts
                .moves
                .iter()
                .any(|step| motion::of_axis(&step[number], &facts.setup.frame, *key).0.dof == Dof::Free)
    };
    if body.is_frame() && inertia.moments.is_none() && (3..6).any(|key| turns(&key)) {
        notes.refused(
            body.block,
            format!(
                "{} turns freely and has no moment of inertia: give its node *Rotary Inertia, or hold it",
                body.name
            ),
        );
    }
    if let Some((moments, block)) = inertia.moments {
        let axis = facts.setup.frame.axes[1].0;
        let value = moments[axis] * facts.units.mass * facts.units.length.powi(2) * facts.share();
        if value > 0.0 {
            text.set(&section, "axle_inertia", quantity(value, "kg*m^2"), &notes.origin(block));
        }
    }
}

/// Name of a stage.
fn stage(notes: &Notes, step: usize) -> String {
    let name = bodies::plain(&notes.deck.steps[step].name);
    let is_twice = notes.deck.steps.iter().filter(|other| bodies::plain(&other.name) == name).count() > 1;
    if is_twice { format!("{name}-{}", step + 1) } else { name }
}

/// The weight that gravity gives a body in the case and not in the deck [N].
fn extra_weight(notes: &Notes, facts: &Facts, number: usize) -> f64 {
    let (deck, body) = (notes.deck, &facts.bodies[number]);
    let is_pulled = facts.gravity.pulled.as_ref().is_none_or(|pulled| {
        pulled.iter().any(|id| {
            body.elements.contains(id) || deck.element(*id).is_some_and(|e| e.nodes == [body.reference])
        })
    });
    let mass = facts.inertias[number].mass.map_or(0.0, |(mass, _)| mass * facts.units.mass * facts.share());
    if is_pulled { 0.0 } else { mass * facts.gravity.size * facts.units.acceleration() }
}

/// The motions of a body that begin or change in a step.
fn step_motions(
    notes: &mut Notes,
    text: &mut CaseText,
    facts: &Facts,
    number: usize,
    step: usize,
) -> Vec<(String, Vec<u8>)> {
    let (deck, body) = (notes.deck, &facts.bodies[number]);
    let begin = deck.steps[..step].iter().map(|step| step.duration).sum();
    let span = Span { begin, duration: deck.steps[step].duration, goes_on: step + 1 < facts.moves.len() };
    let stage = stage(notes, step);
    let members = (0..facts.bodies.len()).filter(|other| facts.gear.whole[*other] == number);
    let extra_weight = members.map(|member| extra_weight(notes, facts, member)).sum();
    let table = format!("{}-{stage}", body.name);
    let mover = Mover {
        units: &facts.units,
        frame: &facts.setup.frame,
        share: facts.share(),
        extra_weight,
        table,
        span,
    };
    // What is not given is held, but free of a body that a joint carries.
    let carries = |joint: &Joint| !matches!(joint.kind, Kind::Spring(_)) && joint.ends[1] == Some(number);
    let is_carried = facts.gear.joints.iter().any(carries);
    let mut files = Vec::new();
    for (key, name) in KEYS.into_iter().enumerate() {
        let own = &facts.moves[step][number];
        let (now, _) = motion::of_axis(own, mover.frame, key);
        let before =
            (step > facts.first).then(|| motion::of_axis(&facts.moves[step - 1][number], mover.frame, key).0);
        if facts.is_ruled_out(key) {
            if let (Dof::Velocity(..) | Dof::Displacement(..), Some(block)) = (&now.dof, now.block) {
                notes.refused(block, "a motion across a plane of symmetry");
            }
            continue;
        }
        let is_same = before.map_or(now.dof == Dof::Held && !is_carried, |before| before == now);
        let moved = (facts.first..step)
            .any(|s| motion::of_axis(&facts.moves[s][number], mover.frame, key).0.dof != Dof::Held);
        if let (false, true, Dof::Displacement(..), Some(block)) = (is_same, moved, &now.dof, now.block) {
            notes.refused(
                block,
                "a displacement along which the body has moved in an earlier step: use velocities",
            );
            continue;
        }
        let Some(written) = (!is_same).then(|| motion::written(notes, own, key, &mover)).flatten() else {
            continue;
        };
        let origin = written.block.map_or_else(|| "nothing holds it".to_owned(), |block| notes.origin(block));
        if step == facts.first {
            text.set(&format!("body.{}", body.name), name, written.value, &origin);
        } else {
            text.set(&format!("stage.{stage}"), &format!("{}.{name}", body.name), written.value, &origin);
        }
        files.extend(written.file.map(|(name, text)| (name, text.into_bytes())));
    }
    files
}

pub(super) fn durations(notes: &mut Notes, text: &mut CaseText, facts: &Facts) {
    let deck = notes.deck;
    let steps = deck.steps.len();
    for (number, step) in deck.steps.iter().enumerate().skip(facts.first) {
        let origin = step.procedure.map_or_else(String::new, |block| notes.origin(block));
        let section = if steps - facts.first == 1 {
            "run".to_owned()
        } else {
            format!("stage.{}", stage(notes, number))
        };
        text.set(&section, "duration", quantity(step.duration * facts.units.time, "s"), &origin);
    }
}
