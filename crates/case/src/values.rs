//! From a value of the tree to a value of the kind that its key requires, in SI units; or what is wrong with
//! it.

use super::format;
use super::key::words::{DENSITIES, ORIGINS, WALLS};
use super::keys::{self, DefaultValue, FOLLOW, Key, Kind, MOTION, UNTIL};
use input::names::nearest;
use input::problem::Problems;
use input::quantity::{self, Measure, TIME};
use input::tree::{Entry, Value, join};
use input::typed::{Given, Motion, Until};
use input::unknown::unknown;
use std::ops::RangeInclusive;

/// A value that is not of the kind that its key requires.
struct Complaint {
    /// Number of the wrong element of a list.
    element: Option<usize>,
    message: String,
    cure: String,
}

type Read<T> = Result<T, Complaint>;

/// The value in its kind and in the range of its key, or `Broken` with a problem added.
pub(super) fn value(node: &Value, kind: &Kind, path: &str, problems: &mut Problems) -> Given {
    let read = match kind {
        Kind::Text => text(node).map(|t| Given::Text(t.to_owned())),
        Kind::Format => {
            format::check(node, problems);
            return Given::Number(f64::from(format::FORMAT));
        }
        Kind::Number => number(node).map(Given::Number),
        Kind::Ratios => numbers(node, 3, "three numbers without units, along x, y and z, such as [3, 3, 1]")
            .map(Given::List),
        Kind::Interval => {
            numbers(node, 2, "two numbers without units, low and high, such as [0.3, 0.5]").map(Given::List)
        }
        Kind::Count => count(node).map(Given::Number),
        Kind::Flag => flag(node).map(Given::Flag),
        Kind::Quantity(measure) => quantity(node, measure).map(Given::Number),
        Kind::Choice(words) => choice(node, words).map(Given::Text),
        Kind::Modulus(offset) => modulus(node, *offset).map(Given::Number),
        Kind::Friction => friction(node).map(Given::Number),
        Kind::RelativeDensity => relative_density(node).map(Given::Number),
        Kind::Range(measure) => list(node, measure, 2..=2).map(Given::List),
        Kind::Vector(measure) => list(node, measure, 2..=3).map(Given::List),
        Kind::NamePair => names(node).map(Given::Words),
        Kind::Choices(words) => choices(node, words).map(Given::Words),
        Kind::Names => any_names(node).map(Given::Words),
        Kind::Values => values(node).map(Given::AsTyped),
        Kind::Assignments => assignments(node).map(Given::AsTyped),
        Kind::WallPair => walls(node).map(Given::Words),
        Kind::Follow => return follow(node, path, problems),
        Kind::Until => return until(node, path, problems),
        Kind::Motion { still, way, speed, load } => {
            return motion(node, still, [way, speed, load], path, problems);
        }
    };
    match read {
        Ok(given) if fits(&given, path, problems) => given,
        Ok(_) => Given::Broken,
        Err(complaint) => {
            let at = complaint.element.map_or_else(|| path.to_owned(), |n| format!("{path}[{n}]"));
            problems.add(at, format!("{path}: {}", complaint.message), complaint.cure);
            Given::Broken
        }
    }
}

/// Whether every number is in the range of its key.
fn fits(given: &Given, path: &str, problems: &mut Problems) -> bool {
    match given {
        Given::Number(number) => in_range(path, *number, problems),
        Given::List(numbers) => {
            let outside = |(n, number): (usize, &f64)| !in_range(&format!("{path}[{n}]"), *number, problems);
            numbers.iter().enumerate().map(outside).filter(|is_outside| *is_outside).count() == 0
        }
        _ => true,
    }
}

/// Whether a number that was read, finite or that of `rough`, is in the range of its key; reported if not.
fn in_range(path: &str, number: f64, problems: &mut Problems) -> bool {
    let refusing = keys::at(path).filter(|key| key.range.is_some_and(|range| !range.contains(number)));
    refusing.iter().for_each(|key| key.refuse(path, number, problems));
    refusing.is_none()
}

fn complain<T>(message: impl Into<String>, cure: impl Into<String>) -> Read<T> {
    Err(Complaint { element: None, message: message.into(), cure: cure.into() })
}

fn wrong_type<T>(node: &Value, expected: &str, cure: impl Into<String>) -> Read<T> {
    complain(format!("expected {expected}, found {}", node.kind()), cure)
}

