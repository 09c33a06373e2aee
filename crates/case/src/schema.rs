//! Checks the tree of a case against the tables of keys, and fills in their defaults. Nothing is interpreted
//! here.

use super::form;
use super::format;
use super::keys::{self, KeyTable};
use super::names::{number_of, part_name};
use super::typed_case::Schema;
use super::values::value;
use input::problem::Problems;
use input::tree::{Entry, Value, join};
use input::typed::{Given, Section};
use input::unknown::unknown;

/// Checks the tree against the tables of keys.
pub(super) fn read(root: &[Entry], problems: &mut Problems) -> Schema {
    let names: Vec<&str> = keys::SECTIONS.iter().map(|s| s.name).filter(|n| !n.is_empty()).collect();
    let (sections, plain): (Vec<&Entry>, Vec<&Entry>) = root.iter().partition(|e| names.contains(&&*e.key));
    let mut top = form::with_defaults(table(""), "");
    let top_keys = table("").keys;
    for entry in plain {
        match top_keys.iter().find(|k| k.name == entry.key) {
            Some(key) => top.insert(key.name, value(&entry.value, &key.kind, key.name, problems)),
            None => {
                unknown(entry, "", top_keys.iter().map(|k| k.name).chain(names.iter().copied()), problems)
            }
        }
    }
    if !top.has("format") {
        format::missing(problems);
    }
    let mut optional = |name: &str| {
        sections.iter().find(|e| e.key == name).map(|entry| section(entry, name, name, problems))
    };
    let [water, height_map, furrows] = ["water", "height_map", "furrows"].map(&mut optional);
    let mut one = |name: &str| match sections.iter().find(|e| e.key == name) {
        Some(entry) => section(entry, name, name, problems),
        None => form::with_defaults(table(name), name),
    };
    let (soil, ground, domain, grid) = (one("soil"), one("ground"), one("domain"), one("grid"));
    let (run, output, numerics, forecast) = (one("run"), one("output"), one("numerics"), one("forecast"));
    let mut all = |kind: &str| match sections.iter().find(|e| e.key == kind) {
        Some(entry) => named(entry, kind, problems),
        None => Vec::new(),
    };
    let (layers, soil_bodies) = (all("layer"), all("soil_body"));
    let (bodies, joints, stages) = (all("body"), all("joint"), all("stage"));
    Schema {
        top,
        water,
        soil,
        layers,
        soil_bodies,
        ground,
        height_map,
        furrows,
        domain,
        grid,
        bodies,
        joints,
        stages,
        run,
        output,
        numerics,
        forecast,
    }
}

/// The table of keys of a kind of section.
fn table(kind: &str) -> &'static KeyTable {
    const NONE: KeyTable = KeyTable { name: "", meaning: "", keys: &[] };
    keys::find(kind).unwrap_or(&NONE)
}

/// The sections `[kind.NAME]`.
fn named(entry: &Entry, kind: &str, problems: &mut Problems) -> Vec<Section> {
    let example = match kind {
        "layer" => "layer.clay",
        "soil_body" => "soil_body.lens",
        "body" => "body.disc",
        "joint" => "joint.axle",
        _ => "stage.tow",
    };
    let Value::Table(table) = &entry.value else {
        let message = format!("`{kind}` must be a table, not {}", entry.value.kind());
        problems.add(kind, message, format!("give every {kind} its own section: [{example}]"));
        return Vec::new();
    };
    if !number_of(kind, table.len(), problems) {
        return Vec::new();
    }
    let mut list = Vec::new();
    for named in table {
        let path = join(kind, &named.key);
        if !part_name(kind, &named.key, problems) {
            continue;
        }
        if matches!(named.value, Value::Table(_)) {
            list.push(section(named, kind, &path, problems));
        } else {
            let message = format!("`{}` is in [{kind}], which has no keys of its own", named.key);
            problems.add_to_name(
                path,
                message,
                format!("give the {kind} a name in its heading: [{example}]"),
            );
        }
    }
    list
}

fn section(entry: &Entry, kind: &str, path: &str, problems: &mut Problems) -> Section {
    let mut read = form::with_defaults(table(kind), path);
    let known = table(kind).keys;
    let Value::Table(table) = &entry.value else {
        let message = format!("`{path}` must be a section, not {}", entry.value.kind());
        problems.add(path, message, format!("write it as a heading: [{path}]"));
        for key in known {
            read.insert(key.name, Given::Broken);
        }
        return read;
    };
    for inner in table {
        match known.iter().find(|k| k.name == inner.key) {
            Some(key) => {
                read.insert(key.name, value(&inner.value, &key.kind, &join(path, key.name), problems));
            }
            None if kind == "stage" && matches!(inner.value, Value::Table(_)) => {
                read.inner.push(motions(inner, path, problems));
            }
            None => unknown(inner, path, known.iter().map(|k| k.name), problems),
        }
    }
    read
}

/// The motions of a body that change in a stage.
fn motions(entry: &Entry, stage: &str, problems: &mut Problems) -> Section {
    let path = join(stage, &entry.key);
    let mut read = Section::empty(&path);
    let Value::Table(table) = &entry.value else { return read };
    let known = || self::table("body").keys.iter().filter(|key| key.kind.is_motion());
    for inner in table {
        match known().find(|key| key.name == inner.key) {
            Some(key) => {
                read.insert(key.name, value(&inner.value, &key.kind, &join(&path, key.name), problems));
            }
            None => unknown(inner, &path, known().map(|key| key.name), problems),
        }
    }
    read
}

#[cfg(test)]
mod tests {
    use super::super::form::default_as_typed as as_typed;
    use super::*;

    #[test]
    fn every_default_can_be_read_and_is_in_the_range_of_its_key() {
        let tables = keys::SECTIONS.iter().chain([&keys::MOTION]);
        let of = |table: &KeyTable, name| match table.name {
            kind if keys::NAMED.contains(&kind) => format!("{kind}.disc.{name}"),
            "motion" => format!("body.disc.forward.{name}"),
            section => join(section, name),
        };
        for (path, key) in tables.flat_map(|t| t.keys.iter().map(move |key| (of(t, key.name), key))) {
            assert_eq!(keys::at(&path).unwrap().meaning, key.meaning, "{path}");
            let Some(default) = as_typed(&key.default) else { continue };
            let mut problems = Problems::default();
            assert_ne!(value(&default, &key.kind, &path, &mut problems), Given::Broken);
            assert!(problems.is_empty(), "{problems:?}");
        }
    }

    #[test]
    fn numbers_that_are_derived_are_in_the_range_of_their_key() {
        for key in keys::SECTIONS.iter().flat_map(|table| table.keys) {
            let by_law = ["tresca", "elastic"].map(|law| key.default.for_law(law));
            let all = by_law.into_iter().chain([key.default.of_duration(2.0)]).flatten();
            assert!(
                all.into_iter().all(|n| key.range.is_some_and(|range| range.contains(n))),
                "{}",
                key.name
            );
        }
    }
}
