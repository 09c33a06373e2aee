//! Checks the tree of a case file against the tables of keys. Nothing is interpreted here.

use super::format;
use super::keys;
use super::names::is_device;
use super::problem::{Location, Problems};
use super::tree::{Entry, Value};
use super::typed::{Given, Schema, Section};
use super::unknown::unknown;
use super::values::value;

/// Checks the tree against the tables of keys.
pub(super) fn read(root: &[Entry], problems: &mut Problems) -> Schema {
    let names: Vec<&str> = keys::SECTIONS.iter().map(|s| s.name).filter(|n| !n.is_empty()).collect();
    let (sections, plain): (Vec<&Entry>, Vec<&Entry>) = root.iter().partition(|e| names.contains(&&*e.key));
    let top_keys = keys::find("").map_or(&[][..], |s| s.keys);
    let mut top = Section::empty("", Location::file());
    for entry in plain {
        match top_keys.iter().find(|k| k.name == entry.key) {
            Some(key) => {
                let value = value(&entry.node, &key.kind, key.name, problems);
                top.insert(key.name, value, entry.node.location.clone());
            }
            None => {
                unknown(entry, "", top_keys.iter().map(|k| k.name).chain(names.iter().copied()), problems)
            }
        }
    }
    if !top.has("format") {
        format::missing(problems);
    }
    let mut one = |name: &str| match sections.iter().find(|e| e.key == name) {
        Some(entry) => section(entry, name, name, problems),
        None => Section::empty(name, Location::file()),
    };
    let (soil, ground, domain, grid) = (one("soil"), one("ground"), one("domain"), one("grid"));
    let (run, output, numerics, forecast) = (one("run"), one("output"), one("numerics"), one("forecast"));
    let bodies = sections.iter().find(|e| e.key == "body").map_or(Vec::new(), |e| bodies(e, problems));
    Schema { top, soil, ground, domain, grid, bodies, run, output, numerics, forecast }
}

/// Largest number of bodies; with more, the text and the report become unreadable.
const MAX_BODIES: usize = 500;

fn bodies(entry: &Entry, problems: &mut Problems) -> Vec<Section> {
    let Value::Table(table) = &entry.node.value else {
        let message = format!("`body` must be a table, not {}", entry.node.value.kind());
        problems.add(&entry.node.location, message, "give every body its own section: [body.disc]");
        return Vec::new();
    };
    if table.len() > MAX_BODIES {
        let message = format!("{} bodies; at most {MAX_BODIES} are allowed", table.len());
        problems.add(&entry.key_location, message, "model fewer of them, or each group in a separate case");
        return Vec::new();
    }
    let mut list = Vec::new();
    for named in table {
        let is_plain = named.key.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
        if named.key.is_empty() || !is_plain || is_device(&named.key) {
            let message = format!("\"{}\" is not a valid name for a body", named.key);
            problems.add(
                &named.key_location,
                message,
                "use letters, digits, `-` and `_`, but not the name of a Windows device",
            );
        } else if matches!(named.node.value, Value::Table(_)) {
            list.push(section(named, "body", &format!("body.{}", named.key), problems));
        } else {
            let message = format!("`{}` is in [body], which has no keys of its own", named.key);
            problems.add(&named.key_location, message, "give the body a name in its heading: [body.disc]");
        }
    }
    list
}

fn section(entry: &Entry, kind: &str, path: &str, problems: &mut Problems) -> Section {
    let mut read = Section::empty(path, entry.key_location.clone());
    let known = keys::find(kind).map_or(&[][..], |s| s.keys);
    let Value::Table(table) = &entry.node.value else {
        let message = format!("`{path}` must be a section, not {}", entry.node.value.kind());
        problems.add(&entry.node.location, message, format!("write it as a heading: [{path}]"));
        for key in known {
            read.insert(key.name, Given::Broken, entry.node.location.clone());
        }
        return read;
    };
    for inner in table {
        if let Some(new) = format::new_key(path, &inner.key) {
            let message = format!("`{path}.{}` is now called `{path}.{new}`", inner.key);
            problems.add(&inner.key_location, message, format!("write {new} instead of {}", inner.key));
            read.insert(new, Given::Broken, inner.key_location.clone());
            continue;
        }
        match known.iter().find(|k| k.name == inner.key) {
            Some(key) => {
                let value = value(&inner.node, &key.kind, &format!("{path}.{}", key.name), problems);
                read.insert(key.name, value, inner.node.location.clone());
            }
            None => unknown(inner, path, known.iter().map(|k| k.name), problems),
        }
    }
    read
}
