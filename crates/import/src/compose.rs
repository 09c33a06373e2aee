//! From the model of a deck to the text of a case.

use crate::bodies::{self, Body};
use crate::case_text::{CaseText, digits, quantity, quoted, range};
use crate::contact::{self, Friction};
use crate::eulerian::{self, Eulerian};
use crate::fill::{self, Box3, Ground};
use crate::gravity::{self, Gravity};
use crate::masses::{self, Inertia};
use crate::motion::{self, KEYS, Mover, Span};
use crate::moves::{Dof, StepMoves, moves};
use crate::notes::Notes;
use crate::orient::{Setup, setup};
use crate::others::{self, Asked};
use crate::parameters;
use crate::report::{self, Imported, Refused};
use crate::rest::{self, Site};
use crate::soil::{self, Setting};
use crate::units::Units;
use crate::walls::Held;
use crate::written_body::{self, Place};
use crate::zones;
use deck::{Deck, Outcome};
use std::collections::HashSet;

/// All that is known of a deck before the case is written.
struct Facts<'a> {
    units: Units,
    gravity: Gravity,
    mesh: &'a Eulerian,
    bodies: &'a [Body],
    inertias: Vec<Inertia>,
    moves: Vec<StepMoves>,
    held: Held,
    setup: Setup,
    /// Number of the first step that is run: one that only lets gravity act is not.
    first: usize,
}

impl Facts<'_> {
    /// By what masses and loads of the deck are multiplied: halves and quarters are wholes in a case, and
    /// plane strain counts a metre.
    fn share(&self) -> f64 {
        let halves = self.setup.symmetric.iter().filter(|is| **is).count() as i32;
        let axis = self.setup.frame.axes[1].0;
        let planes = &self.mesh.faces[axis];
        let width = if self.setup.is_plane_strain {
            (planes[planes.len() - 1] - planes[0]) * self.units.length
        } else {
            1.0
        };
        2_f64.powi(halves) / width
    }

    /// Whether a motion of the case is ruled out by symmetry.
    fn is_ruled_out(&self, number: usize) -> bool {
        let flat = self.setup.is_plane_strain || self.setup.symmetric[0];
        flat && [1, 3, 5].contains(&number) || self.setup.symmetric[1] && [0, 4, 5].contains(&number)
    }
}

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
    let bodies = bodies::bodies(notes);
    let frictions = contact::frictions(notes, &bodies);
    let inertias = masses::inertias(notes, &bodies);
    let found = eulerian::mesh(notes);
    steps(notes);
    let mesh = found?;
    let units = known_units(notes, units, &gravity, &mesh)?;
    let (moves, held) = moves(notes, &bodies, &mesh);
    let setup = setup(&mesh, &held, &bodies, &moves, gravity.up);
    let first = first_step(notes, &moves);
    let facts = Facts { units, gravity, mesh: &mesh, bodies: &bodies, inertias, moves, held, setup, first };
    say_setup(notes, &facts);
    let at = Box3::new(&mesh, &facts.setup.frame);
    let skipped: Vec<[[f64; 2]; 3]> = bodies.iter().map(|body| turned_bounds(body, &facts.setup)).collect();
    let ground = fill::ground(notes, &mesh, &at, &skipped)?;
    let mut text = CaseText::default();
    let title = if deck.title.is_empty() { name } else { &deck.title };
    text.set("", "format", "2", "");
    text.set("", "title", quoted(title), "*heading");
    let block = facts.gravity.block.map_or_else(|| "no *dload grav".to_owned(), |block| notes.origin(block));
    text.set("", "gravity", quantity(facts.gravity.size * facts.units.acceleration(), "m/s^2"), &block);
    soils(notes, &mut text, &facts, &at, &ground)?;
    domain(notes, &mut text, &facts, &at);
    grid(notes, &mut text, &facts, &at);
    // Stages follow one another as they stand in the file: before any motion of a later one.
    durations(notes, &mut text, &facts);
    let files = all_bodies(notes, &mut text, &facts, &frictions, &ground);
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

