//! Connectors: which bodies they join, and how.

use crate::bodies::{self, Body};
use crate::notes::Notes;
use crate::springs::{self, Spring};
use deck::block::{Row, Wrong};
use deck::model::{Element, Id, Section};
use std::collections::{HashMap, HashSet};

/// What a connector does, in axes and units of the deck.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// It turns about an axis.
    Hinge([f64; 3]),
    /// It turns about a point.
    Ball,
    /// It slides along an axis.
    Slider([f64; 3]),
    /// It pulls its ends together, or apart.
    Spring(Spring),
    /// It makes one body of two.
    Weld,
}

/// A connector between two bodies.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub(super) name: String,
    /// Block of its section.
    pub(super) block: usize,
    pub(super) element: Id,
    /// Numbers of its bodies; `None`: the ground.
    pub(super) ends: [Option<usize>; 2],
    /// Whether its bodies are in the other order than its nodes.
    pub(super) is_reversed: bool,
    /// Where its nodes are; that of the ground is where the other is.
    pub(super) at: [[f64; 3]; 2],
    /// Its pivot, that of a hinge or a ball: the second node.
    pub(super) pivot: [f64; 3],
    pub(super) kind: Kind,
    /// Torque on its second body about the axis of a hinge, and in how many steps it acts.
    pub(super) torque: Option<(f64, usize)>,
}

/// Elements that are connectors.
const KINDS: [&str; 2] = ["CONN3D2", "SPRINGA"];
/// Most connectors.
const MOST: usize = 1000;

/// All connectors that can be represented.
pub(super) fn joints(notes: &mut Notes, bodies: &[Body]) -> Vec<Joint> {
    let deck = notes.deck;
    let owners = bodies::owners(notes, bodies);
    let (mut found, mut seen) = (Vec::new(), HashSet::new());
    for (region, own) in deck.regions.iter().enumerate() {
        for section in own.sections.iter().filter(|section| bodies::is_connector(deck, section.block)) {
            let ids = deck.elements(region, &section.elements).unwrap_or_default();
            seen.extend(ids.iter().copied());
            match kind(notes, region, section).and_then(|kind| placed(notes, section, &ids, kind, &owners)) {
                Ok(joints) if found.len() + joints.len() <= MOST => {
                    for mut joint in joints {
                        while found.iter().any(|other: &Joint| other.name == joint.name) {
                            joint.name.push_str("-b");
                        }
                        found.push(joint);
                    }
                }
                Ok(_) => notes.refused(section.block, format!("more than {MOST} connectors")),
                Err(wrong) => notes.refused(section.block, wrong),
            }
        }
        let alone = own.elements.iter().filter(|(_, element)| KINDS.contains(&element.kind.as_str()));
        let alone =
            alone.map(|(label, _)| *label).find(|label| !seen.contains(&Id { region, label: *label }));
        if let Some(label) = alone {
            notes.lacks(format!("Connector element {label} has no *Connector Section or *Spring."));
        }
    }
    for block in deck.behaviours.values().flatten() {
        if !notes.ledger.has(*block) {
            notes.ignored(*block, "no connector refers to it");
        }
    }
    for (block, _) in deck.regions.iter().flat_map(|region| region.orientations.values()) {
        if !notes.ledger.has(*block) {
            let text = "nothing of the case has these directions: soil is isotropic, bodies are rigid";
            notes.ignored(*block, text);
        }
    }
    found
}

/// Rotations without any constraint.
const FREE: [&str; 4] = ["ROTATION", "CARDAN", "EULER", "FLEXION-TORSION"];

