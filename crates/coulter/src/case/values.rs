//! From a value of the tree to a value of the kind that its key requires, in SI units; or what is wrong with it.

use super::format;
use super::keys::Kind;
use super::keys::words::{MOTION_KEYS, WALLS};
use super::names::nearest;
use super::problem::{Location, Problems};
use super::quantity::{self, Measure, TIME};
use super::tree::{Entry, Node, Value};
use super::typed::{Given, Motion, Typed};
use super::unknown::unknown;
use std::ops::RangeInclusive;

/// A value that is not of the kind that its key requires.
struct Complaint {
    location: Location,
    message: String,
    cure: String,
}

type Read<T> = Result<T, Complaint>;

/// The value in its kind, or `Broken` with a problem added.
pub(super) fn value(node: &Node, kind: &Kind, path: &str, problems: &mut Problems) -> Given {
    let read = match kind {
        Kind::Text => text(node).map(|t| Given::Text(t.to_owned())),
        Kind::Format => {
            format::check(node, problems);
            return Given::Number(f64::from(format::FORMAT));
        }
        Kind::Number => number(node).map(Given::Number),
        Kind::Count => count(node).map(Given::Number),
        Kind::Flag => flag(node).map(Given::Flag),
        Kind::Quantity(measure) => quantity(node, measure).map(Given::Number),
        Kind::Choice(words) => current_word(node, path).and_then(|()| choice(node, words)).map(Given::Text),
        Kind::Modulus(offset) => modulus(node, *offset).map(Given::Number),
        Kind::Friction => friction(node).map(Given::Number),
        Kind::Range(measure) => list(node, measure, 2..=2).map(Given::List),
        Kind::Vector(measure) => list(node, measure, 2..=3).map(Given::List),
        Kind::WallPair => walls(node).map(Given::Words),
        Kind::Motion { still, speed, load } => {
            return motion(node, still, [speed, load], path, problems);
        }
    };
    read.unwrap_or_else(|complaint| {
        problems.add(&complaint.location, format!("{path}: {}", complaint.message), complaint.cure);
        Given::Broken
    })
}

fn complain<T>(node: &Node, message: impl Into<String>, cure: impl Into<String>) -> Read<T> {
    Err(Complaint { location: node.location.clone(), message: message.into(), cure: cure.into() })
}

fn wrong_type<T>(node: &Node, expected: &str, cure: impl Into<String>) -> Read<T> {
    complain(node, format!("expected {expected}, found {}", node.value.kind()), cure)
}

fn text(node: &Node) -> Read<&str> {
    match &node.value {
        Value::Text(text) => Ok(text),
        _ => wrong_type(node, "text", "put it in quotes"),
    }
}

fn number(node: &Node) -> Read<f64> {
    match node.value {
        Value::Integer(n) => Ok(n as f64),
        Value::Number(n) if n.is_finite() => Ok(n),
        Value::Number(_) => complain(node, "must be a finite number", "give an ordinary number, such as 0.3"),
        Value::Text(_) => {
            wrong_type(node, "a number", "it has no unit: write it without quotes, such as 0.3")
        }
        _ => wrong_type(node, "a number", "write it such as 0.3"),
    }
}

fn count(node: &Node) -> Read<f64> {
    match node.value {
        Value::Integer(n) if (0..=65536).contains(&n) => Ok(n as f64),
        Value::Integer(n) => {
            complain(node, format!("{n} is out of range"), "give a whole number from 0 to 65536")
        }
        _ => wrong_type(node, "a whole number", "write it such as 4, without quotes or decimals"),
    }
}

fn flag(node: &Node) -> Read<bool> {
    match node.value {
        Value::Flag(flag) => Ok(flag),
        _ => wrong_type(node, "true or false", "write true or false, without quotes"),
    }
}

fn quantity(node: &Node, measure: &Measure) -> Read<f64> {
    let Measure { name, example, .. } = measure;
    let cure = format!("write {name} with its unit, such as \"{example}\"");
    match &node.value {
        Value::Text(text) => quantity::parse(text, measure).or_else(|e| complain(node, e.to_string(), cure)),
        Value::Integer(_) | Value::Number(_) => {
            complain(node, format!("expected {name}; a bare number has no unit"), cure)
        }
        _ => wrong_type(node, name, cure),
    }
}

fn modulus(node: &Node, offset: i32) -> Read<f64> {
    let cure =
        format!("write it with its unit, such as \"102 kN/m^(n+{offset})\"; `n` stands for sinkage_exponent");
    match &node.value {
        Value::Text(text) => {
            quantity::parse_modulus(text, offset).or_else(|e| complain(node, e.to_string(), cure))
        }
        Value::Integer(_) | Value::Number(_) => complain(node, "a bare number has no unit", cure),
        _ => wrong_type(node, "a modulus", cure),
    }
}

