//! The module tree of a crate, and the resolution of paths to the files that define their items.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::visit::{self, Visit};
use syn::{Attribute, Expr, Item, ItemMod, ItemUse, Lit, Meta, UseTree, Visibility};

/// Limit on chains of imports; only a name that imports itself (`use physics::double as physics`) reaches it.
const LONGEST_CHAIN: usize = 24;

/// The parsed source files of a crate by their path below `src`, with slashes.
pub(crate) struct Sources {
    pub(crate) name: String,
    pub(crate) files: BTreeMap<String, syn::File>,
}

impl Sources {
    /// Reads the files below a crate's `src`.
    pub(crate) fn read(name: &str, src: &Path) -> Self {
        let mut texts = Vec::new();
        let mut folders = vec![src.to_path_buf()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|e| e == "rs") {
                    let below = path.strip_prefix(src).unwrap().to_string_lossy().replace('\\', "/");
                    texts.push((below, std::fs::read_to_string(&path).unwrap()));
                }
            }
        }
        assert!(!texts.is_empty(), "{name} has no sources");
        Self::parse(name, texts.iter().map(|(path, text)| (path.as_str(), text.as_str())))
    }

    /// Parses files given as (path below `src`, text).
    pub(crate) fn parse<'t>(name: &str, texts: impl IntoIterator<Item = (&'t str, &'t str)>) -> Self {
        let parse = |(path, text): (&str, &str)| {
            (path.to_owned(), syn::parse_file(text).unwrap_or_else(|why| panic!("{name}: {path}: {why}")))
        };
        Self { name: name.to_owned(), files: texts.into_iter().map(parse).collect() }
    }
}

/// What a path refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// A module.
    Module(usize),
    /// An item defined in this module, or a variant or associated item of it.
    Item(usize),
}

/// A name that a `use` imports.
#[derive(Clone, Debug)]
pub(crate) struct Import {
    /// The name; `None` for a glob.
    pub(crate) name: Option<String>,
    /// The imported path, as written.
    pub(crate) path: Vec<String>,
}

/// A module: a file, or a block `mod name { … }` in a file. A file that is included twice makes two modules.
pub(crate) struct Module<'a> {
    pub(crate) file: String,
    pub(crate) body: &'a [Item],
    parent: Option<usize>,
    children: BTreeMap<String, usize>,
    items: BTreeSet<String>,
    imports: BTreeMap<String, Vec<String>>,
    globs: Vec<Vec<String>>,
}

/// The modules of a crate, without test modules.
pub(crate) struct Modules<'a> {
    sources: &'a Sources,
    pub(crate) list: Vec<Module<'a>>,
    /// Files of `#[cfg(test)]` modules.
    pub(crate) tests: BTreeSet<String>,
}

impl<'a> Modules<'a> {
    /// The modules declared from `lib.rs` and `main.rs`.
    pub(crate) fn of(sources: &'a Sources) -> Self {
        let mut modules = Self { sources, list: Vec::new(), tests: BTreeSet::new() };
        for root in ["lib.rs", "main.rs"] {
            if let Some(file) = sources.files.get(root) {
                modules.add(root, &file.items, None, String::new());
            }
        }
        modules
    }

    /// Adds a module and its descendants; `folder` is that of its children's files.
    fn add(&mut self, file: &str, body: &'a [Item], parent: Option<usize>, folder: String) -> usize {
        let index = self.list.len();
        let own = |item: &&Item| !is_test(attributes(item));
        let mut imports = BTreeMap::new();
        let mut globs = Vec::new();
        for import in body.iter().filter(own).flat_map(imports_of) {
            match import.name {
                Some(name) => {
                    imports.entry(name).or_insert(import.path);
                }
                None => globs.push(import.path),
            }
        }
        let items = body.iter().filter(own).filter_map(item_name).collect();
        let module =
            Module { file: file.to_owned(), body, parent, children: BTreeMap::new(), items, imports, globs };
        self.list.push(module);
        let is_inline = parent.is_some_and(|p| self.list[p].file == file);
        for item in body {
            if let Item::Mod(child) = item {
                let added = self.add_child(index, child, &folder, is_inline);
                self.list[index].children.extend(added.map(|n| (child.ident.to_string(), n)));
            }
        }
        index
    }

