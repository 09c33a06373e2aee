//! The dependencies between the files of a crate.

use super::modules::{Modules, Target, attributes, imports, is_public, is_test};
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeSet;
use syn::visit::{self, Visit};
use syn::{
    Attribute, Block, ExprClosure, ImplItemFn, Item, ItemFn, ItemMod, ItemUse, Macro, PatIdent, Signature,
    TraitItemFn, Visibility,
};

/// A dependency: a file that names an item of another file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Use {
    pub(crate) from: String,
    pub(crate) to: String,
    /// Line in `from`.
    pub(crate) line: usize,
}

/// The dependencies between the files outside of tests, with the first line that shows each.
pub(crate) fn uses(modules: &Modules) -> Vec<Use> {
    let mut found: Vec<Use> = Vec::new();
    for (module, about) in modules.list.iter().enumerate() {
        let mut visitor = Visitor { modules, module, locals: Vec::new(), found: Vec::new() };
        about.body.iter().for_each(|item| visitor.visit_item(item));
        for (to, line) in visitor.found {
            let is_new = !found.iter().any(|u| u.from == about.file && u.to == to);
            if is_new && to != about.file {
                found.push(Use { from: about.file.clone(), to, line });
            }
        }
    }
    found
}

struct Visitor<'m, 'a> {
    modules: &'m Modules<'a>,
    module: usize,
    /// Variables of the enclosing functions, which shadow items of the same name.
    locals: Vec<BTreeSet<String>>,
    found: Vec<(String, usize)>,
}

impl Visitor<'_, '_> {
    /// Records the file of the item that a path refers to.
    fn path(&mut self, path: &[String], line: usize) {
        let is_shadowed = |name: &String| self.locals.iter().any(|names| names.contains(name));
        if path.len() == 1 && is_shadowed(&path[0]) {
            return;
        }
        if let Some(Target::Item(module)) = self.modules.resolve(self.module, path) {
            self.found.push((self.modules.list[module].file.clone(), line));
        }
    }

    fn within(&mut self, locals: BTreeSet<String>, visit: impl FnOnce(&mut Self)) {
        self.locals.push(locals);
        visit(self);
        self.locals.pop();
    }

    /// Records the paths in the arguments of a macro.
    fn tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let is = |n: usize, c: char| matches!(tokens.get(n), Some(TokenTree::Punct(p)) if p.as_char() == c);
        let mut n = 0;
        while n < tokens.len() {
            match &tokens[n] {
                TokenTree::Group(group) => self.tokens(group.stream()),
                // `.name` is a field or a method, `..name` the end of a range.
                TokenTree::Ident(ident) if n == 0 || !is(n - 1, '.') || (n > 1 && is(n - 2, '.')) => {
                    let mut path = vec![ident.to_string()];
                    while is(n + 1, ':') && is(n + 2, ':') {
                        let Some(TokenTree::Ident(next)) = tokens.get(n + 3) else { break };
                        path.push(next.to_string());
                        n += 3;
                    }
                    self.path(&path, ident.span().start().line);
                }
                _ => {}
            }
            n += 1;
        }
    }
}

impl<'ast> Visit<'ast> for Visitor<'_, '_> {
    fn visit_item(&mut self, item: &'ast Item) {
        if !is_test(attributes(item)) {
            visit::visit_item(self, item);
        }
    }

    /// An inline module is visited as a module of its own.
    fn visit_item_mod(&mut self, _: &'ast ItemMod) {}
    fn visit_attribute(&mut self, _: &'ast Attribute) {}
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    /// Re-exporting items of a child is not a dependency.
    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        for import in imports(item) {
            let target = self.modules.resolve(self.module, &import.path);
            let is_own = matches!(target, Some(Target::Item(to)) if self.modules.is_below(to, self.module));
            if !(is_own && is_public(&item.vis)) {
                self.path(&import.path, item.use_token.span.start().line);
            }
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            let names: Vec<String> = path.segments.iter().map(|s| s.ident.to_string()).collect();
            let line = path.segments.first().map_or(0, |s| s.ident.span().start().line);
            self.path(&names, line);
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, invoked: &'ast Macro) {
        self.visit_path(&invoked.path);
        self.tokens(invoked.tokens.clone());
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.within(locals(&item.sig, Some(&item.block)), |v| visit::visit_item_fn(v, item));
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        if !is_test(&item.attrs) {
            self.within(locals(&item.sig, Some(&item.block)), |v| visit::visit_impl_item_fn(v, item));
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        self.within(locals(&item.sig, item.default.as_ref()), |v| visit::visit_trait_item_fn(v, item));
    }

    fn visit_expr_closure(&mut self, closure: &'ast ExprClosure) {
        let mut names = Names::default();
        closure.inputs.iter().for_each(|input| names.visit_pat(input));
        self.within(names.0, |v| visit::visit_expr_closure(v, closure));
    }
}

/// The parameters and variables of a function.
fn locals(signature: &Signature, body: Option<&Block>) -> BTreeSet<String> {
    let mut names = Names::default();
    names.visit_signature(signature);
    body.into_iter().for_each(|body| names.visit_block(body));
    names.0
}

#[derive(Default)]
struct Names(BTreeSet<String>);

impl<'ast> Visit<'ast> for Names {
    fn visit_pat_ident(&mut self, pattern: &'ast PatIdent) {
        let name = pattern.ident.to_string();
        // Constants and unit variants look like variables in a pattern.
        if name.starts_with(|c: char| c.is_lowercase() || c == '_') {
            self.0.insert(name);
        }
        visit::visit_pat_ident(self, pattern);
    }
}
