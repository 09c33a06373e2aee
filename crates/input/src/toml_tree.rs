//! The text of a case, and overrides, to the tree of keys and values, and where each of them stands.

use super::hidden;
use super::names::nearest;
use super::places::{Places, TextSpan};
use super::problem::Problem;
use super::tree::{Entry, Value, join};
use toml::{Spanned, de::DeTable, de::DeValue};

/// The content of a TOML text.
#[derive(Debug)]
pub struct TomlTree {
    /// The tree.
    pub tree: Vec<Entry>,
    /// Where the entries of the tree stand.
    pub places: Places,
    /// Problems of what could not be read.
    pub problems: Vec<(TextSpan, Problem)>,
}

impl TomlTree {
    fn add(&mut self, place: TextSpan, message: impl Into<String>, cure: impl Into<String>) {
        self.problems.push((place, Problem::new("", message, cure)));
    }
}

/// Reads the text of the file (source 0) and then the overrides.
pub fn read(name: &str, text: &str, overrides: &[String]) -> TomlTree {
    let mut read = TomlTree { tree: Vec::new(), places: Places::new(name, text), problems: Vec::new() };
    let (document, errors) = DeTable::parse_recoverable(text);
    let mut lines = Vec::new();
    for error in &errors {
        let span = error.span().unwrap_or(0..0);
        // One mistake causes many errors: the first one of each line is reported, for three lines at most.
        let line = text.bytes().take(span.start).filter(|b| *b == b'\n').count();
        if lines.contains(&line) || lines.len() == 3 {
            continue;
        }
        lines.push(line);
        read.add(TextSpan { source: 0, span }, sentence(error.message()), cure(error.message()));
    }
    if read.problems.is_empty() {
        read.tree = Reader { places: &mut read.places, source: 0, offset: 0 }.entries(document.get_ref(), "");
    }
    for text in overrides {
        override_one(&mut read, overrides, text);
    }
    for (aim, problem) in hidden::problems(&read.tree) {
        read.problems.push((read.places.place(&problem.path, aim), problem));
    }
    read
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
    let known = root.iter().find(|e| e.key == "body").and_then(|e| match &e.value {
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
fn override_one(read: &mut TomlTree, overrides: &[String], text: &str) {
    if let Some(cure) = fix_for_unknown_body(&read.tree, overrides, text) {
        let source = read.places.add_source(&format!("--set {text}"), text);
        read.add(TextSpan { source, span: 0..text.len() }, "there is no body of this name", cure);
        return;
    }
    let name = format!("--set {}", text.split('=').next().unwrap_or_default().trim());
    let source = read.places.add_source(&name, text);
    let whole = TextSpan { source, span: 0..text.len() };
    let cure = "write --set soil.friction_angle=\"38 deg\"";
    let Some((path, value_text)) = text.split_once('=') else {
        read.add(whole, format!("`--set {text}` has no `=`"), cure);
        return;
    };
    let Some((keys, _)) = split_override(text) else {
        read.add(whole, format!("`{path}` is not a key"), cure);
        return;
    };
    let name = TextSpan { source, span: 0..path.len() };
    let offset = path.len() + 1;
    let value_place = TextSpan { source, span: offset..text.len() };
    let path = keys.join(".");
    // The entry is placed first, then what is in it: a table or a list.
    read.places.forget_below(&path);
    read.places.insert(&path, name.clone(), value_place);
    let value = Reader { places: &mut read.places, source, offset }.override_value(value_text, &path);
    if let Err(message) = insert(&mut read.tree, &mut read.places, (&keys, 0), &name, value) {
        read.add(name, message, "name a key, such as soil.friction_angle or body.disc.weight");
    }
}

/// Splits `body.disc.weight = 60 N` into keys and value, if it names a key.
pub fn split_override(text: &str) -> Option<(Vec<&str>, &str)> {
    let (path, value) = text.split_once('=')?;
    let keys: Vec<&str> = path.split('.').map(str::trim).collect();
    let is_key = keys.len() <= DEEPEST_KEY && keys.iter().all(|k| !k.is_empty());
    is_key.then_some((keys, value.trim()))
}

/// Sets the entry named by `keys` from the one at `depth` on; tables on the way stand where the override
/// does.
fn insert(
    table: &mut Vec<Entry>,
    places: &mut Places,
    (keys, depth): (&[&str], usize),
    name: &TextSpan,
    value: Value,
) -> Result<(), String> {
    let Some(first) = keys.get(depth) else { return Ok(()) };
    let known = table.iter().position(|e| e.key == *first);
    if depth + 1 == keys.len() {
        match known {
            Some(n) => table[n].value = value,
            None => table.push(Entry { key: (*first).to_owned(), value }),
        }
        return Ok(());
    }
    let n = known.unwrap_or_else(|| {
        places.insert(&keys[..=depth].join("."), name.clone(), name.clone());
        table.push(Entry { key: (*first).to_owned(), value: Value::Table(Vec::new()) });
        table.len() - 1
    });
    match &mut table[n].value {
        Value::Table(inner) => insert(inner, places, (keys, depth + 1), name, value),
        other => {
            let rest = keys[depth + 1..].join(".");
            Err(format!("`{first}` is {}, so it has no key `{rest}`", other.kind()))
        }
    }
}

/// Converts values of one text and enters their places.
struct Reader<'a> {
    places: &'a mut Places,
    source: usize,
    /// Where in the text the TOML begins.
    offset: usize,
}

impl Reader<'_> {
    fn place(&self, span: std::ops::Range<usize>) -> TextSpan {
        TextSpan { source: self.source, span: span.start + self.offset..span.end + self.offset }
    }

    /// The value of an override: TOML where it is TOML, otherwise plain text, since the shell removes quotes.
    fn override_value(&mut self, text: &str, path: &str) -> Value {
        match DeValue::parse(text.trim()) {
            Ok(value) => {
                self.offset += text.len() - text.trim_start().len();
                self.convert(value.get_ref(), path)
            }
            Err(_) => Value::Text(text.trim().to_owned()),
        }
    }

    fn entries(&mut self, table: &DeTable<'_>, path: &str) -> Vec<Entry> {
        let mut known: Vec<_> = table.iter().collect();
        // The parser sorts by name; bodies are numbered in the order of the file.
        known.sort_by_key(|(key, _)| key.span().start);
        known.into_iter().map(|(key, value)| self.entry(key, value, path)).collect()
    }

    fn entry(&mut self, key: &Spanned<impl AsRef<str>>, value: &Spanned<DeValue<'_>>, path: &str) -> Entry {
        let path = join(path, key.get_ref().as_ref());
        let (name, place) = (self.place(key.span()), self.place(value.span()));
        // A table with a heading stands where its heading does.
        let is_headed = matches!(value.get_ref(), DeValue::Table(_)) && place.span.start < name.span.end;
        let place = if is_headed { name.clone() } else { place };
        self.places.insert(&path, name, place);
        Entry { key: key.get_ref().as_ref().to_owned(), value: self.convert(value.get_ref(), &path) }
    }

    fn convert(&mut self, value: &DeValue<'_>, path: &str) -> Value {
        match value {
            DeValue::String(text) => Value::Text(text.to_string()),
            DeValue::Integer(number) => {
                let parsed = i64::from_str_radix(number.as_str(), number.radix());
                // Too long for an integer: refused like an infinite number.
                parsed.map_or(Value::Number(f64::INFINITY), Value::Integer)
            }
            DeValue::Float(number) => Value::Number(number.as_str().parse().unwrap_or(f64::NAN)),
            DeValue::Boolean(flag) => Value::Flag(*flag),
            DeValue::Datetime(_) => Value::Other("a date"),
            DeValue::Array(list) => {
                Value::List(list.iter().enumerate().map(|(n, v)| self.element(n, v, path)).collect())
            }
            DeValue::Table(table) => Value::Table(self.entries(table, path)),
        }
    }

    fn element(&mut self, n: usize, value: &Spanned<DeValue<'_>>, path: &str) -> Value {
        let path = format!("{path}[{n}]");
        let place = self.place(value.span());
        self.places.insert(&path, place.clone(), place);
        self.convert(value.get_ref(), &path)
    }
}