fn choice(node: &Node, words: &[&str]) -> Read<String> {
    let all = words.iter().map(|w| format!("\"{w}\"")).collect::<Vec<_>>().join(", ");
    let Value::Text(text) = &node.value else {
        return wrong_type(node, "a word", format!("write one of {all}"));
    };
    if words.contains(&text.as_str()) {
        return Ok(text.clone());
    }
    let hint =
        nearest(text, words.iter().copied()).map_or(String::new(), |n| format!("did you mean \"{n}\"? "));
    complain(node, format!("\"{text}\" is not one of the possible words"), format!("{hint}possible: {all}"))
}

/// Refuses a word that has been replaced, with the one to write instead.
fn current_word(node: &Node, path: &str) -> Read<()> {
    let Value::Text(text) = &node.value else { return Ok(()) };
    match format::new_value(path, text) {
        Some(new) => {
            complain(node, format!("\"{text}\" is now called \"{new}\""), format!("write \"{new}\""))
        }
        None => Ok(()),
    }
}

fn friction(node: &Node) -> Read<f64> {
    match &node.value {
        Value::Text(text) if text == "rough" => Ok(f64::INFINITY),
        Value::Integer(_) | Value::Number(_) => number(node),
        _ => wrong_type(
            node,
            "a number or \"rough\"",
            "write a coefficient such as 0.3, or \"rough\" for no slip",
        ),
    }
}

fn list(node: &Node, measure: &Measure, lengths: RangeInclusive<usize>) -> Read<Vec<Typed<f64>>> {
    let Measure { name, example, .. } = measure;
    let (min, max) = (*lengths.start(), *lengths.end());
    let count = if min == max { format!("{min}") } else { format!("{min} or {max}") };
    let cure =
        format!("write [{}], each {name} with its unit", vec![format!("\"{example}\""); max].join(", "));
    let Value::List(items) = &node.value else {
        return wrong_type(node, &format!("a list of {count} quantities"), cure);
    };
    if !lengths.contains(&items.len()) {
        return complain(node, format!("expected {count} values, found {}", items.len()), cure);
    }
    items
        .iter()
        .map(|item| Ok(Typed { value: quantity(item, measure)?, location: item.location.clone() }))
        .collect()
}

fn walls(node: &Node) -> Read<Vec<String>> {
    match &node.value {
        Value::List(items) if items.len() == 2 => items.iter().map(|item| choice(item, &WALLS)).collect(),
        _ => {
            complain(node, "expected two walls, at the low and the high end", "write [\"smooth\", \"fixed\"]")
        }
    }
}

/// A word (`still` or `free`), or a table with a speed or a load.
fn motion(
    node: &Node,
    still: &'static str,
    measures: [&Measure; 2],
    path: &str,
    problems: &mut Problems,
) -> Given {
    match &node.value {
        Value::Table(table) => motion_table(table, measures, path, problems),
        _ => match choice(node, &[still, "free"]) {
            Ok(word) => Given::Motion(Motion { word: Some(word), ..Motion::default() }),
            Err(complaint) => {
                let cure = format!(
                    "write \"{still}\", \"free\", {{ speed = \"{}\" }} or {{ load = \"{}\" }}",
                    measures[0].example, measures[1].example
                );
                problems.add(&complaint.location, format!("{path}: {}", complaint.message), cure);
                Given::Broken
            }
        },
    }
}

fn motion_table(table: &[Entry], [speed, load]: [&Measure; 2], path: &str, problems: &mut Problems) -> Given {
    let mut motion = Motion::default();
    let before = problems.len();
    for entry in table {
        let (field, measure) = match entry.key.as_str() {
            "speed" => (&mut motion.speed, speed),
            "load" => (&mut motion.load, load),
            "start" => (&mut motion.start, &TIME),
            "ramp" => (&mut motion.ramp, &TIME),
            "end" => (&mut motion.end, &TIME),
            _ => {
                unknown(entry, path, MOTION_KEYS.into_iter(), problems);
                continue;
            }
        };
        match quantity(&entry.node, measure) {
            Ok(value) => *field = Some(Typed { value, location: entry.node.location.clone() }),
            Err(c) => problems.add(&c.location, format!("{path}.{}: {}", entry.key, c.message), c.cure),
        }
    }
    if problems.len() == before { Given::Motion(motion) } else { Given::Broken }
}