fn text(node: &Value) -> Read<&str> {
    match node {
        Value::Text(text) => Ok(text),
        _ => wrong_type(node, "text", "put it in quotes"),
    }
}

fn number(node: &Value) -> Read<f64> {
    match *node {
        Value::Integer(n) => Ok(n as f64),
        Value::Number(n) if n.is_finite() => Ok(n),
        Value::Number(_) => complain("must be a finite number", "give an ordinary number, such as 0.3"),
        Value::Text(_) => {
            wrong_type(node, "a number", "it has no unit: write it without quotes, such as 0.3")
        }
        _ => wrong_type(node, "a number", "write it such as 0.3"),
    }
}

fn count(node: &Value) -> Read<f64> {
    match *node {
        Value::Integer(n) => Ok(n as f64),
        _ => wrong_type(node, "a whole number", "write it such as 4, without quotes or decimals"),
    }
}

fn flag(node: &Value) -> Read<bool> {
    match *node {
        Value::Flag(flag) => Ok(flag),
        _ => wrong_type(node, "true or false", "write true or false, without quotes"),
    }
}

fn quantity(node: &Value, measure: &Measure) -> Read<f64> {
    let Measure { name, example, .. } = measure;
    let cure = format!("write {name} with its unit, such as \"{example}\"");
    match node {
        Value::Text(text) => quantity::parse(text, measure).or_else(|e| complain(e.to_string(), cure)),
        Value::Integer(_) | Value::Number(_) => {
            complain(format!("expected {name}; a bare number has no unit"), cure)
        }
        _ => wrong_type(node, name, cure),
    }
}

fn modulus(node: &Value, offset: i32) -> Read<f64> {
    let cure =
        format!("write it with its unit, such as \"102 kN/m^(n+{offset})\"; `n` stands for sinkage_exponent");
    match node {
        Value::Text(text) => quantity::parse_modulus(text, offset).or_else(|e| complain(e.to_string(), cure)),
        Value::Integer(_) | Value::Number(_) => complain("a bare number has no unit", cure),
        _ => wrong_type(node, "a modulus", cure),
    }
}

fn choice(node: &Value, words: &[&str]) -> Read<String> {
    let all = words.iter().map(|w| format!("\"{w}\"")).collect::<Vec<_>>().join(", ");
    let Value::Text(text) = node else {
        return wrong_type(node, "a word", format!("write one of {all}"));
    };
    if words.contains(&text.as_str()) {
        return Ok(text.clone());
    }
    let hint =
        nearest(text, words.iter().copied()).map_or(String::new(), |n| format!("did you mean \"{n}\"? "));
    complain(format!("\"{text}\" is not one of the possible words"), format!("{hint}possible: {all}"))
}

fn friction(node: &Value) -> Read<f64> {
    match node {
        Value::Text(text) if text == "rough" => Ok(f64::INFINITY),
        Value::Integer(_) | Value::Number(_) => number(node),
        _ => wrong_type(
            node,
            "a number or \"rough\"",
            "write a coefficient such as 0.3, or \"rough\" for no slip",
        ),
    }
}

fn relative_density(node: &Value) -> Read<f64> {
    let Value::Text(text) = node else { return number(node) };
    let found = DENSITIES.iter().find(|(word, _)| word == text);
    found.map(|(_, density)| *density).map_or_else(
        || {
            let words = DENSITIES.map(|(word, density)| format!("\"{word}\" ({density})")).join(", ");
            complain(
                format!("expected a number or a word, found \"{text}\""),
                format!("write a number such as 0.4, or one of {words}"),
            )
        },
        Ok,
    )
}

fn list(node: &Value, measure: &Measure, lengths: RangeInclusive<usize>) -> Read<Vec<f64>> {
    let Measure { name, example, .. } = measure;
    let (min, max) = (*lengths.start(), *lengths.end());
    let count = if min == max { format!("{min}") } else { format!("{min} or {max}") };
    let cure =
        format!("write [{}], each {name} with its unit", vec![format!("\"{example}\""); max].join(", "));
    let Value::List(items) = node else {
        return wrong_type(node, &format!("a list of {count} quantities"), cure);
    };
    if !lengths.contains(&items.len()) {
        return complain(format!("expected {count} values, found {}", items.len()), cure);
    }
    let element =
        |(n, item)| quantity(item, measure).map_err(|complaint| Complaint { element: Some(n), ..complaint });
    items.iter().enumerate().map(element).collect()
}