    /// Adds a child module; `None` for a test module.
    fn add_child(&mut self, parent: usize, child: &'a ItemMod, folder: &str, inline: bool) -> Option<usize> {
        let (name, file) = (child.ident.to_string(), self.list[parent].file.clone());
        let below = join(folder, &name);
        if let Some((_, body)) = &child.content {
            return (!is_test(&child.attrs)).then(|| self.add(&file, body, Some(parent), below));
        }
        let (path, folder) = match path_attribute(&child.attrs) {
            Some(path) => {
                let path = normal(&join(if inline { folder } else { parent_folder(&file) }, &path));
                let folder = parent_folder(&path).to_owned();
                (path, folder)
            }
            None => {
                let flat = format!("{below}.rs");
                (if self.sources.files.contains_key(&flat) { flat } else { format!("{below}/mod.rs") }, below)
            }
        };
        if is_test(&child.attrs) {
            self.tests.insert(path);
            return None;
        }
        let name = &self.sources.name;
        let source = self.sources.files.get(&path).unwrap_or_else(|| panic!("{name}: no file {path}"));
        Some(self.add(&path, &source.items, Some(parent), folder))
    }

    /// What a path refers to in a module; `None` if it is of another crate, a local variable, or not found.
    pub(crate) fn resolve(&self, module: usize, path: &[String]) -> Option<Target> {
        self.follow(module, path, 0)
    }

    fn follow(&self, module: usize, path: &[String], depth: usize) -> Option<Target> {
        let (mut at, mut rest) = (module, path);
        while let Some((first, others)) = rest.split_first() {
            at = match first.as_str() {
                "crate" => self.root(at),
                "self" => at,
                "super" => self.list[at].parent?,
                _ => break,
            };
            rest = others;
        }
        let Some((last, folders)) = rest.split_last() else { return Some(Target::Module(at)) };
        for name in folders {
            match self.lookup(at, name, true, depth)? {
                Target::Module(below) => at = below,
                // A type, followed by a variant or an associated item.
                item => return Some(item),
            }
        }
        self.lookup(at, last, false, depth)
    }

    /// What a name refers to in a module. If it is both a module and an item, it is the module unless it ends
    /// the path.
    fn lookup(&self, at: usize, name: &str, in_path: bool, depth: usize) -> Option<Target> {
        if depth > LONGEST_CHAIN {
            return None;
        }
        let module = &self.list[at];
        let child = || module.children.get(name).map(|n| Target::Module(*n));
        let item = || module.items.contains(name).then_some(Target::Item(at));
        let import = || self.follow(at, module.imports.get(name)?, depth + 1);
        let named = if in_path {
            child().or_else(item).or_else(import)
        } else {
            item().or_else(import).or_else(child)
        };
        named.or_else(|| {
            module.globs.iter().find_map(|glob| match self.follow(at, glob, depth + 1)? {
                Target::Module(below) if below != at => self.lookup(below, name, in_path, depth + 1),
                _ => None,
            })
        })
    }

    fn root(&self, module: usize) -> usize {
        std::iter::successors(Some(module), |m| self.list[*m].parent).last().unwrap_or(module)
    }

    /// Whether `module` lies below `above`.
    pub(crate) fn is_below(&self, module: usize, above: usize) -> bool {
        std::iter::successors(self.list[module].parent, |m| self.list[*m].parent).any(|m| m == above)
    }