fn soils(notes: &mut Notes, text: &mut CaseText, facts: &Facts, at: &Box3, ground: &Ground) -> Option<()> {
    let deck = notes.deck;
    let find = |name: &str| deck.materials.iter().find(|material| material.name == name);
    let weight =
        |[_, name]: &[String; 2]| find(name).and_then(soil::density).unwrap_or(0.0) * facts.gravity.size;
    let weight = facts.mesh.materials.iter().map(weight).collect();
    let site = Site { mesh: facts.mesh, at, ground, frame: &facts.setup.frame, weight };
    let rest = rest::rest(notes, &site);
    let length = facts.units.length;
    let mut names: Vec<String> = Vec::new();
    let mut is_sound = true;
    for (number, (material, top)) in ground.layers.iter().enumerate() {
        let name = &facts.mesh.materials[*material][1];
        let Some(own) = find(name) else {
            notes.refused(facts.mesh.section, format!("there is no material {name}"));
            return None;
        };
        let setting = Setting {
            units: &facts.units,
            in_plane_strain: facts.setup.is_plane_strain,
            k0: rest.k0.get(material).copied(),
        };
        let mut section = "soil".to_owned();
        if number > 0 {
            let mut plain = bodies::plain(name);
            while names.contains(&plain) {
                plain.push_str("-b");
            }
            section = format!("layer.{plain}");
            names.push(plain);
            text.set(
                &section,
                "top",
                quantity((ground.surface - top) * length, "m"),
                &notes.origin(ground.block),
            );
        }
        let Some(keys) = soil::soil(notes, own, &setting) else {
            is_sound = false;
            continue;
        };
        keys.into_iter().for_each(|(key, value, block)| text.set(&section, key, value, &notes.origin(block)));
    }
    unused(notes);
    ground_keys(notes, text, facts, ground, &rest);
    is_sound.then_some(())
}

/// Where the ground is, and what presses on it.
fn ground_keys(notes: &Notes, text: &mut CaseText, facts: &Facts, ground: &Ground, rest: &rest::Rest) {
    let length = facts.units.length;
    let origin = notes.origin(ground.block);
    text.set("ground", "surface", quantity(ground.surface * length, "m"), &origin);
    for (key, extent) in ["x", "y"].into_iter().zip(ground.extent) {
        if let Some(extent) = extent.filter(|_| !(key == "y" && facts.setup.is_plane_strain)) {
            text.set("ground", key, range(extent.map(|x| x * length), "m"), &origin);
        }
    }
    if let Some((pressure, block)) = rest.overburden {
        text.set(
            "ground",
            "overburden",
            quantity(pressure * facts.units.stress(), "Pa"),
            &notes.origin(block),
        );
    }
}

/// Materials that no soil has.
fn unused(notes: &mut Notes) {
    let deck = notes.deck;
    for material in &deck.materials {
        for block in
            std::iter::once(material.block).chain(material.properties.values().map(|property| property.block))
        {
            if !notes.ledger.has(block) {
                notes.ignored(block, "no soil of the case is of this material");
            }
        }
    }
}

fn domain(notes: &mut Notes, text: &mut CaseText, facts: &Facts, at: &Box3) {
    let (origin, setup) = (notes.origin(facts.mesh.section), &facts.setup);
    for (axis, key) in ["x", "y", "z"].into_iter().enumerate() {
        let planes = &at.faces[axis];
        if axis != 1 || !setup.is_plane_strain {
            let ends = [planes[0], planes[planes.len() - 1]].map(|x| x * facts.units.length);
            text.set("domain", key, range(ends, "m"), &origin);
        }
    }
    for (key, is_set) in [
        ("plane_strain", setup.is_plane_strain),
        ("symmetric", setup.symmetric[0]),
        ("symmetric_x", setup.symmetric[1]),
    ] {
        if is_set {
            text.set("domain", key, "true", "*boundary on faces of the box");
        }
    }
    let mut open = Vec::new();
    for (axis, key) in ["x_walls", "y_walls", "z_walls"].into_iter().enumerate() {
        let (own, same) = setup.frame.axes[axis];
        let wall = |low: bool| {
            let held = facts.held[own][usize::from(low != same)];
            let is_counted =
                |other: &usize| *other != own && !(setup.is_plane_strain && *other == setup.frame.axes[1].0);
            let across = (0..3).filter(is_counted).filter(|other| held[*other]).count();
            (held[own], across)
        };
        let walls = [wall(true), wall(false)];
        let all = if setup.is_plane_strain { 1 } else { 2 };
        let words = walls.map(|(_, across)| if across == all { "fixed" } else { "smooth" });
        let usual = if axis == 2 { ["fixed", "smooth"] } else { ["smooth", "smooth"] };
        if words != usual && !(axis == 1 && setup.is_plane_strain) {
            text.set(
                "domain",
                key,
                format!("[\"{}\", \"{}\"]", words[0], words[1]),
                "*boundary on faces of the box",
            );
        }
        for (side, (normal, across)) in ["low", "high"].into_iter().zip(walls) {
            let is_lid = axis == 2 && side == "high";
            if !(normal || is_lid) || (1..all).contains(&across) {
                open.push(format!("{side} {}", &key[..1]));
            }
        }
    }
    if !open.is_empty() {
        let text = format!(
            "faces that the deck leaves open or holds along one direction are closed smooth walls: {}",
            open.join(", ")
        );
        notes.approximated(facts.mesh.section, text);
    }
}

