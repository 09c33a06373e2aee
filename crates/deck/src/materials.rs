//! Materials, and tables that others refer to by name.

use crate::block::{Block, Row, Wrong};
use crate::model::{Amplitude, Interaction, Material, Pairing, Periodic, Property};
use crate::state::{Read, State, Verdict};
use std::collections::BTreeMap;

pub(super) fn read(state: &mut State, number: usize, block: &Block) -> Read {
    if block.keyword == "MATERIAL" {
        let name = block.required("NAME")?;
        if state.deck.materials.iter().any(|material| material.name == name) {
            return Err(format!("there are two materials {name}").into());
        }
        state.material = Some(state.deck.materials.len());
        state.deck.materials.push(Material { name, block: number, properties: BTreeMap::new() });
        return Ok(Verdict::Pending);
    }
    let open = state.material.and_then(|at| state.deck.materials.get_mut(at));
    let material = open.ok_or("no material is open")?;
    let rows = block.rows.iter().map(Row::numbers).collect::<Result<_, _>>()?;
    let property = Property { block: number, rows };
    if material.properties.insert(block.keyword.clone(), property).is_some() {
        return Err(format!("material {} has it twice", material.name).into());
    }
    Ok(Verdict::Pending)
}

/// Amplitudes, interactions, contact, initial conditions.
pub(super) fn tables(state: &mut State, number: usize, block: &Block) -> Read {
    match block.keyword.as_str() {
        "AMPLITUDE" => amplitude(state, number, block),
        "SURFACE INTERACTION" => {
            let name = block.required("NAME")?;
            state.interaction = Some(state.deck.interactions.len());
            state.deck.interactions.push(Interaction { name, block: number, ..Interaction::default() });
            Ok(Verdict::Pending)
        }
        "FRICTION" => friction(state, number, block),
        "CONTACT PAIR" => {
            let interaction = block.required("INTERACTION")?;
            pair(state, number, block, |_| Ok(interaction.clone()))
        }
        "CONTACT PROPERTY ASSIGNMENT" => pair(state, number, block, |row| match row.field(2) {
            "" => Err(Wrong::at(row.place, "two surfaces and an interaction were expected")),
            name => Ok(name.to_uppercase()),
        }),
        _ => {
            state.deck.initial.push((number, block.required("TYPE")?));
            Ok(Verdict::Pending)
        }
    }
}

/// Connector behaviours and their tables.
pub(super) fn connectors(state: &mut State, number: usize, block: &Block) -> Read {
    // Friction that follows is that of the connector.
    state.interaction = None;
    if block.keyword == "CONNECTOR BEHAVIOR" {
        let name = block.required("NAME")?;
        if state.deck.behaviours.insert(name.clone(), vec![number]).is_some() {
            return Err(format!("there are two connector behaviours {name}").into());
        }
        state.behaviour = Some(name);
        return Ok(Verdict::Pending);
    }
    let open = state.behaviour.as_ref().and_then(|name| state.deck.behaviours.get_mut(name));
    open.ok_or("no connector behaviour is open")?.push(number);
    Ok(Verdict::Pending)
}

fn pair(state: &mut State, number: usize, block: &Block, of: impl Fn(&Row) -> Result<String, Wrong>) -> Read {
    for row in &block.rows {
        let surfaces = [row.field(0).to_uppercase(), row.field(1).to_uppercase()];
        state.deck.pairings.push(Pairing { block: number, surfaces, interaction: of(row)? });
    }
    Ok(Verdict::Pending)
}

