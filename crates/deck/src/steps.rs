//! Steps, their procedures, and what acts in them.

use crate::block::{Block, Wrong};
use crate::model::{Action, Step};
use crate::state::{Read, State, Verdict};

pub(super) fn read(state: &mut State, number: usize, block: &Block) -> Read {
    match block.keyword.as_str() {
        "STEP" => {
            if state.is_in_step || state.part.is_some() || state.instance.is_some() {
                return Err("a step begins before what is open has ended".into());
            }
            let count = state.deck.steps.len() + 1;
            let name = block.word("NAME").unwrap_or_else(|| format!("STEP-{count}"));
            state.deck.steps.push(Step { name, block: number, ..Step::default() });
            state.is_in_step = true;
            Ok(Verdict::Pending)
        }
        "END STEP" => {
            if !std::mem::take(&mut state.is_in_step) {
                return Err("no step is open".into());
            }
            Ok(Verdict::Settled("a step"))
        }
        "DYNAMIC" => dynamic(state, number, block),
        _ => action(state, number, block),
    }
}

fn open(state: &mut State) -> Option<&mut Step> {
    if state.is_in_step { state.deck.steps.last_mut() } else { None }
}

fn dynamic(state: &mut State, number: usize, block: &Block) -> Read {
    let step = open(state).ok_or("no step is open")?;
    if !block.has("EXPLICIT") {
        return Err("only *DYNAMIC, EXPLICIT is read".into());
    }
    let row = block.rows.first().ok_or("a line with the duration was expected")?;
    let duration = row.number(1)?.unwrap_or(0.0);
    if duration <= 0.0 {
        return Err(Wrong::at(row.place, "a duration above 0 was expected in the second field"));
    }
    (step.duration, step.procedure) = (duration, Some(number));
    Ok(Verdict::Pending)
}

fn action(state: &mut State, number: usize, block: &Block) -> Read {
    let action = Action {
        block: number,
        rows: block.rows.clone(),
        amplitude: block.word("AMPLITUDE"),
        kind: block.word("TYPE").unwrap_or_else(|| "DISPLACEMENT".to_owned()),
        replaces: block.word("OP").is_some_and(|op| op == "NEW"),
    };
    match open(state) {
        Some(step) => step.actions.push(action),
        None if block.keyword == "BOUNDARY" => state.deck.always.push(action),
        None => return Err("a load acts in a step, and none is open".into()),
    }
    Ok(Verdict::Pending)
}