fn grid(notes: &mut Notes, text: &mut CaseText, facts: &Facts, at: &Box3) {
    let (length, flat) = (facts.units.length, facts.setup.is_plane_strain);
    let origin = notes.origin(facts.mesh.section);
    let zones = at.faces.each_ref().map(|planes| zones::zone(planes));
    let axes = || (0..3).filter(|axis| !(flat && *axis == 1));
    let cell = axes().map(|axis| zones[axis].width).fold(f64::INFINITY, f64::min);
    let ratio = |axis: usize| if flat && axis == 1 { 1.0 } else { zones[axis].width / cell };
    let aspect = [0, 1, 2].map(|axis| ratio(axis).clamp(1.0, 4.0));
    let growth = axes().map(|axis| zones[axis].growth).fold(1.0, f64::max);
    let used = growth.clamp(1.02, 1.5);
    text.set("grid", "cell", quantity(cell * length, "m"), &origin);
    if aspect.iter().any(|aspect| (aspect - 1.0).abs() > 1e-3) {
        text.set(
            "grid",
            "aspect",
            format!("[{}]", aspect.map(|x| digits((x * 1000.0).round() / 1000.0)).join(", ")),
            &origin,
        );
    }
    text.set(
        "grid",
        "growth",
        digits((used * 1e4).ceil() / 1e4),
        "largest ratio of neighbouring cells of the deck",
    );
    for (axis, key) in ["fine_x", "fine_y", "fine_z"].into_iter().enumerate() {
        if !(flat && axis == 1) {
            text.set(
                "grid",
                key,
                range(zones[axis].fine.map(|x| x * length), "m"),
                "where the deck has its smallest cells",
            );
        }
    }
    if axes().any(|axis| ratio(axis) > 4.0) || growth > 1.5 {
        let text = format!(
            "cells flatter than 4 to 1 or growing by more than 1.5 ({growth:.2} in the deck): the case has smaller ones there"
        );
        notes.approximated(facts.mesh.section, text);
    }
}

fn all_bodies(
    notes: &mut Notes,
    text: &mut CaseText,
    facts: &Facts,
    frictions: &[Friction],
    ground: &Ground,
) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    let surface = ground.surface * facts.units.length;
    for (number, body) in facts.bodies.iter().enumerate() {
        let is_free = |step: &StepMoves, key: usize| {
            let (own, _) = motion::of_axis(&step[number], &facts.setup.frame, key);
            own.dof != Dof::Held && !facts.is_ruled_out(key)
        };
        let turns = facts.moves.iter().any(|step| (3..6).any(|key| is_free(step, key)));
        let place = Place { setup: &facts.setup, length: facts.units.length, surface, turns };
        files.extend(written_body::shape(notes, text, body, &place));
        friction(notes, text, facts, body, &frictions[number], ground);
        weight(notes, text, facts, number);
        for step in facts.first..facts.moves.len() {
            files.extend(step_motions(notes, text, facts, number, step));
        }
    }
    files
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
            "it moves freely and has no mass: give its reference node *Mass, or hold it",
        ),
        None => {}
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
    let extra_weight = extra_weight(notes, facts, number);
    let table = format!("{}-{stage}", body.name);
    let mover = Mover {
        units: &facts.units,
        frame: &facts.setup.frame,
        share: facts.share(),
        extra_weight,
        table,
        span,
    };
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
        let is_same = before.map_or(now.dof == Dof::Held, |before| before == now);
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

fn durations(notes: &mut Notes, text: &mut CaseText, facts: &Facts) {
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