/// A list of this many numbers without units, of which `what` says what to write.
fn numbers(node: &Value, count: usize, what: &str) -> Read<Vec<f64>> {
    let cure = format!("write {what}");
    match node {
        Value::List(items) if items.len() == count => {
            let element =
                |(n, item)| number(item).map_err(|complaint| Complaint { element: Some(n), ..complaint });
            items.iter().enumerate().map(element).collect()
        }
        Value::List(items) => complain(format!("expected {count} numbers, found {}", items.len()), cure),
        _ => wrong_type(node, &format!("a list of {count} numbers"), cure),
    }
}

fn names(node: &Value) -> Read<Vec<String>> {
    const CURE: &str = "write two names, such as [\"frame\", \"disc\"]";
    match node {
        Value::List(items) if items.len() == 2 => {
            let element = |(n, item)| {
                text(item).map(str::to_owned).map_err(|complaint| Complaint { element: Some(n), ..complaint })
            };
            items.iter().enumerate().map(element).collect()
        }
        _ => complain("expected the names of two bodies", CURE),
    }
}

/// Words from a list, each at most once; one alone may be written without brackets.
fn choices(node: &Value, words: &[&str]) -> Read<Vec<String>> {
    let alone = [node.clone()];
    let items = if let Value::List(items) = node { items.as_slice() } else { &alone };
    let element =
        |(n, item)| choice(item, words).map_err(|complaint| Complaint { element: Some(n), ..complaint });
    let chosen = items.iter().enumerate().map(element).collect::<Read<Vec<String>>>()?;
    if chosen.is_empty() || (1..chosen.len()).any(|n| chosen[..n].contains(&chosen[n])) {
        let all = words.iter().map(|w| format!("\"{w}\"")).collect::<Vec<_>>().join(", ");
        return complain("expected one or several words, each once", format!("possible: [{all}]"));
    }
    Ok(chosen)
}

/// Names, any number of them.
fn any_names(node: &Value) -> Read<Vec<String>> {
    let Value::List(items) = node else {
        return wrong_type(node, "a list of names", "write it such as [\"phi\", \"weight\"]");
    };
    let element = |(n, item)| {
        text(item).map(str::to_owned).map_err(|complaint| Complaint { element: Some(n), ..complaint })
    };
    items.iter().enumerate().map(element).collect()
}

/// A list of values that are read later.
fn values(node: &Value) -> Read<Value> {
    match node {
        Value::List(items) if !items.is_empty() => Ok(node.clone()),
        Value::List(_) => complain("the list is empty", "give it values, such as [\"30 deg\", \"35 deg\"]"),
        _ => wrong_type(node, "a list of values", "write it such as [\"30 deg\", \"35 deg\"]"),
    }
}

/// A table whose keys are those of a case.
fn assignments(node: &Value) -> Read<Value> {
    match node {
        Value::Table(_) => Ok(node.clone()),
        _ => wrong_type(node, "a table", "write it such as { \"grid.cell\" = \"20 mm\" }"),
    }
}

fn walls(node: &Value) -> Read<Vec<String>> {
    match node {
        Value::List(items) if items.len() == 2 => {
            let element = |(n, item)| {
                choice(item, &WALLS).map_err(|complaint| Complaint { element: Some(n), ..complaint })
            };
            items.iter().enumerate().map(element).collect()
        }
        _ => complain("expected two walls, at the low and the high end", "write [\"smooth\", \"fixed\"]"),
    }
}

/// A table with a body and axes.
fn follow(node: &Value, path: &str, problems: &mut Problems) -> Given {
    let Value::Table(table) = node else {
        let message = format!("{path}: expected a table, found {}", node.kind());
        problems.add(path, message, "write { body = \"disc\", axes = \"x\" }");
        return Given::Broken;
    };
    let before = problems.len();
    let mut words = FOLLOW.keys.iter().map(|key| (key, None)).collect::<Vec<_>>();
    for entry in table {
        let Some((key, word)) = words.iter_mut().find(|(key, _)| key.name == entry.key) else {
            unknown(entry, path, FOLLOW.keys.iter().map(|key| key.name), problems);
            continue;
        };
        if let Given::Text(text) = value(&entry.value, &key.kind, &join(path, key.name), problems) {
            *word = Some(text);
        }
    }
    let word = |(key, word): (&Key, Option<String>)| match (word, key.default) {
        (Some(word), _) => word,
        (None, DefaultValue::Word(word)) => word.to_owned(),
        _ => String::new(),
    };
    if problems.len() == before && words[0].1.is_none() {
        problems.add(path, format!("{path}: `body` is missing"), "write { body = \"disc\", axes = \"x\" }");
    }
    let words: Vec<String> = words.into_iter().map(word).collect();
    match <[String; 2]>::try_from(words) {
        Ok(words) if problems.len() == before => Given::Follow(words),
        _ => Given::Broken,
    }
}

