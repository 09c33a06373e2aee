//! Files that a crate includes in its program: a published package holds only what lies in the folder of the
//! crate.

use super::modules::{Modules, Sources, attributes, is_test};
use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Item, LitStr, Macro};

/// The files of a crate, by their path below `src`, that include something from outside its folder.
pub(crate) fn outside(modules: &Modules, sources: &Sources) -> Vec<String> {
    let mut wrong = Vec::new();
    for (file, parsed) in sources.files.iter().filter(|(file, _)| !modules.tests.contains(*file)) {
        let mut found = Includes(Vec::new());
        found.visit_file(parsed);
        // From `src/a/b.rs` two steps up are still in the crate.
        let inside = file.matches('/').count() + 1;
        let outside = found.0.iter().filter(|path| path.matches("../").count() > inside);
        wrong.extend(outside.map(|path| {
            format!(
                "crates/{}/src/{file} includes {path} from outside its crate: its package lacks it",
                sources.name
            )
        }));
    }
    wrong
}

/// The paths up from a file that stand in macros, also in the definitions of macros.
struct Includes(Vec<String>);

impl Includes {
    fn tokens(&mut self, tokens: TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Literal(literal) => {
                    let text = syn::parse_str::<LitStr>(&literal.to_string()).map(|text| text.value());
                    self.0.extend(text.into_iter().filter(|text| text.starts_with("../")));
                }
                TokenTree::Ident(_) | TokenTree::Punct(_) => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Includes {
    fn visit_item(&mut self, item: &'ast Item) {
        if !is_test(attributes(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_macro(&mut self, invoked: &'ast Macro) {
        self.tokens(invoked.tokens.clone());
    }
}
