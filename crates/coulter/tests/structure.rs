//! The structure of the source of every crate: no circular dependencies, short functions, one public type per
//! name.
//!
//! **No circular dependencies.** The files and sub-folders of a folder must not depend on each other in a
//! circle; a sub-folder counts as one node. A file depends on every file that defines an item it names: in a
//! `use`, in a path, in the arguments of a macro. Names are resolved through `use` and `pub use` to the file
//! that defines the item.
//!
//! A `mod.rs` is one of the files of its folder. Declaring children (`mod`) and re-exporting their items
//! (`pub use`) is not a dependency, so the usual idiom, in which children use what `super` defines, is
//! allowed. It is a circle if code of `mod.rs` itself also uses such a child: then move the shared
//! definitions to a file of their own. Method calls and the expansion of macros are not followed. Test code
//! (`#[cfg(test)]`) is exempt.
//!
//! **Short functions.** At most 60 lines from the signature to the closing brace, and at most 6 parameters
//! besides `self`. Closures and test code are exempt.
//!
//! **Named structs instead of tuples.** Parameters that take a tuple of unlike things apart, `(a, b): (A,
//! B)`, hide how many a function has: [`TUPLES`] says how many a crate has at most.
//!
//! **Crates of a size to be understood.** At most [`MAX_CRATE`] lines below `src`.
//!
//! **Comments within the width of the code.** rustfmt breaks code, and leaves comments as they are.
//!
//! **One public type per name.** Within a crate no two types that are `pub` or `pub(crate)` have the same
//! name. A file that is included twice (`#[path]`) defines its types once, and the two files that include it
//! count as one.
//!
//! **Whole packages.** What a crate includes in its program (`include_str!`) lies in its folder, if need be
//! behind a link: a published package holds nothing else.
//!
//! The first lists below are the known violations. An entry that is no longer needed is an error, too.
#![allow(clippy::unwrap_used)] // clippy does not recognise test helpers

#[path = "structure/circles.rs"]
mod circles;
#[path = "structure/includes.rs"]
mod includes;
#[path = "structure/items.rs"]
mod items;
#[path = "structure/modules.rs"]
mod modules;
#[path = "structure/samples.rs"]
mod samples;
#[path = "structure/uses.rs"]
mod uses;

use modules::{Modules, Sources};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Dependencies that close a circle: crate, from, to (files or folders below `src`; `*` is everything that
/// `from` uses).
const CIRCLES: &[(&str, &str, &str)] = &[];
/// Functions with too many lines or parameters: crate, file below `src`, name. Those of FMI 3.0 are given.
const FUNCTIONS: &[(&str, &str, &str)] = &[
    ("fmu", "c_api.rs", "fmi3InstantiateCoSimulation"),
    ("fmu", "c_api.rs", "fmi3InstantiateModelExchange"),
    ("fmu", "c_api.rs", "fmi3InstantiateScheduledExecution"),
    ("fmu", "c_api.rs", "fmi3DoStep"),
];
/// Parameters that take a tuple of unlike things apart, at most: crate, number. It may fall, and must not
/// rise.
const TUPLES: &[(&str, usize)] = &[
    ("case", 3),
    ("coulter", 9),
    ("input", 3),
    ("report", 13),
    ("results", 17),
    ("solver", 3),
    ("studies", 33),
];
/// Largest number of lines of a crate.
const MAX_CRATE: usize = 16_000;
/// Names of several public types: crate, name.
const TYPES: &[(&str, &str)] = &[];

/// Name and folder of every crate.
fn crates() -> Vec<(String, PathBuf)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.path().join("src").is_dir())
        .map(|entry| (entry.file_name().to_string_lossy().into_owned(), entry.path()))
        .collect();
    found.sort();
    assert!(found.len() >= 6, "{found:?}");
    found
}

/// Fails with the violations of a rule in all crates.
fn check(rule: impl Fn(&Sources, &Modules) -> Vec<String>) {
    let mut violations = Vec::new();
    for (name, folder) in crates() {
        let sources = Sources::read(&name, &folder.join("src"));
        violations.extend(rule(&sources, &Modules::of(&sources)));
    }
    assert!(violations.is_empty(), "\n{}\n", violations.join("\n"));
}

