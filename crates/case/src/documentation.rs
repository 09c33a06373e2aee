//! The tables of docs/reference/case-file.md, generated from the tables of keys.

use super::format::FORMAT;
use super::keys::{self, FOLLOW, KeyTable, Kind, MOTION, NAMED, PLACE_KEYS, UNTIL, words};
use std::fmt::Write;

const HEADER: &str = "| key | value | default | meaning |\n|---|---|---|---|\n";

/// The tables of the keys, one for each section, in Markdown.
#[must_use]
pub fn tables() -> String {
    let mut text = String::new();
    for section in keys::SECTIONS {
        let heading = match section.name {
            "" => "Top of the file".to_owned(),
            kind if NAMED.contains(&kind) => format!("`[{kind}.NAME]`"),
            name => format!("`[{name}]`"),
        };
        // Writing to a string cannot fail.
        let _ = write!(text, "### {heading}\n{}\n\n{HEADER}", section.meaning);
        rows(&own(section), &mut text);
    }
    let _ = write!(text, "### A motion\n{}\n\n{HEADER}", MOTION.meaning);
    rows(&MOTION, &mut text);
    let _ = write!(text, "### `grid.follow`\n{}\n\n{HEADER}", FOLLOW.meaning);
    rows(&FOLLOW, &mut text);
    let _ = write!(text, "### `stage.NAME.until`\n{}\n\n{HEADER}", UNTIL.meaning);
    rows(&UNTIL, &mut text);
    text
}

/// The table of the keys of a section of another file than a case, in Markdown.
#[must_use]
pub fn table(section: &KeyTable, heading: &str) -> String {
    let mut text = format!("### {heading}\n{}\n\n{HEADER}", section.meaning);
    rows(section, &mut text);
    text
}

/// The section without keys that another one has explained: a layer has those of the soil, a soil body those
/// of a shape as well.
fn own(section: KeyTable) -> KeyTable {
    match section.name {
        "layer" => KeyTable { keys: &section.keys[..1], ..section },
        "soil_body" => KeyTable { keys: &section.keys[..PLACE_KEYS], ..section },
        _ => section,
    }
}

/// A line for each key of a section.
fn rows(section: &KeyTable, text: &mut String) {
    for key in section.keys {
        let mut range = key.range_text().map_or_else(String::new, |range| format!("; {range}"));
        if let Some(usual) = key.usual_text() {
            range += &format!("; usual: {usual}");
        }
        let (value, default) = (kind(&key.kind), key.default.text());
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| `{}` | {value}{range} | {default} | {} |", key.name, key.meaning);
    }
    text.push('\n');
}

fn kind(kind: &Kind) -> String {
    match kind {
        Kind::Text => "text".into(),
        Kind::Format => format!("`{FORMAT}`"),
        Kind::Number => "number".into(),
        Kind::Ratios => "three numbers, along x, y and z".into(),
        Kind::Interval => "low and high, two numbers".into(),
        Kind::Count => "whole number".into(),
        Kind::Flag => "`true` or `false`".into(),
        Kind::Quantity(measure) => format!("{}: `\"{}\"`", measure.name, measure.example),
        Kind::Choice(words) => listed(words),
        Kind::Range(measure) => format!("low and high, each {}", measure.name),
        Kind::Vector(measure) => format!("2 or 3 values, each {}", measure.name),
        Kind::Modulus(offset) => format!("a modulus: `\"102 kN/m^(n+{offset})\"`"),
        Kind::Friction => "number, or `\"rough\"`".into(),
        Kind::RelativeDensity => {
            let words = words::DENSITIES.map(|(word, density)| format!("`\"{word}\"` ({density})"));
            format!("number, or {}", words.join(", "))
        }
        Kind::Choices(words) => format!("one or several of {}", listed(words)),
        Kind::Names => "list of names".into(),
        Kind::Values => "list of values".into(),
        Kind::Assignments => "`{ \"grid.cell\" = \"20 mm\" }`".into(),
        Kind::NamePair => "two names: `[\"frame\", \"disc\"]`".into(),
        Kind::WallPair => format!("two of {}", listed(&words::WALLS)),
        Kind::Follow => "`{ body = \"disc\", axes = \"x\" }`".into(),
        Kind::Until => "`{ body = \"disc\", sinkage = \"20 mm\" }`".into(),
        Kind::Motion { still, way, speed, load } => {
            format!(
                "motion: `\"{still}\"`, `\"free\"`, {}, {}, {} or a table",
                speed.name, load.name, way.name
            )
        }
    }
}

fn listed(words: &[&str]) -> String {
    words.iter().map(|word| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    /// Compares a shipped file with the tables of keys; with `COULTER_UPDATE=1` it is written instead.
    fn same(path: &str, expected: &str) {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
        if std::env::var_os("COULTER_UPDATE").is_some() {
            std::fs::write(&path, expected).unwrap();
        }
        let shipped = std::fs::read_to_string(&path).unwrap();
        assert_eq!(shipped, expected, "{}: run the tests with COULTER_UPDATE=1", path.display());
    }

    #[test]
    fn shipped_schema_is_up_to_date() {
        same("cases/schema.json", &crate::json_schema::text());
    }

    #[test]
    fn documentation_is_up_to_date() {
        const MARK: &str =
            "<!-- Below: from the table of keys, written by a test with COULTER_UPDATE=1. -->\n";
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/case-file.md");
        let shipped = std::fs::read_to_string(path).unwrap();
        let (by_hand, _) = shipped.split_once(MARK).expect("the mark is gone");
        same("docs/reference/case-file.md", &format!("{by_hand}{MARK}\n{}", super::tables()));
    }
}