/// What the connectors of a section do; `None`: they only measure.
fn kind(notes: &mut Notes, region: usize, section: &Section) -> Result<Option<Kind>, Wrong> {
    let deck = notes.deck;
    let [first, rest @ ..] = section.rows.as_slice() else {
        return Err("a line with its type was expected".into());
    };
    if deck.blocks[section.block].keyword == "SPRING" {
        let stiffness =
            springs::only(&section.rows, "one stiffness above 0 was expected", |value| value > 0.0)?;
        return Ok(Some(Kind::Spring(Spring { stiffness, ..Spring::default() })));
    }
    let types: Vec<String> =
        first.fields().into_iter().map(str::to_uppercase).filter(|t| !t.is_empty()).collect();
    let words: Vec<&str> = types.iter().map(String::as_str).collect();
    let axes = orientations(notes, region, rest)?;
    let axis = || {
        axes.ok_or_else(|| Wrong::from("an orientation is missing: its first axis is that of the connector"))
    };
    let kind = match words[..] {
        ["HINGE"] | ["JOIN", "REVOLUTE"] => Kind::Hinge(axis()?),
        ["TRANSLATOR"] | ["SLOT", "ALIGN"] => Kind::Slider(axis()?),
        ["BEAM" | "WELD"] | ["JOIN", "ALIGN"] => Kind::Weld,
        ["JOIN"] => Kind::Ball,
        ["JOIN", turn] if FREE.contains(&turn) => Kind::Ball,
        ["AXIAL"] => Kind::Spring(Spring::default()),
        ["AXIAL", turn] if FREE.contains(&turn) => Kind::Spring(Spring::default()),
        [one] if FREE.contains(&one) || one == "CARTESIAN" => Kind::Spring(Spring::default()),
        _ => {
            let known = "HINGE, JOIN, TRANSLATOR, BEAM, WELD and AXIAL are represented";
            return Err(Wrong::at(first.place, format!("of connectors {known}, not {}", types.join(", "))));
        }
    };
    let behaviour = match deck.blocks[section.block].word("BEHAVIOR") {
        Some(name) => {
            deck.behaviours.get(&name).ok_or_else(|| format!("there is no connector behaviour {name}"))?
        }
        None => &Vec::new(),
    };
    match kind {
        Kind::Spring(_) if behaviour.len() < 2 => {
            behaviour.iter().for_each(|block| notes.ignored(*block, "it is empty"));
            let text = "it has no stiffness and only measures; a case reports motions and forces of bodies and joints";
            notes.ignored(section.block, text);
            Ok(None)
        }
        Kind::Spring(_) if words[0] == "AXIAL" => {
            springs::of_behaviour(notes, behaviour).map(|spring| Some(Kind::Spring(spring)))
        }
        kind => {
            for block in behaviour.iter().skip(1) {
                notes.refused(
                    *block,
                    "only springs, dampers and lengths along the line of an AXIAL connector are represented",
                );
            }
            behaviour.iter().take(1).for_each(|block| notes.understood(*block, "behaviour of a connector"));
            Ok(Some(kind))
        }
    }
}

/// The first axis of the orientation at the first node.
fn orientations(notes: &mut Notes, region: usize, rows: &[Row]) -> Result<Option<[f64; 3]>, Wrong> {
    let deck = notes.deck;
    let Some(row) = rows.first() else { return Ok(None) };
    if let Some(row) = rows.get(1) {
        return Err(Wrong::at(row.place, "two lines of data were expected at most"));
    }
    let mut axes = Vec::new();
    for name in row.fields().into_iter().map(|name| name.trim_matches(['"', '\'']).to_uppercase()) {
        let own = [region, 0].into_iter().find_map(|r| deck.regions[r].orientations.get(&name));
        let missing = || Wrong::at(row.place, format!("there is no orientation {name:?}"));
        let (block, own) = own.ok_or_else(missing)?;
        notes.understood(*block, "axes of connectors");
        axes.push(own[0]);
    }
    let is_far = |b: &[f64; 3]| axes[0].iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-6);
    if axes.iter().skip(1).any(is_far) {
        return Err(Wrong::at(
            row.place,
            "the first axes at the two nodes differ: the same one was expected",
        ));
    }
    Ok(axes.first().copied())
}

/// The connectors of a section at their bodies.
fn placed(
    notes: &mut Notes,
    section: &Section,
    ids: &[Id],
    kind: Option<Kind>,
    owners: &HashMap<Id, usize>,
) -> Result<Vec<Joint>, Wrong> {
    let deck = notes.deck;
    let Some(kind) = kind else { return Ok(Vec::new()) };
    if ids.is_empty() {
        return Err(format!("there is no element set {}", section.elements).into());
    }
    let mut found = Vec::new();
    for id in ids {
        let of = |element: &&Element| KINDS.contains(&element.kind.as_str()) && element.nodes.len() == 2;
        let element =
            deck.element(*id).filter(of).ok_or_else(|| format!("element {} is no connector", id.label))?;
        let nodes = [element.nodes[0], element.nodes[1]];
        let ends = nodes.map(|node| owners.get(&node).copied());
        let points = nodes.map(|node| deck.node(node));
        let missing = nodes.iter().zip(&points).find(|(node, point)| node.label > 0 && point.is_none());
        if let Some((node, _)) = missing {
            return Err(format!("there is no node {}", node.label).into());
        }
        let somewhere = points[0].or(points[1]).ok_or("both of its ends are the ground")?;
        let at = points.map(|point| point.unwrap_or(somewhere));
        if ends[0] == ends[1] {
            return Err(format!("both ends of connector {} belong to one body", id.label).into());
        }
        if matches!(kind, Kind::Spring(Spring { length: None, .. })) && at[0] == at[1] {
            return Err(format!(
                "the ends of connector {} are in one place: a spring has a length",
                id.label
            )
            .into());
        }
        let name = bodies::plain(&section.elements);
        let name = if ids.len() > 1 { format!("{name}-{}", id.label) } else { name };
        found.push(Joint {
            name,
            block: section.block,
            element: *id,
            ends,
            is_reversed: false,
            at,
            pivot: at[1],
            kind: kind.clone(),
            torque: None,
        });
    }
    Ok(found)
}
