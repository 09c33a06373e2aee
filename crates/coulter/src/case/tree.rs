//! The text of a case as a tree of keys and values with their locations.

use super::names::nearest;
use super::problem::{Location, Problems, Source};
use toml::{Spanned, de::DeTable, de::DeValue};

/// A value and its location.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    pub(super) value: Value,
    pub(super) location: Location,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Text(String),
    Integer(i64),
    Number(f64),
    Flag(bool),
    List(Vec<Node>),
    Table(Vec<Entry>),
    Date,
}

impl Value {
    /// Its type with the article, for messages.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Self::Text(_) => "text",
            Self::Integer(_) | Self::Number(_) => "a number",
            Self::Flag(_) => "true or false",
            Self::List(_) => "a list",
            Self::Table(_) => "a table",
            Self::Date => "a date",
        }
    }
}

/// A key of a table with its value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) key_location: Location,
    pub(super) node: Node,
}

/// Reads the file (source 0) and then the overrides; what cannot be read is added to `problems`.
pub(super) fn read(problems: &mut Problems, overrides: &[String]) -> Vec<Entry> {
    let text = problems.text(0).to_owned();
    let (document, errors) = DeTable::parse_recoverable(&text);
    let mut lines = Vec::new();
    for error in &errors {
        let span = error.span().unwrap_or(0..0);
        // One mistake causes many errors: the first one of each line is reported, for three lines at most.
        let line = text.bytes().take(span.start).filter(|b| *b == b'\n').count();
        if lines.contains(&line) || lines.len() == 3 {
            continue;
        }
        lines.push(line);
        problems.add(&Location { source: 0, span }, sentence(error.message()), cure(error.message()));
    }
    let mut root = if problems.is_empty() { entries(document.get_ref(), 0, 0) } else { Vec::new() };
    for text in overrides {
        if let Some(cure) = fix_for_unknown_body(&root, overrides, text) {
            let source = problems.add_source(Source { name: format!("--set {text}"), text: text.clone() });
            problems.add(&Location { source, span: 0..text.len() }, "there is no body of this name", cure);
            continue;
        }
        override_one(problems, &mut root, text);
    }
    root
}

fn sentence(message: &str) -> String {
    format!("not valid TOML: {message}")
}

fn cure(message: &str) -> &'static str {
    if message.contains("duplicate") {
        "the key is set twice in this table: keep one of them"
    } else {
        "a line is `key = value` or `[section]`; text and quantities are in quotes: cell = \"12.5 mm\""
    }
}

/// Largest number of names in a dotted key; `body.NAME.forward.speed` has four.
const DEEPEST_KEY: usize = 6;

/// How to fix an override that would start a new body without a shape: probably a misspelt name.
fn fix_for_unknown_body(root: &[Entry], overrides: &[String], text: &str) -> Option<String> {
    let (own, _) = split_override(text)?;
    let [first, name, _, ..] = own.as_slice() else { return None };
    let gets_shape = |other: &String| {
        split_override(other).is_some_and(|(k, _)| k == ["body", *name, "shape"] || k == ["body", *name])
    };
    let known = root.iter().find(|e| e.key == "body").and_then(|e| match &e.node.value {
        Value::Table(bodies) => Some(bodies.iter().map(|b| b.key.as_str()).collect::<Vec<_>>()),
        _ => None,
    });
    let known = known.unwrap_or_default();
    if *first != "body" || known.contains(name) || overrides.iter().any(gets_shape) {
        return None;
    }
    Some(match nearest(name, known.iter().copied()) {
        Some(near) => {
            format!("did you mean `body.{near}`? a new body needs a shape: --set body.{name}.shape=disc")
        }
        None => format!(
            "a new body needs a shape: --set body.{name}.shape=disc; existing bodies: {}",
            known.join(", ")
        ),
    })
}