    /// Twins, files that include the same files by `#[path]` to compile them several times, with the one that
    /// represents them.
    pub(crate) fn twins(&self) -> BTreeMap<String, String> {
        let mut including: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for module in &self.list {
            let parent = module.parent.map(|p| self.list[p].file.as_str()).filter(|p| *p != module.file);
            including.entry(&module.file).or_default().extend(parent);
        }
        let mut same = BTreeMap::new();
        for parents in including.values().filter(|parents| parents.len() > 1) {
            let first = parents.first().copied().unwrap_or_default();
            same.extend(parents.iter().map(|p| ((*p).to_owned(), first.to_owned())));
        }
        same
    }
}

fn join(folder: &str, name: &str) -> String {
    if folder.is_empty() { name.to_owned() } else { format!("{folder}/{name}") }
}

fn parent_folder(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

/// A path without `.` and `..`.
fn normal(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            "." | "" => {}
            ".." => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts.join("/")
}

/// The file of `#[path = "…"]`.
fn path_attribute(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find(|a| a.path().is_ident("path")).and_then(|a| match &a.meta {
        Meta::NameValue(pair) => match &pair.value {
            Expr::Lit(value) => match &value.lit {
                Lit::Str(text) => Some(text.value()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    })
}

/// Whether an item is compiled for tests only: `#[test]`, `#[cfg(test)]`, `#[cfg(all(test, …))]`.
pub(crate) fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let words = |text: String| {
            text.split(|c: char| !c.is_alphanumeric() && c != '_').map(str::to_owned).collect::<Vec<_>>()
        };
        attribute.path().is_ident("test")
            || attribute.path().is_ident("cfg")
                && attribute.meta.require_list().is_ok_and(|list| {
                    let words = words(list.tokens.to_string());
                    words.iter().any(|w| w == "test") && !words.iter().any(|w| w == "not")
                })
    })
}

/// The attributes of an item of a kind that may be compiled for tests only.
pub(crate) fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Union(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn item_name(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(ident.to_string())
}

/// Whether a `use` re-exports.
pub(crate) fn is_public(visibility: &Visibility) -> bool {
    !matches!(visibility, Visibility::Inherited)
}

/// The imports of a `use`, or of the `use` statements in the blocks of an item.
fn imports_of(item: &Item) -> Vec<Import> {
    #[derive(Default)]
    struct Imports(Vec<Import>);
    impl<'ast> Visit<'ast> for Imports {
        fn visit_item_use(&mut self, item: &'ast ItemUse) {
            self.0.extend(imports(item));
        }
        fn visit_item_mod(&mut self, _: &'ast ItemMod) {}
    }
    let mut found = Imports::default();
    visit::visit_item(&mut found, item);
    found.0
}

/// The imports of a `use`, without those of other crates by `::name`.
pub(crate) fn imports(item: &ItemUse) -> Vec<Import> {
    let mut found = Vec::new();
    if item.leading_colon.is_none() {
        flatten(&item.tree, &mut Vec::new(), &mut found);
    }
    found
}

fn flatten(tree: &UseTree, above: &mut Vec<String>, found: &mut Vec<Import>) {
    match tree {
        UseTree::Path(path) => {
            above.push(path.ident.to_string());
            flatten(&path.tree, above, found);
            above.pop();
        }
        UseTree::Group(group) => group.items.iter().for_each(|tree| flatten(tree, above, found)),
        UseTree::Glob(_) => found.push(Import { name: None, path: above.clone() }),
        UseTree::Name(name) => {
            let path = leaf(above, &name.ident.to_string());
            found.push(Import { name: path.last().cloned(), path });
        }
        UseTree::Rename(rename) => {
            let path = leaf(above, &rename.ident.to_string());
            found.push(Import { name: Some(rename.rename.to_string()), path });
        }
    }
}

fn leaf(above: &[String], name: &str) -> Vec<String> {
    let own = (name != "self").then(|| name.to_owned());
    above.iter().cloned().chain(own).collect()
}