/// The entries of a list for one crate.
fn entries<'a>(list: &[(&str, &'a str, &'a str)], name: &str) -> Vec<(&'a str, &'a str)> {
    list.iter().filter(|(of, ..)| *of == name).map(|(_, first, second)| (*first, *second)).collect()
}

#[test]
fn there_are_no_circular_dependencies() {
    check(|sources, modules| {
        circles::circles(&sources.name, &uses::uses(modules), &entries(CIRCLES, &sources.name))
    });
}

#[test]
fn functions_are_short_and_have_few_parameters() {
    check(|sources, modules| items::functions(modules, sources, &entries(FUNCTIONS, &sources.name)));
}

#[test]
fn few_parameters_are_tuples_of_unlike_things() {
    check(|sources, modules| {
        let most = TUPLES.iter().find(|(of, _)| *of == sources.name).map_or(0, |(_, most)| *most);
        let found = items::tuples(modules, sources);
        let count = found.len();
        if count > most { [found, vec![format!("{count}, at most {most}")]].concat() } else { Vec::new() }
    });
}

#[test]
fn crates_are_small_enough_to_be_understood() {
    for (name, folder) in crates() {
        let lines = lines(&folder.join("src"));
        assert!(lines <= MAX_CRATE, "{name} has {lines} lines, at most {MAX_CRATE}");
    }
}

#[test]
fn comments_are_within_the_width_of_the_code() {
    let width = |text: &str| text.lines().find_map(|line| line.strip_prefix("max_width = ")?.parse().ok());
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let most: usize = width(&std::fs::read_to_string(root.join("rustfmt.toml")).unwrap()).unwrap();
    let is_wide = |line: &str| line.trim_start().starts_with("//") && line.chars().count() > most;
    let mut wide = Vec::new();
    for file in source_files(&root.join("crates")) {
        let text = std::fs::read_to_string(&file).unwrap();
        let lines = text.lines().enumerate().filter(|(_, line)| is_wide(line));
        wide.extend(lines.map(|(n, _)| format!("{}:{}", file.display(), n + 1)));
    }
    assert!(wide.is_empty(), "more than {most} columns:\n{}", wide.join("\n"));
}

/// The source files in a folder and those below it.
fn source_files(folder: &Path) -> Vec<PathBuf> {
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = paths.partition(|path| path.is_dir());
    let own = files.into_iter().filter(|file| file.extension().is_some_and(|ending| ending == "rs"));
    own.chain(folders.iter().flat_map(|below| source_files(below))).collect()
}

/// Lines of the source files in a folder and those below it.
fn lines(folder: &Path) -> usize {
    source_files(folder).iter().map(|file| std::fs::read_to_string(file).unwrap().lines().count()).sum()
}

#[test]
fn no_two_public_types_of_a_crate_share_a_name() {
    check(|sources, modules| {
        let own = TYPES.iter().filter(|(of, _)| *of == sources.name).map(|(_, name)| *name);
        items::types(modules, sources, &own.collect::<Vec<_>>())
    });
}

#[test]
fn what_a_program_includes_lies_in_its_crate() {
    check(|sources, modules| includes::outside(modules, sources));
}

#[test]
fn every_file_belongs_to_a_module() {
    check(|sources, modules| {
        let known: BTreeSet<&String> = modules.list.iter().map(|m| &m.file).chain(&modules.tests).collect();
        let orphans = sources.files.keys().filter(|file| !known.contains(file));
        orphans.map(|file| format!("crates/{}/src/{file} belongs to no module", sources.name)).collect()
    });
}

#[test]
fn every_exception_names_a_crate() {
    let crates: BTreeSet<String> = crates().into_iter().map(|(name, _)| name).collect();
    let named = CIRCLES.iter().chain(FUNCTIONS).map(|e| e.0).chain(TYPES.iter().map(|e| e.0));
    let named = named.chain(TUPLES.iter().map(|e| e.0));
    let unknown: Vec<&str> = named.filter(|name| !crates.contains(*name)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}
