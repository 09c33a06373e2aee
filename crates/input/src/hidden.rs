//! Invisible characters in what was typed: they have no use there, and would act on terminals and pages.

use super::problem::{Aim, Problem};
use super::tree::{Entry, Value, join};
use crate::printed::is_hidden;

/// A problem for every name and every text that holds one; of a title, for a line break, too.
pub fn problems(tree: &[Entry]) -> Vec<(Aim, Problem)> {
    let mut found = Vec::new();
    walk(tree, "", &mut found);
    found
}

fn walk(entries: &[Entry], path: &str, found: &mut Vec<(Aim, Problem)>) {
    for Entry { key, value } in entries {
        let path = join(path, key);
        look(key, true, &path, Aim::Name, found);
        look_into(value, key == "title", &path, found);
    }
}

fn look_into(value: &Value, is_line: bool, path: &str, found: &mut Vec<(Aim, Problem)>) {
    match value {
        Value::Text(text) => look(text, is_line, path, Aim::Value, found),
        Value::Table(entries) => walk(entries, path, found),
        Value::List(values) => {
            for (n, value) in values.iter().enumerate() {
                look_into(value, false, &format!("{path}[{n}]"), found);
            }
        }
        Value::Integer(_) | Value::Number(_) | Value::Flag(_) | Value::Other(_) => {}
    }
}

fn look(text: &str, is_line: bool, path: &str, aim: Aim, found: &mut Vec<(Aim, Problem)>) {
    let hidden = text.chars().position(|c| is_hidden(c) || is_line && c.is_control());
    if let Some((place, c)) = hidden.and_then(|place| Some((place, text.chars().nth(place)?))) {
        let what = if c.is_control() { "a control character" } else { "a mark for the direction of text" };
        let message = format!("character {} is {what}, U+{:04X}", place + 1, u32::from(c));
        found.push((aim, Problem::new(path, message, "leave it out; it may have been copied unseen")));
    }
}
