//! Nodes between nodes, and elements beside elements.

use crate::block::{Block, Row, Wrong, label};
use crate::mesh::{add, join};
use crate::model::{Element, Id};
use crate::state::{Read, State, Verdict};

pub(super) fn read(state: &mut State, number: usize, block: &Block) -> Read {
    state.region().blocks.push(number);
    match block.keyword.as_str() {
        "NGEN" => between(state, block),
        "NFILL" => fill(state, block),
        _ => elements(state, block),
    }
}

/// A whole number in a field, 1 where it is empty.
fn count(row: &Row, field: usize) -> Result<u32, Wrong> {
    match row.field(field) {
        "" => Ok(1),
        text => {
            label(text).ok_or_else(|| Wrong::at(row.place, format!("{text:?} is no whole number above 0")))
        }
    }
}

fn position(state: &mut State, label: u32, row: &Row) -> Result<[f64; 3], Wrong> {
    let found = state.region().nodes.get(&label).copied();
    found.ok_or_else(|| Wrong::at(row.place, format!("there is no node {label}")))
}

/// Nodes between the nodes of two labels, in a straight line: first, last, step of the label.
fn between(state: &mut State, block: &Block) -> Read {
    if block.has("LINE") {
        return Err("only straight lines are generated".into());
    }
    let set = block.word("NSET");
    for row in &block.rows {
        let (first, last, step) = (row.label(0)?, row.label(1)?, count(row, 2)?);
        let ends = [position(state, first, row)?, position(state, last, row)?];
        let wide = last.checked_sub(first).filter(|width| width.is_multiple_of(step) && *width > 0);
        let pieces =
            wide.ok_or_else(|| Wrong::at(row.place, "the labels do not go up in whole steps"))? / step;
        state.grow(pieces as usize)?;
        for piece in 0..=pieces {
            let new = first + piece * step;
            if piece > 0 && piece < pieces {
                let point = along(ends, f64::from(piece) / f64::from(pieces));
                state.region().nodes.insert(new, point);
            }
            join(state, set.as_deref(), true, new)?;
        }
    }
    Ok(Verdict::Settled("nodes"))
}

fn along([from, to]: [[f64; 3]; 2], share: f64) -> [f64; 3] {
    [0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * share)
}

/// Nodes between those of two sets: the sets, number of intervals, step of the label. `BIAS` is the ratio of
/// neighbouring intervals.
fn fill(state: &mut State, block: &Block) -> Read {
    let bias = match block.value("BIAS") {
        None => 1.0,
        Some(text) => crate::block::number(text)
            .filter(|bias| (0.1..=10.0).contains(bias))
            .ok_or("BIAS from 0.1 to 10")?,
    };
    let set = block.word("NSET");
    for row in &block.rows {
        let names = [row.field(0).to_uppercase(), row.field(1).to_uppercase()];
        let sets = names.map(|name| state.region().node_sets.get(&name).cloned());
        let [Some(from), Some(to)] = sets else {
            return Err(Wrong::at(row.place, "two node sets were expected"));
        };
        let (pieces, step) = (count(row, 2)?, count(row, 3)?);
        if from.len() != to.len() {
            return Err(Wrong::at(row.place, "the two sets have different numbers of nodes"));
        }
        state.grow(from.len().saturating_mul(pieces as usize))?;
        // Interval n has bias^-n of the first, so that they shrink towards the second set with a
        // bias above 1.
        let widths: Vec<f64> = (0..pieces).map(|n| bias.powf(-f64::from(n))).collect();
        let total: f64 = widths.iter().sum();
        for (a, b) in from.iter().zip(&to) {
            let far = u64::from(a.label) + u64::from(pieces) * u64::from(step);
            if far != u64::from(b.label) {
                let message =
                    format!("from node {} the steps lead to {far}, not to node {}", a.label, b.label);
                return Err(Wrong::at(row.place, message));
            }
            let ends = [position(state, a.label, row)?, position(state, b.label, row)?];
            let mut share = 0.0;
            for piece in 0..=pieces {
                let new = piece.checked_mul(step).and_then(|by| a.label.checked_add(by));
                let new = new.ok_or_else(|| Wrong::at(row.place, "labels beyond what is counted"))?;
                if piece > 0 && piece < pieces {
                    state.region().nodes.insert(new, along(ends, share / total));
                }
                share += widths.get(piece as usize).copied().unwrap_or(0.0);
                join(state, set.as_deref(), true, new)?;
            }
        }
    }
    Ok(Verdict::Settled("nodes"))
}

/// Copies of an element in up to three directions: the element, and for each direction number, step of nodes,
/// step of elements.
fn elements(state: &mut State, block: &Block) -> Read {
    let set = block.word("ELSET");
    for row in &block.rows {
        let first = row.label(0)?;
        let missing = || Wrong::at(row.place, format!("there is no element {first}"));
        let template = state.region().elements.get(&first).cloned().ok_or_else(missing)?;
        let mut directions = [[1; 3]; 3];
        for (at, direction) in directions.iter_mut().enumerate() {
            *direction = [count(row, 1 + 3 * at)?, count(row, 2 + 3 * at)?, count(row, 3 + 3 * at)?];
        }
        let total = directions.iter().try_fold(1_usize, |total, d| total.checked_mul(d[0] as usize));
        state.grow(total.unwrap_or(usize::MAX))?;
        for number in 0..total.unwrap_or(0) {
            copy(state, (first, &template), &directions, number, row)?;
            let [_, elements] = steps(&directions, number);
            join(state, set.as_deref(), false, first.saturating_add(elements))?;
        }
    }
    Ok(Verdict::Settled("elements"))
}

/// How far the labels of nodes and elements of copy `number` are from those of the first.
fn steps(directions: &[[u32; 3]; 3], number: usize) -> [u32; 2] {
    let mut rest = number;
    let mut far = [0_u32; 2];
    for [times, node, element] in directions {
        let at = u32::try_from(rest % *times as usize).unwrap_or(0);
        rest /= *times as usize;
        far[0] = far[0].saturating_add(at.saturating_mul(*node));
        far[1] = far[1].saturating_add(at.saturating_mul(*element));
    }
    far
}

fn copy(
    state: &mut State,
    template: (u32, &Element),
    directions: &[[u32; 3]; 3],
    number: usize,
    row: &Row,
) -> Result<(), Wrong> {
    let [far, element] = steps(directions, number);
    let nodes = template.1.nodes.iter().map(|id| Id { label: id.label.saturating_add(far), ..*id }).collect();
    add(state, template.0.saturating_add(element), Element { kind: template.1.kind.clone(), nodes }, row)
}