/// A table with a body and one quantity.
fn until(node: &Value, path: &str, problems: &mut Problems) -> Given {
    const CURE: &str = "write { body = \"disc\", sinkage = \"20 mm\" }, with one quantity";
    let Value::Table(table) = node else {
        problems.add(path, format!("{path}: expected a table, found {}", node.kind()), CURE);
        return Given::Broken;
    };
    let before = problems.len();
    let (mut body, mut reached) = (None, Vec::new());
    for entry in table {
        let Some(key) = UNTIL.key(&entry.key) else {
            unknown(entry, path, UNTIL.keys.iter().map(|key| key.name), problems);
            continue;
        };
        match value(&entry.value, &key.kind, &join(path, key.name), problems) {
            Given::Text(name) => body = Some(name),
            Given::Number(number) => reached.push((key.name, number)),
            _ => {}
        }
    }
    if problems.len() > before {
        return Given::Broken;
    }
    match (body, &reached[..]) {
        (Some(body), &[(key, value)]) => Given::Until(Until { body, key, value }),
        (None, _) => {
            problems.add(path, format!("{path}: `body` is missing"), CURE);
            Given::Broken
        }
        (Some(_), _) => {
            let message = format!("{path}: {} quantities instead of one", reached.len());
            problems.add(path, message, CURE);
            Given::Broken
        }
    }
}

/// A word (`still` or `free`), or a table with a speed or a load.
fn motion(
    node: &Value,
    still: &'static str,
    measures: [&Measure; 3],
    path: &str,
    problems: &mut Problems,
) -> Given {
    match node {
        Value::Table(table) => motion_table(table, measures, path, problems),
        _ => match choice(node, &[still, "free"]) {
            Ok(word) => Given::Motion(Motion { word: Some(word), ..unless_given() }),
            Err(complaint) => {
                let cure = format!(
                    "write \"{still}\", \"free\", {{ speed = \"{}\" }} or {{ load = \"{}\" }}",
                    measures[1].example, measures[2].example
                );
                problems.add(path, format!("{path}: {}", complaint.message), cure);
                Given::Broken
            }
        },
    }
}

/// A motion with what applies unless it is given.
fn unless_given() -> Motion {
    let default = |name| match MOTION.key(name).map(|key| key.default) {
        // Every default can be read: a test reads them all.
        Some(DefaultValue::Quantity(text)) => quantity::parse(text, &TIME).unwrap_or_default(),
        _ => 0.0,
    };
    Motion { start: default("start"), ramp: default("ramp"), ..Motion::default() }
}

fn motion_table(
    table: &[Entry],
    [way, speed, load]: [&Measure; 3],
    path: &str,
    problems: &mut Problems,
) -> Given {
    let mut motion = unless_given();
    let before = problems.len();
    for entry in table {
        let kind = match entry.key.as_str() {
            "speed" => Kind::Quantity(*speed),
            "load" => Kind::Quantity(*load),
            "displacement" => Kind::Quantity(*way),
            "slip" => Kind::Number,
            "table" => Kind::Text,
            "from" => Kind::Choice(&ORIGINS),
            "start" | "ramp" | "end" => {
                motion.is_timed = true;
                Kind::Quantity(TIME)
            }
            _ => {
                unknown(entry, path, MOTION.keys.iter().map(|key| key.name), problems);
                continue;
            }
        };
        let path = join(path, &entry.key);
        let number = match value(&entry.value, &kind, &path, problems) {
            Given::Number(number) => number,
            Given::Text(text) => {
                let place = if entry.key == "from" { &mut motion.from } else { &mut motion.table };
                *place = Some(text);
                continue;
            }
            _ => continue,
        };
        match entry.key.as_str() {
            "speed" => motion.speed = Some(number),
            "load" => motion.load = Some(number),
            "displacement" => motion.displacement = Some(number),
            "slip" => motion.slip = Some(number),
            "start" => motion.start = number,
            "ramp" => motion.ramp = number,
            _ => motion.end = Some(number),
        }
    }
    if problems.len() == before { Given::Motion(motion) } else { Given::Broken }
}
