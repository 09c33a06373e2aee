//! Mass and moments of inertia at reference nodes.

use crate::bodies::{self, Body};
use crate::notes::Notes;
use deck::block::Wrong;
use deck::model::{Id, Section};
use std::collections::HashMap;

/// What the deck says of the inertia of a body, in its own units and axes.
#[derive(Clone, Debug, Default)]
pub(super) struct Inertia {
    /// Mass, with its block.
    pub(super) mass: Option<(f64, usize)>,
    /// Moments about the axes of the deck, with their block.
    pub(super) moments: Option<([f64; 3], usize)>,
}

/// The inertia of each body.
pub(super) fn inertias(notes: &mut Notes, bodies: &[Body]) -> Vec<Inertia> {
    let mut found = vec![Inertia::default(); bodies.len()];
    let deck = notes.deck;
    let owners = bodies::owners(notes, bodies);
    for (region, own) in deck.regions.iter().enumerate() {
        for section in &own.sections {
            let keyword = deck.blocks[section.block].keyword.as_str();
            if keyword != "MASS" && keyword != "ROTARY INERTIA" {
                continue;
            }
            if let Err(wrong) = one(notes, region, section, bodies, &owners, &mut found) {
                notes.refused(section.block, wrong);
            }
        }
    }
    solids(notes, bodies, &mut found);
    found
}

fn one(
    notes: &mut Notes,
    region: usize,
    section: &Section,
    bodies: &[Body],
    owners: &HashMap<Id, usize>,
    found: &mut [Inertia],
) -> Result<(), Wrong> {
    let deck = notes.deck;
    let is_mass = deck.blocks[section.block].keyword == "MASS";
    let ids = deck
        .elements(region, &section.elements)
        .ok_or_else(|| format!("there is no element set {}", section.elements))?;
    let row = section.rows.first().ok_or("a line of data was expected")?;
    let numbers = row.numbers()?;
    let mut is_off = false;
    for id in ids {
        let node = deck.element(id).and_then(|element| element.nodes.first().copied());
        let body = node.and_then(|node| owners.get(&node).copied());
        let body = body.ok_or("it is at no node of a rigid body")?;
        is_off |= node != Some(bodies[body].reference);
        let value = numbers.first().copied().unwrap_or(0.0);
        if numbers.iter().take(3).any(|value| *value < 0.0) || value == 0.0 {
            return Err(Wrong::at(row.place, "values above 0 were expected"));
        }
        if is_mass {
            let before = found[body].mass.map_or(0.0, |(mass, _)| mass);
            found[body].mass = Some((before + value, section.block));
            notes.understood(section.block, format!("mass of {}", bodies[body].name));
        } else {
            let at = |n: usize| numbers.get(n).copied().unwrap_or(0.0);
            let before = found[body].moments.map_or([0.0; 3], |(moments, _)| moments);
            found[body].moments = Some(([0, 1, 2].map(|n| before[n] + at(n)), section.block));
            let text = "the moment about the axle is taken; the others are those of a uniform solid of the same mass";
            notes.approximated(section.block, text);
        }
    }
    if is_off {
        let text = "what is at other nodes of the body counts as if it were at the reference node";
        notes.approximated(section.block, text);
    }
    Ok(())
}

/// Sections of solids and shells that are parts of rigid bodies: solids weigh what their density says.
fn solids(notes: &mut Notes, bodies: &[Body], found: &mut [Inertia]) {
    let deck = notes.deck;
    for (region, own) in deck.regions.iter().enumerate() {
        for section in &own.sections {
            let keyword = deck.blocks[section.block].keyword.as_str();
            let is_solid = keyword == "SOLID SECTION";
            if !is_solid && keyword != "SHELL SECTION" {
                continue;
            }
            let ids: Vec<Id> = deck.elements(region, &section.elements).unwrap_or_default();
            let body = bodies
                .iter()
                .position(|body| !ids.is_empty() && ids.iter().all(|id| body.elements.contains(id)));
            let Some(body) = body else {
                let cure = "make the body rigid with *Rigid Body";
                notes.refused(section.block, format!("elements that deform are not represented; {cure}"));
                continue;
            };
            let material =
                section.material.as_ref().and_then(|name| deck.materials.iter().find(|m| m.name == *name));
            let density = material
                .and_then(|m| m.properties.get("DENSITY"))
                .and_then(|p| Some((p.block, p.rows.first()?.first().copied()?)));
            match density.filter(|_| is_solid && found[body].mass.is_none()) {
                Some((block, density)) => {
                    notes.understood(block, format!("density of {}", bodies[body].name));
                    found[body].mass = Some((density * bodies[body].hull.volume().abs(), section.block));
                    notes.understood(
                        section.block,
                        format!("mass of {} from its density and volume", bodies[body].name),
                    );
                }
                None => {
                    notes.ignored(section.block, "the body is rigid: only *Mass at its reference node weighs")
                }
            }
        }
    }
}