fn friction(state: &mut State, number: usize, block: &Block) -> Read {
    let open = state.interaction.and_then(|at| state.deck.interactions.get_mut(at));
    let interaction = open.ok_or("no surface interaction is open")?;
    let row = block.rows.first();
    let coefficient = match (block.has("ROUGH"), row) {
        (true, _) => f64::INFINITY,
        (false, Some(row)) => row.number(0)?.unwrap_or(0.0),
        (false, None) => return Err("a coefficient of friction was expected".into()),
    };
    if coefficient < 0.0 || block.rows.len() > 1 || row.is_some_and(|row| row.fields().len() > 1) {
        return Err("one coefficient of friction of 0 or more was expected, not one that varies".into());
    }
    interaction.friction = Some((number, coefficient));
    interaction.most_shear = match block.value("TAUMAX") {
        Some(text) => Some(crate::block::number(text).ok_or("TAUMAX= is no number")?),
        None => None,
    };
    Ok(Verdict::Pending)
}

fn amplitude(state: &mut State, number: usize, block: &Block) -> Read {
    let name = block.required("NAME")?;
    let definition = block.word("DEFINITION").unwrap_or_else(|| "TABULAR".to_owned());
    let is_total_time = block.word("TIME").is_some_and(|time| time == "TOTAL TIME");
    if block.word("VALUE").is_some_and(|value| value != "RELATIVE") {
        return Err("absolute values of an amplitude are not read".into());
    }
    let mut numbers = Vec::new();
    for row in &block.rows {
        numbers.extend(row.numbers()?);
    }
    if definition == "PERIODIC" {
        let periodic = Some(periodic(&block.rows)?);
        let amplitude = Amplitude { block: number, definition, is_total_time, points: Vec::new(), periodic };
        state.deck.amplitudes.insert(name, amplitude);
        return Ok(Verdict::Pending);
    }
    let points = match definition.as_str() {
        "TABULAR" | "SMOOTH STEP" if numbers.len() >= 2 && numbers.len().is_multiple_of(2) => {
            numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
        }
        "EQUALLY SPACED" => {
            let step =
                block.value("FIXED INTERVAL").and_then(crate::block::number).filter(|step| *step > 0.0);
            let step = step.ok_or("FIXED INTERVAL= above 0 is missing")?;
            let begin =
                block.value("BEGIN").map_or(Some(0.0), crate::block::number).ok_or("BEGIN= is no number")?;
            numbers.iter().enumerate().map(|(n, value)| [begin + step * n as f64, *value]).collect()
        }
        "TABULAR" | "SMOOTH STEP" => return Err("pairs of a time and a value were expected".into()),
        _ => return Err(format!("amplitudes of definition {definition} are not read").into()),
    };
    if points.len() < 2 || points.windows(2).any(|pair| pair[1][0] <= pair[0][0]) {
        return Err("two times or more that increase were expected".into());
    }
    let amplitude = Amplitude { block: number, definition, is_total_time, points, periodic: None };
    state.deck.amplitudes.insert(name, amplitude);
    Ok(Verdict::Pending)
}

/// Number of terms, frequency, start and mean; then pairs of factors of cosine and sine.
fn periodic(rows: &[Row]) -> Result<Periodic, Wrong> {
    let [first, rest @ ..] = rows else { return Err("a line with the frequency was expected".into()) };
    let get = |field: usize| first.number(field).map(Option::unwrap_or_default);
    let (count, frequency) = (get(0)?, get(1)?);
    let mut factors = Vec::new();
    for row in rest {
        factors.extend(
            (0..row.fields().len().next_multiple_of(2))
                .map(|n| row.number(n))
                .collect::<Result<Vec<_>, _>>()?,
        );
    }
    let terms: Vec<[f64; 2]> = factors
        .chunks_exact(2)
        .map(|pair| [pair[0].unwrap_or_default(), pair[1].unwrap_or_default()])
        .collect();
    if frequency <= 0.0 || terms.is_empty() || terms.len() as f64 != count {
        let message = "number of terms, circular frequency above 0, start and mean, and then two factors for each term were expected";
        return Err(Wrong::at(first.place, message));
    }
    Ok(Periodic { frequency, start: get(2)?, mean: get(3)?, terms })
}
