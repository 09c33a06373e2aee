//! Functions with too many lines or parameters, and public types of the same name.

use super::modules::{Modules, Sources, attributes, is_test};
use std::collections::{BTreeMap, BTreeSet};
use syn::visit::{self, Visit};
use syn::{Block, FnArg, Ident, ImplItemFn, Item, ItemFn, Pat, Signature, TraitItemFn, Type, Visibility};

/// Largest number of lines, from the signature to the closing brace.
const MAX_LINES: usize = 60;
/// Largest number of parameters, without `self`.
const MAX_PARAMETERS: usize = 6;

struct Function {
    name: String,
    line: usize,
    lines: usize,
    parameters: usize,
    /// Parameters that take a tuple of unlike things apart.
    tuples: usize,
}

/// The violations of functions in a crate; `exceptions` are (file below `src`, function).
pub(crate) fn functions(modules: &Modules, sources: &Sources, exceptions: &[(&str, &str)]) -> Vec<String> {
    let mut wrong = Vec::new();
    let mut needed = BTreeSet::new();
    for (path, file) in sources.files.iter().filter(|(path, _)| !modules.tests.contains(*path)) {
        let mut functions = Functions(Vec::new());
        functions.visit_file(file);
        for Function { name, line, lines, parameters, .. } in functions.0 {
            let mut violations = Vec::new();
            if lines > MAX_LINES {
                violations.push(format!("{lines} lines, at most {MAX_LINES}"));
            }
            if parameters > MAX_PARAMETERS {
                violations.push(format!("{parameters} parameters, at most {MAX_PARAMETERS}"));
            }
            if violations.is_empty() {
                continue;
            }
            if exceptions.contains(&(path.as_str(), name.as_str())) {
                needed.insert((path.clone(), name));
                continue;
            }
            let place = format!("crates/{}/src/{path}:{line}", sources.name);
            wrong.push(format!("{place} fn {name} has {}", violations.join(" and ")));
        }
    }
    for (path, name) in exceptions {
        if !needed.contains(&((*path).to_owned(), (*name).to_owned())) {
            let crate_name = &sources.name;
            wrong.push(format!(
                "crates/{crate_name}/src/{path}: fn {name} is no violation: remove it from FUNCTIONS"
            ));
        }
    }
    wrong
}

/// The places of parameters that take a tuple of unlike things apart, such as `(a, b): (A, B)`, once for
/// each.
pub(crate) fn tuples(modules: &Modules, sources: &Sources) -> Vec<String> {
    let mut places = Vec::new();
    for (path, file) in sources.files.iter().filter(|(path, _)| !modules.tests.contains(*path)) {
        let mut functions = Functions(Vec::new());
        functions.visit_file(file);
        for Function { name, line, tuples, .. } in functions.0 {
            let place = format!("crates/{}/src/{path}:{line} fn {name}", sources.name);
            places.extend(std::iter::repeat_n(place, tuples));
        }
    }
    places
}

fn is_tuple_of_unlike_things(input: &FnArg) -> bool {
    let FnArg::Typed(parameter) = input else { return false };
    let (Pat::Tuple(_), Type::Tuple(types)) = (&*parameter.pat, &*parameter.ty) else { return false };
    types.elems.iter().any(|each| Some(each) != types.elems.first())
}

struct Functions(Vec<Function>);

impl Functions {
    fn add(&mut self, visibility: &Visibility, signature: &Signature, body: Option<&Block>) {
        let first = first_line(visibility, signature);
        let lines = body.map_or(0, |body| body.brace_token.span.close().end().line + 1 - first);
        let parameters = signature.inputs.iter().filter(|i| matches!(i, FnArg::Typed(_))).count();
        let tuples = signature.inputs.iter().filter(|input| is_tuple_of_unlike_things(input)).count();
        self.0.push(Function { name: signature.ident.to_string(), line: first, lines, parameters, tuples });
    }
}

