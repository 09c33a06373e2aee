//! Circular dependencies between the files and sub-folders of a folder.

use super::uses::Use;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// A dependency between two entries of a folder, with one between files that shows it.
#[derive(Clone, Debug)]
struct Arrow {
    from: String,
    to: String,
    shown_by: Use,
}

/// The dependencies between entries of the same folder.
///
/// Two files are represented by their entries (file or sub-folder) in the innermost folder that contains
/// both. Every circle of files then contains a circle of entries of one folder. `name.rs` beside a folder
/// `name` belongs to it, like a `mod.rs`.
fn arrows(uses: &[Use]) -> Vec<Arrow> {
    let mut folders = BTreeSet::new();
    for file in uses.iter().flat_map(|u| [&u.from, &u.to]) {
        folders.extend(file.match_indices('/').map(|(n, _)| file[..n].to_owned()));
    }
    let placed = |file: &str| match file.strip_suffix(".rs") {
        Some(stem) if folders.contains(stem) => format!("{stem}/mod.rs"),
        _ => file.to_owned(),
    };
    let mut found: Vec<Arrow> = Vec::new();
    for shown_by in uses {
        let (from, to) = entries(&placed(&shown_by.from), &placed(&shown_by.to));
        if !found.iter().any(|a| a.from == from && a.to == to) {
            found.push(Arrow { from, to, shown_by: shown_by.clone() });
        }
    }
    found
}

/// The entries that represent two files in the innermost folder that contains both.
fn entries(one: &str, other: &str) -> (String, String) {
    let (a, b): (Vec<&str>, Vec<&str>) = (one.split('/').collect(), other.split('/').collect());
    let shared = a.iter().zip(&b).take_while(|(x, y)| x == y).count();
    let cut = |parts: &[&str]| parts[..=shared.min(parts.len() - 1)].join("/");
    (cut(&a), cut(&b))
}

/// The violations in a crate: circles, and exceptions that are not needed.
///
/// An exception is a dependency to ignore: (from, to), files or folders below `src`; `*` is every `to`.
pub(crate) fn circles(crate_name: &str, uses: &[Use], exceptions: &[(&str, &str)]) -> Vec<String> {
    let all = arrows(uses);
    let matches = |a: &Arrow, (from, to): (&str, &str)| a.from == from && (to == "*" || a.to == to);
    let is_exception = |a: &Arrow| exceptions.iter().any(|exception| matches(a, *exception));
    let kept: Vec<Arrow> = all.iter().filter(|a| !is_exception(a)).cloned().collect();
    let mut wrong = Vec::new();
    let mut seen = BTreeSet::new();
    for arrow in &kept {
        if seen.contains(&arrow.from) {
            continue;
        }
        if let Some(back) = path(&kept, &arrow.to, &arrow.from) {
            let circle: Vec<&Arrow> = std::iter::once(arrow).chain(back).collect();
            seen.extend(circle.iter().map(|a| a.from.clone()));
            wrong.push(described(crate_name, &circle));
        }
    }
    for (from, to) in exceptions {
        let mut ignored = all.iter().filter(|a| matches(a, (*from, *to)));
        if !ignored.any(|a| path(&kept, &a.to, &a.from).is_some()) {
            wrong.push(format!(
                "crates/{crate_name}/src: {from} -> {to} closes no circle: remove it from CIRCLES"
            ));
        }
    }
    wrong
}

/// The shortest path along the dependencies.
fn path<'a>(arrows: &'a [Arrow], from: &str, to: &str) -> Option<Vec<&'a Arrow>> {
    let mut reached: BTreeMap<&str, &Arrow> = BTreeMap::new();
    let mut next = VecDeque::from([from]);
    while let Some(here) = next.pop_front() {
        if here == to {
            let mut path = Vec::new();
            let mut at = to;
            while at != from {
                let arrow = reached[at];
                path.push(arrow);
                at = &arrow.from;
            }
            path.reverse();
            return Some(path);
        }
        for arrow in arrows.iter().filter(|a| a.from == here) {
            if arrow.to != from && !reached.contains_key(arrow.to.as_str()) {
                reached.insert(&arrow.to, arrow);
                next.push_back(&arrow.to);
            }
        }
    }
    None
}

fn described(crate_name: &str, circle: &[&Arrow]) -> String {
    let names: Vec<&str> = circle.iter().map(|a| a.from.as_str()).collect();
    let uses = circle.iter().map(|arrow| {
        let Use { from, line, to } = &arrow.shown_by;
        format!("\n    crates/{crate_name}/src/{from}:{line} uses {to}")
    });
    format!("circle {} -> {}{}", names.join(" -> "), names[0], uses.collect::<String>())
}
