//! Nodes and elements.

use crate::block::{Block, Row, Wrong, label};
use crate::model::{Element, Id};
use crate::state::{Read, State, Verdict};

pub(super) fn read(state: &mut State, number: usize, block: &Block) -> Read {
    if state.is_in_step {
        return Err("nodes and elements are given before the first step".into());
    }
    state.region().blocks.push(number);
    if block.keyword == "NODE" { nodes(state, block) } else { elements(state, block) }
}

fn nodes(state: &mut State, block: &Block) -> Read {
    if block.word("SYSTEM").is_some_and(|system| system != "R") {
        return Err("cylindrical and spherical coordinates are not read".into());
    }
    let set = block.word("NSET");
    let (system, moved) = (state.system, state.moved);
    for row in &block.rows {
        let label = row.label(0)?;
        let mut point = [0.0; 3];
        for (axis, value) in point.iter_mut().enumerate() {
            *value = row.number(axis + 1)?.unwrap_or(0.0);
        }
        let point = moved.point(system.map_or(point, |system| system.point(point)));
        if state.region().nodes.insert(label, point).is_some_and(|before| before != point) {
            return Err(Wrong::at(row.place, format!("node {label} is there already, in another place")));
        }
        state.grow(1)?;
        join(state, set.as_deref(), true, label)?;
    }
    Ok(Verdict::Settled("nodes"))
}

/// Adds a node or an element to a set.
pub(super) fn join(state: &mut State, set: Option<&str>, is_node: bool, label: u32) -> Result<(), Wrong> {
    let Some(set) = set else { return Ok(()) };
    state.grow(1)?;
    let id = state.id(label);
    let region = state.region();
    let sets = if is_node { &mut region.node_sets } else { &mut region.element_sets };
    match sets.get_mut(set) {
        Some(ids) => ids.push(id),
        None => drop(sets.insert(set.to_owned(), vec![id])),
    }
    Ok(())
}

/// Number of nodes of an element.
fn size(kind: &str) -> Option<usize> {
    let words = [
        (20, &["C3D20"][..]),
        (15, &["C3D15"]),
        (10, &["C3D10"]),
        (8, &["EC3D8", "C3D8"]),
        (6, &["C3D6"]),
        (4, &["C3D4", "R3D4", "S4", "SFM3D4", "M3D4"]),
        (3, &["R3D3", "S3", "SFM3D3", "M3D3"]),
        (2, &["CONN3D2", "SPRINGA"]),
        (1, &["MASS", "ROTARYI"]),
    ];
    words
        .iter()
        .find(|(_, kinds)| kinds.iter().any(|known| kind == *known || is_variant(kind, known)))
        .map(|(n, _)| *n)
}

/// Whether a type is a known one with letters for its integration.
fn is_variant(kind: &str, known: &str) -> bool {
    kind.strip_prefix(known)
        .is_some_and(|rest| ["R", "RS", "I", "H", "RH", "RT", "T", "RSH", "M"].contains(&rest))
}

fn elements(state: &mut State, block: &Block) -> Read {
    let kind = block.required("TYPE")?;
    let size = size(&kind).ok_or_else(|| format!("elements of type {kind} are not read: solids, shells and rigid faces in three dimensions were expected"))?;
    let set = block.word("ELSET");
    let mut rows = block.rows.iter();
    while let Some(row) = rows.next() {
        let mut fields: Vec<&str> = row.fields();
        if size == 2 && fields.len() == 2 {
            // The second end of a connector is the ground.
            fields.push("");
        }
        // A line that ends in a comma goes on in the next.
        while fields.len() < size + 1 && fields.len() > 1 {
            let Some(next) = rows.next() else { break };
            fields.extend(next.fields());
        }
        let expected = || Wrong::at(row.place, format!("a label and {size} nodes of a {kind} were expected"));
        if fields.len() != size + 1 {
            return Err(expected());
        }
        let label = label(fields[0]).ok_or_else(expected)?;
        let nodes = fields[1..].iter().map(|field| node(state, field)).collect::<Option<_>>();
        add(state, label, Element { kind: kind.clone(), nodes: nodes.ok_or_else(expected)? }, row)?;
        join(state, set.as_deref(), false, label)?;
    }
    Ok(Verdict::Settled("elements"))
}

/// Adds an element.
pub(super) fn add(state: &mut State, label: u32, element: Element, row: &Row) -> Result<(), Wrong> {
    state.grow(1)?;
    let before = state.region().elements.insert(label, element.clone());
    if before.is_some_and(|before| before != element) {
        return Err(Wrong::at(row.place, format!("element {label} is there already, and is another")));
    }
    Ok(())
}

/// The node that an element names: a label, or in the assembly `INSTANCE.LABEL`; a connector's ground is 0.
pub(super) fn node(state: &State, field: &str) -> Option<Id> {
    match field.rsplit_once('.') {
        Some((instance, number)) => {
            let name = instance.to_uppercase();
            let region = state.deck.regions.iter().position(|region| region.name == name)?;
            Some(Id { region, label: label(number)? })
        }
        None if ["", "0"].contains(&field) => Some(Id { region: state.number(), label: 0 }),
        None => Some(state.id(label(field)?)),
    }
}
