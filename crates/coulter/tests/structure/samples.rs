//! The checks on small samples of source: violations are found, everything else passes.

use super::circles::circles;
use super::includes::outside;
use super::items::{functions, types};
use super::modules::{Modules, Sources};
use super::uses::uses;

fn sources(files: &[(&str, &str)]) -> Sources {
    Sources::parse("sample", files.iter().copied())
}

/// The circles of a crate of these files.
fn found(files: &[(&str, &str)]) -> Vec<String> {
    let sources = sources(files);
    circles("sample", &uses(&Modules::of(&sources)), &[])
}

#[track_caller]
fn circle(files: &[(&str, &str)], words: &[&str]) {
    let found = found(files);
    assert_eq!(found.len(), 1, "{found:#?}");
    for word in words {
        assert!(found[0].contains(word), "{word} is missing in {}", found[0]);
    }
}

#[track_caller]
fn no_circle(files: &[(&str, &str)]) {
    let found = found(files);
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn files_that_depend_on_each_other_are_a_circle() {
    let a = ("a.rs", "use crate::b::g;\npub fn f() { g() }");
    let lib = ("lib.rs", "mod a;\nmod b;");
    circle(
        &[lib, a, ("b.rs", "//! About b.\npub fn g() {\n    crate::a::f()\n}")],
        &["src/b.rs:3", "src/a.rs:1"],
    );
    circle(&[lib, a, ("b.rs", "use super::a;\npub fn g() { a::f() }")], &["a.rs -> b.rs -> a.rs"]);
    circle(&[lib, a, ("b.rs", "use super::*;\npub fn g() { a::f() }")], &["b.rs:2"]);
    circle(&[lib, a, ("b.rs", "pub fn g() { println!(\"{}\", crate::a::f()) }")], &["b.rs:1"]);
    circle(&[lib, a, ("b.rs", "pub fn g() { use crate::a as other; other::f() }")], &["b.rs:1"]);
    // Of three files, too.
    let c = ("c.rs", "pub fn h() { crate::a::f() }");
    circle(
        &[("lib.rs", "mod a; mod b; mod c;"), a, ("b.rs", "pub fn g() { crate::c::h() }"), c],
        &["c.rs:1"],
    );
}

#[test]
fn other_files_are_not_a_circle() {
    let files =
        |b| [("lib.rs", "mod a;\nmod b;"), ("a.rs", "use crate::b::g;\npub fn f() { g() }"), ("b.rs", b)];
    no_circle(&files("pub fn g() {}"));
    // A method or field of that name, a variable that shadows it, a path of another crate, a module without a
    // used item.
    no_circle(&files("pub fn g() { let a = 1; println!(\"{}\", x.a.f(a)); std::a::f(); }"));
    no_circle(&files("use super::a;\npub fn g() {}"));
    // Test code.
    no_circle(&files("pub fn g() {}\n#[cfg(test)]\nmod tests { use crate::a::f; #[test] fn t() { f() } }"));
    no_circle(&files("pub fn g() {}\n#[cfg(all(test, unix))]\nuse crate::a::f;"));
}

#[test]
fn reexports_are_resolved_to_the_defining_file() {
    let lib = ("lib.rs", "mod outer; mod user;");
    let outer = ("outer/mod.rs", "mod inner;\npub use inner::f as g;");
    let inner = ("outer/inner.rs", "pub fn f() { crate::user::h() }");
    circle(
        &[lib, outer, inner, ("user.rs", "pub fn h() { crate::outer::g() }")],
        &["uses outer/inner.rs", "user.rs"],
    );
    // A re-export alone is not a dependency …
    let outer = ("outer/mod.rs", "mod inner;\npub use inner::f;\npub struct Shared;");
    no_circle(&[
        ("lib.rs", "mod outer;"),
        outer,
        ("outer/inner.rs", "use super::Shared;\npub fn f(_: Shared) {}"),
    ]);
    // … but a use in the module's own code is,
    let outer =
        ("outer/mod.rs", "mod inner;\npub use inner::f;\npub struct Shared;\npub fn own() { f(Shared) }");
    let inner = ("outer/inner.rs", "use super::Shared;\npub fn f(_: Shared) {}");
    circle(&[("lib.rs", "mod outer;"), outer, inner], &["outer/mod.rs:4", "outer/inner.rs:1"]);
    // and so is a re-export from elsewhere.
    let files = [("lib.rs", "mod a; mod b;"), ("a.rs", "pub use crate::b::S;\npub fn f() {}")];
    circle(&[files[0], files[1], ("b.rs", "pub struct S;\npub fn g() { crate::a::f() }")], &["a.rs:1"]);
}

#[test]
fn a_folder_is_one_node_beside_its_neighbours() {
    let lib = ("lib.rs", "mod forecast; mod output;");
    let forecast = ("forecast/mod.rs", "mod curve; mod overlay;");
    let overlay = ("forecast/overlay.rs", "pub fn o() { crate::output::p() }");
    let output = ("output.rs", "pub fn p() { crate::forecast::curve::c() }");
    let curve = ("forecast/curve.rs", "pub fn c() {}");
    circle(&[lib, forecast, curve, overlay, output], &["circle forecast -> output.rs -> forecast"]);
    // `output.rs` belongs to the folder `output` beside it.
    let output =
        [("output.rs", "mod plot;"), ("output/plot.rs", "pub fn p() { crate::forecast::curve::c() }")];
    let overlay = ("forecast/overlay.rs", "pub fn o() { crate::output::plot::p() }");
    circle(
        &[lib, forecast, curve, overlay, output[0], output[1]],
        &["circle forecast -> output -> forecast"],
    );
}

#[test]
fn a_file_that_is_included_twice_is_one_file() {
    let lib = ("lib.rs", "pub mod double;\npub mod single;\npub use double::law;");
    let path = |name: &str| format!("pub type Real = {name};\n#[path = \"law.rs\"]\npub mod law;");
    let (double, single) = (path("f64"), path("f32"));
    let law = "use super::Real;\npub struct Law(pub Real);\npub fn cast(l: crate::double::law::Law) {}";
    let files = [lib, ("double.rs", &double), ("single.rs", &single), ("law.rs", law)];
    no_circle(&files);
    let sources = sources(&files);
    let modules = Modules::of(&sources);
    assert_eq!(modules.list.len(), 5);
    assert!(
        types(&modules, &sources, &[]).is_empty(),
        "a file that is compiled twice defines its types once"
    );
    // A dependency of either counts.
    let double = format!("{double}\npub fn f() {{ law::cast() }}");
    circle(
        &[lib, ("double.rs", &double), ("single.rs", &single), ("law.rs", law)],
        &["law.rs:1 uses double.rs"],
    );
}

#[test]
fn an_exception_permits_a_circle_and_must_be_needed() {
    let files = [("lib.rs", "mod a; mod b;"), ("a.rs", "pub fn f() { crate::b::g() }")];
    let with = |b, exceptions: &[(&str, &str)]| {
        let sources = sources(&[files[0], files[1], ("b.rs", b)]);
        circles("sample", &uses(&Modules::of(&sources)), exceptions)
    };
    assert!(with("pub fn g() { crate::a::f() }", &[("a.rs", "b.rs")]).is_empty());
    assert!(with("pub fn g() {}", &[("a.rs", "b.rs")])[0].contains("closes no circle"));
    assert!(with("pub fn g() {}", &[("b.rs", "a.rs")])[0].contains("closes no circle"));
    assert_eq!(with("pub fn g() { crate::a::f() }", &[("a.rs", "b.rs"), ("b.rs", "a.rs")]).len(), 2);
    assert!(with("pub fn g() { crate::a::f() }", &[("a.rs", "*")]).is_empty());
    assert!(with("pub fn g() {}", &[("a.rs", "*")])[0].contains("closes no circle"));
}

/// The violations of functions in a file with this text.
fn violations(text: &str, exceptions: &[(&str, &str)]) -> Vec<String> {
    let sources = sources(&[("lib.rs", text)]);
    functions(&Modules::of(&sources), &sources, exceptions)
}

#[test]
fn includes_from_outside_the_crate_are_found() {
    let of = |file: &str, text: &str| {
        let sources = sources(&[("lib.rs", "mod a;"), (file, text)]);
        outside(&Modules::of(&sources), &sources)
    };
    let include = |path: &str| format!("const TEXT: &str = include_str!(\"{path}\");");
    assert!(of("a.rs", &include("../cases/a.toml")).is_empty());
    assert!(of("a/mod.rs", &include("../../cases/a.toml")).is_empty());
    assert!(
        of("a.rs", &include("../../../cases/a.toml"))[0].contains("src/a.rs includes ../../../cases/a.toml")
    );
    let defined = "macro_rules! of { ($f:literal) => { include_str!(concat!(\"../../../cases/\", $f)) }; }";
    assert_eq!(of("a.rs", defined).len(), 1);
    assert!(of("a.rs", &format!("#[cfg(test)]\nmod tests {{ {} }}", include("../../../x"))).is_empty());
}

#[test]
fn long_functions_are_found() {
    let body = |lines: usize| "    work();\n".repeat(lines - 2);
    let function =
        |lines: usize| format!("/// Says what it does.\n#[inline]\npub fn f() {{\n{}}}\n", body(lines));
    assert!(violations(&function(60), &[]).is_empty());
    let found = violations(&function(61), &[]);
    assert!(found[0].contains("src/lib.rs:3 fn f has 61 lines, at most 60"), "{found:?}");
    assert!(violations(&function(61), &[("lib.rs", "f")]).is_empty());
    assert!(violations(&function(60), &[("lib.rs", "f")])[0].contains("remove it"));
    for outer in ["struct S; impl S", "trait T"] {
        let long = function(61).replace("pub ", "");
        assert_eq!(violations(&format!("{outer} {{ {long} }}"), &[]).len(), 1, "{outer}");
    }
    assert!(violations(&format!("#[cfg(test)]\nmod tests {{ {} }}", function(99)), &[]).is_empty());
    assert!(violations(&format!("#[test]\n{}", function(99)), &[]).is_empty());
}

#[test]
fn functions_of_many_parameters_are_found() {
    let six = "a: u8, b: u8, c: u8, d: u8, e: u8, f: u8";
    assert!(
        violations(&format!("fn f({six}) {{}} struct S; impl S {{ fn g(&self, {six}) {{}} }}"), &[])
            .is_empty()
    );
    assert!(violations(&format!("fn f({six}, g: u8) {{}}"), &[])[0].contains("7 parameters, at most 6"));
    assert_eq!(violations(&format!("trait T {{ fn f(&self, {six}, g: u8); }}"), &[]).len(), 1);
    assert!(violations(&format!("fn f() {{ let c = |{six}, g: u8| (); }}"), &[]).is_empty());
}

#[test]
fn two_types_of_one_name_are_found() {
    let of = |a: &str, b: &str, exceptions: &[&str]| {
        let sources = sources(&[("lib.rs", "mod a; mod b;"), ("a.rs", a), ("b.rs", b)]);
        types(&Modules::of(&sources), &sources, exceptions)
    };
    let found = of("\npub struct Load;", "pub(crate) enum Load {}", &[]);
    assert!(found[0].contains("src/a.rs:2") && found[0].contains("src/b.rs:1"), "{found:?}");
    assert!(of("pub struct Load;", "pub type Load = u8;", &["Load"]).is_empty());
    assert!(of("pub struct Load;", "struct Load;", &[]).is_empty());
    assert!(of("pub struct Load;", "pub(super) trait Load {}", &[]).is_empty());
    assert!(of("pub struct Load;", "#[cfg(test)]\npub struct Load;", &[]).is_empty());
    assert!(of("pub struct Load;", "", &["Load"])[0].contains("remove it"));
    assert_eq!(of("pub struct Load; mod inner { pub struct Load; }", "", &[]).len(), 1);
}