/// Sets one key, as `--set key=value` asks.
fn override_one(problems: &mut Problems, root: &mut Vec<Entry>, text: &str) {
    let name = format!("--set {}", text.split('=').next().unwrap_or_default().trim());
    let source = problems.add_source(Source { name, text: text.to_owned() });
    let whole = Location { source, span: 0..text.len() };
    let cure = "write --set soil.friction_angle=\"38 deg\"";
    let Some((path, value_text)) = text.split_once('=') else {
        problems.add(&whole, format!("`--set {text}` has no `=`"), cure);
        return;
    };
    let Some((keys, _)) = split_override(text) else {
        problems.add(&whole, format!("`{path}` is not a key"), cure);
        return;
    };
    let key_location = Location { source, span: 0..path.len() };
    let node = override_value(value_text, source, path.len() + 1);
    if let Err(message) = insert(root, &keys, &key_location, node) {
        problems.add(&key_location, message, "name a key, such as soil.friction_angle or body.disc.weight");
    }
}

/// Splits `body.disc.weight = 60 N` into keys and value, if it names a key.
pub(super) fn split_override(text: &str) -> Option<(Vec<&str>, &str)> {
    let (path, value) = text.split_once('=')?;
    let keys: Vec<&str> = path.split('.').map(str::trim).collect();
    let is_key = keys.len() <= DEEPEST_KEY && keys.iter().all(|k| !k.is_empty());
    is_key.then_some((keys, value.trim()))
}

/// The value of an override: TOML where it is TOML, otherwise plain text, since the shell removes quotes.
fn override_value(text: &str, source: usize, offset: usize) -> Node {
    let location = Location { source, span: offset..offset + text.len() };
    match DeValue::parse(text.trim()) {
        Ok(value) => {
            let lead = text.len() - text.trim_start().len();
            Node { value: convert(value.get_ref(), source, offset + lead), location }
        }
        Err(_) => Node { value: Value::Text(text.trim().to_owned()), location },
    }
}

fn insert(table: &mut Vec<Entry>, keys: &[&str], key_location: &Location, node: Node) -> Result<(), String> {
    let Some((first, rest)) = keys.split_first() else { return Ok(()) };
    let known = table.iter().position(|e| e.key == *first);
    if rest.is_empty() {
        let entry = Entry { key: (*first).to_owned(), key_location: key_location.clone(), node };
        match known {
            Some(n) => table[n] = entry,
            None => table.push(entry),
        }
        return Ok(());
    }
    let n = known.unwrap_or_else(|| {
        let empty = Node { value: Value::Table(Vec::new()), location: key_location.clone() };
        table.push(Entry { key: (*first).to_owned(), key_location: key_location.clone(), node: empty });
        table.len() - 1
    });
    match &mut table[n].node.value {
        Value::Table(inner) => insert(inner, rest, key_location, node),
        other => Err(format!("`{first}` is {}, so it has no key `{}`", other.kind(), rest.join("."))),
    }
}

fn entries(table: &DeTable<'_>, source: usize, offset: usize) -> Vec<Entry> {
    let mut list: Vec<Entry> = table
        .iter()
        .map(|(key, value)| Entry {
            key: key.get_ref().to_string(),
            key_location: Location { source, span: shifted(key.span(), offset) },
            node: node(value, source, offset),
        })
        .collect();
    // The parser sorts by name; bodies are numbered in the order of the file.
    list.sort_by_key(|entry| entry.key_location.span.start);
    list
}

fn node(value: &Spanned<DeValue<'_>>, source: usize, offset: usize) -> Node {
    let location = Location { source, span: shifted(value.span(), offset) };
    Node { value: convert(value.get_ref(), source, offset), location }
}

fn shifted(span: std::ops::Range<usize>, offset: usize) -> std::ops::Range<usize> {
    span.start + offset..span.end + offset
}

fn convert(value: &DeValue<'_>, source: usize, offset: usize) -> Value {
    match value {
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Integer(number) => {
            let parsed = i64::from_str_radix(number.as_str(), number.radix());
            // Too long for an integer: refused like an infinite number.
            parsed.map_or(Value::Number(f64::INFINITY), Value::Integer)
        }
        DeValue::Float(number) => Value::Number(number.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(flag) => Value::Flag(*flag),
        DeValue::Datetime(_) => Value::Date,
        DeValue::Array(list) => Value::List(list.iter().map(|v| node(v, source, offset)).collect()),
        DeValue::Table(table) => Value::Table(entries(table, source, offset)),
    }
}
