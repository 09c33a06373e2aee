//! Sets of nodes and elements.

use crate::block::{Block, Row, Wrong, label};
use crate::model::Id;
use crate::state::{Read, State, Verdict};

pub(super) fn read(state: &mut State, number: usize, block: &Block) -> Read {
    let is_node = block.keyword == "NSET";
    let name = block.required(if is_node { "NSET" } else { "ELSET" })?;
    // What a set is for is no matter here.
    let _ = (block.has("INTERNAL"), block.has("UNSORTED"));
    let instance = block.word("INSTANCE");
    let mut found = Vec::new();
    if let (true, Some(elements)) = (is_node, block.word("ELSET")) {
        found = nodes_of(state, &elements)?;
    }
    for row in &block.rows {
        let new = if block.has("GENERATE") {
            generated(state, instance.as_deref(), row)?
        } else {
            listed(state, instance.as_deref(), row, is_node)?
        };
        state.grow(new.len())?;
        found.extend(new);
    }
    let region = state.region();
    region.blocks.push(number);
    let sets = if is_node { &mut region.node_sets } else { &mut region.element_sets };
    sets.entry(name).or_default().extend(found);
    Ok(Verdict::Settled("a set"))
}

/// The number of an instance by its name; the region that is open where none is given.
fn region(state: &State, instance: Option<&str>, row: &Row) -> Result<usize, Wrong> {
    let Some(instance) = instance else { return Ok(state.number()) };
    let number =
        state.deck.regions.iter().position(|region| !region.name.is_empty() && region.name == instance);
    number.ok_or_else(|| Wrong::at(row.place, format!("there is no instance {instance}")))
}

/// First, last and step of labels.
fn generated(state: &mut State, instance: Option<&str>, row: &Row) -> Result<Vec<Id>, Wrong> {
    let region = region(state, instance, row)?;
    let (first, last) = (row.label(0)?, row.label(1)?);
    let step = if row.field(2).is_empty() { 1 } else { row.label(2)? };
    if last < first {
        return Err(Wrong::at(row.place, "the last label is below the first"));
    }
    let count = (last - first) / step;
    state.grow(count as usize)?;
    Ok((0..=count).map(|n| Id { region, label: first + n * step }).collect())
}

/// Labels, and names of other sets.
fn listed(state: &mut State, instance: Option<&str>, row: &Row, is_node: bool) -> Result<Vec<Id>, Wrong> {
    let region = region(state, instance, row)?;
    let mut found = Vec::new();
    for field in row.fields() {
        if let Some(label) = label(field) {
            found.push(Id { region, label });
            continue;
        }
        let missing = || Wrong::at(row.place, format!("{field:?} is neither a label nor a set"));
        let set = other(state, instance, field, is_node).ok_or_else(missing)?;
        found.extend(set);
        state.grow(found.len())?;
    }
    Ok(found)
}

fn other(state: &mut State, instance: Option<&str>, field: &str, is_node: bool) -> Option<Vec<Id>> {
    let name = field.to_uppercase();
    if let Some(instance) = instance {
        let name = format!("{instance}.{name}");
        return if is_node { state.deck.nodes(0, &name) } else { state.deck.elements(0, &name) };
    }
    if name.contains('.') {
        return if is_node { state.deck.nodes(0, &name) } else { state.deck.elements(0, &name) };
    }
    let region = state.region();
    if is_node { region.node_sets.get(&name) } else { region.element_sets.get(&name) }.cloned()
}

/// All nodes of the elements of a set.
fn nodes_of(state: &mut State, elements: &str) -> Result<Vec<Id>, Wrong> {
    let region = state.region();
    let ids =
        region.element_sets.get(elements).ok_or_else(|| format!("there is no element set {elements}"))?;
    let own = ids.iter().filter_map(|id| region.elements.get(&id.label));
    let mut nodes: Vec<Id> = own.flat_map(|element| element.nodes.iter().copied()).collect();
    nodes.sort_unstable();
    nodes.dedup();
    state.grow(nodes.len())?;
    Ok(nodes)
}
