//! The rigid bodies of a deck: name, reference node, surface. A node alone at the end of a connector is one.

use crate::hull::{self, Hull};
use crate::notes::Notes;
use deck::Deck;
use deck::model::{Id, RigidBody, Surface};
use std::collections::{HashMap, HashSet};

/// A rigid body, in axes and units of the deck.
pub(super) struct Body {
    /// Its name in the case.
    pub(super) name: String,
    /// Block of its constraint.
    pub(super) block: usize,
    /// Its reference node, and where that is.
    pub(super) reference: Id,
    pub(super) position: [f64; 3],
    /// Its elements, and nodes besides theirs that move with it.
    pub(super) elements: HashSet<Id>,
    pub(super) tied: Vec<Id>,
    /// Its surface in triangles; of a frame, which has none, its reference point alone.
    pub(super) hull: Hull,
    /// Its analytical surface, with its name.
    pub(super) analytical: Option<(String, Surface)>,
}

impl Body {
    /// Whether it has no surface.
    pub(super) fn is_frame(&self) -> bool {
        self.hull.triangles.is_empty()
    }
}

/// Whether a block is the section of connectors.
pub(super) fn is_connector(deck: &Deck, block: usize) -> bool {
    ["CONNECTOR SECTION", "SPRING"].contains(&deck.blocks[block].keyword.as_str())
}

/// The nodes of all bodies, with the number of their body.
pub(super) fn owners(notes: &Notes, bodies: &[Body]) -> HashMap<Id, usize> {
    let deck = notes.deck;
    let mut found = HashMap::new();
    for (number, body) in bodies.iter().enumerate() {
        let elements = body.elements.iter().filter_map(|id| deck.element(*id));
        let nodes = elements.flat_map(|element| &element.nodes).chain(&body.tied);
        found.extend(nodes.chain([&body.reference]).map(|id| (*id, number)));
    }
    found
}

/// Nodes alone at the ends of connectors as bodies without a surface.
pub(super) fn add_points(notes: &mut Notes, bodies: &mut Vec<Body>) {
    let deck = notes.deck;
    let mut known: HashSet<Id> = owners(notes, bodies).into_keys().collect();
    for (region, own) in deck.regions.iter().enumerate() {
        for section in own.sections.iter().filter(|section| is_connector(deck, section.block)) {
            let ids = deck.elements(region, &section.elements).unwrap_or_default();
            let nodes = ids.iter().filter_map(|id| deck.element(*id)).flat_map(|element| &element.nodes);
            for id in nodes.filter(|id| id.label > 0) {
                let Some(position) = deck.node(*id).filter(|_| known.insert(*id)) else { continue };
                let mut name = format!("point-{}", id.label);
                while bodies.iter().any(|other| other.name == name) {
                    name.push_str("-b");
                }
                bodies.push(Body {
                    name,
                    block: section.block,
                    reference: *id,
                    position,
                    elements: HashSet::new(),
                    tied: Vec::new(),
                    hull: Hull { points: vec![position], triangles: Vec::new() },
                    analytical: None,
                });
            }
        }
    }
}

/// All rigid bodies that can be represented.
pub(super) fn bodies(notes: &mut Notes) -> Vec<Body> {
    let deck = notes.deck;
    let mut found: Vec<Body> = Vec::new();
    for (region, own) in deck.regions.iter().enumerate() {
        for constraint in &own.rigid_bodies {
            match body(notes, region, constraint) {
                Ok(mut body) => {
                    if found.iter().any(|other| other.reference == body.reference) {
                        notes.refused(body.block, "two rigid bodies have one reference node: make them one");
                        continue;
                    }
                    while found.iter().any(|other| other.name == body.name) {
                        body.name.push_str("-b");
                    }
                    found.push(body);
                }
                Err(message) => notes.refused(constraint.block, message),
            }
        }
    }
    found
}

fn body(notes: &Notes, region: usize, constraint: &RigidBody) -> Result<Body, String> {
    let deck = notes.deck;
    let reference = match deck.nodes(region, &constraint.reference).as_deref() {
        Some([one, others @ ..]) if others.iter().all(|other| other == one) => *one,
        Some(many) => {
            return Err(format!("its reference is a set of {} nodes: one was expected", many.len()));
        }
        None => return Err(format!("there is no node or node set {}", constraint.reference)),
    };
    let position = deck.node(reference).ok_or("its reference node is not there")?;
    let (mut elements, mut triangles, mut analytical) = (Vec::new(), None, None);
    if let Some(set) = &constraint.elements {
        elements = deck.elements(region, set).ok_or_else(|| format!("there is no element set {set}"))?;
        triangles = Some(hull::of_elements(deck, &elements)?);
    }
    if let Some(name) = &constraint.surface {
        if triangles.is_some() {
            return Err("elements and an analytical surface of one body: one of them was expected".to_owned());
        }
        let (_, (_, surface)) =
            deck.surface(region, name).ok_or_else(|| format!("there is no surface {name}"))?;
        let turned = hull::of_revolution(surface);
        triangles = Some(turned.ok_or("of analytical surfaces only those of revolution are represented")?);
        analytical = Some((name.clone(), surface.clone()));
    }
    let tied = match &constraint.tied {
        Some(set) => deck.nodes(region, set).ok_or_else(|| format!("there is no node set {set}"))?,
        None => Vec::new(),
    };
    let own = deck.regions.get(region).map_or("", |region| region.name.as_str());
    let words = [&constraint.elements, &constraint.surface, &constraint.tied];
    let name = if own.is_empty() { words.into_iter().flatten().next() } else { None };
    Ok(Body {
        name: plain(name.map_or(own, String::as_str)),
        block: constraint.block,
        reference,
        position,
        elements: elements.into_iter().collect(),
        tied,
        hull: triangles.unwrap_or_else(|| Hull { points: vec![position], triangles: Vec::new() }),
        analytical,
    })
}

/// A name of the case: small letters, without the number of an instance.
pub(super) fn plain(name: &str) -> String {
    let name = name.strip_suffix("-1").unwrap_or(name).to_lowercase();
    let letters =
        name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' || c == '_' { c } else { '-' });
    let plain: String = letters.take(40).collect();
    let is_taken =
        ["", "con", "prn", "aux", "nul", "ground", "duration", "until", "steady"].contains(&plain.as_str());
    if is_taken { format!("body-{plain}") } else { plain }
}