/// The first line of a signature, after documentation and attributes.
fn first_line(visibility: &Visibility, signature: &Signature) -> usize {
    let public = match visibility {
        Visibility::Public(token) => Some(token.span),
        Visibility::Restricted(restricted) => Some(restricted.pub_token.span),
        Visibility::Inherited => None,
    };
    let words = [
        public,
        signature.constness.map(|token| token.span),
        signature.asyncness.map(|token| token.span),
        signature.unsafety.map(|token| token.span),
    ];
    words.into_iter().flatten().next().unwrap_or(signature.fn_token.span).start().line
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item(&mut self, item: &'ast Item) {
        if !is_test(attributes(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.add(&item.vis, &item.sig, Some(&item.block));
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        if !is_test(&item.attrs) {
            self.add(&item.vis, &item.sig, Some(&item.block));
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        self.add(&Visibility::Inherited, &item.sig, item.default.as_ref());
        visit::visit_trait_item_fn(self, item);
    }
}

/// The names of several public types of a crate; `exceptions` are names to ignore.
pub(crate) fn types(modules: &Modules, sources: &Sources, exceptions: &[&str]) -> Vec<String> {
    let twins = modules.twins();
    let mut places: BTreeMap<String, Vec<(String, usize)>> = BTreeMap::new();
    for (path, file) in sources.files.iter().filter(|(path, _)| !modules.tests.contains(*path)) {
        let mut types = Types(Vec::new());
        types.visit_file(file);
        for (name, line) in types.0 {
            places.entry(name).or_default().push((path.clone(), line));
        }
    }
    let mut wrong = Vec::new();
    for (name, places) in &places {
        if count(places, &twins) < 2 || exceptions.contains(&name.as_str()) {
            continue;
        }
        let line =
            |(path, line): &(String, usize)| format!("\n    crates/{}/src/{path}:{line}", sources.name);
        wrong.push(format!(
            "several public types are named {name}:{}",
            places.iter().map(line).collect::<String>()
        ));
    }
    for name in exceptions {
        if places.get(*name).is_none_or(|places| count(places, &twins) < 2) {
            wrong.push(format!("{}: {name} is no violation: remove it from TYPES", sources.name));
        }
    }
    wrong
}

/// Number of types, those of twins counted once.
fn count(places: &[(String, usize)], twins: &BTreeMap<String, String>) -> usize {
    let mut by_file: BTreeMap<&String, usize> = BTreeMap::new();
    for (path, _) in places {
        *by_file.entry(path).or_default() += 1;
    }
    let mut by_text: BTreeMap<&String, usize> = BTreeMap::new();
    for (path, number) in by_file {
        let most = by_text.entry(twins.get(path).unwrap_or(path)).or_default();
        *most = (*most).max(number);
    }
    by_text.values().sum()
}

struct Types(Vec<(String, usize)>);

impl Types {
    /// Records a type that is `pub` or `pub(crate)`.
    fn add(&mut self, visibility: &Visibility, name: &Ident) {
        let is_for_all = match visibility {
            Visibility::Public(_) => true,
            Visibility::Restricted(restricted) => restricted.path.is_ident("crate"),
            Visibility::Inherited => false,
        };
        if is_for_all {
            self.0.push((name.to_string(), name.span().start().line));
        }
    }
}

impl<'ast> Visit<'ast> for Types {
    fn visit_item(&mut self, item: &'ast Item) {
        if is_test(attributes(item)) {
            return;
        }
        match item {
            Item::Enum(item) => self.add(&item.vis, &item.ident),
            Item::Struct(item) => self.add(&item.vis, &item.ident),
            Item::Trait(item) => self.add(&item.vis, &item.ident),
            Item::Type(item) => self.add(&item.vis, &item.ident),
            Item::Union(item) => self.add(&item.vis, &item.ident),
            _ => {}
        }
        visit::visit_item(self, item);
    }
}
