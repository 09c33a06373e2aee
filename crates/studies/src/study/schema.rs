//! The JSON schema of a study file and the tables of its documentation, from the tables of keys.

use super::keys::{SECTIONS, table};
use coulter::case::documentation;
use coulter::case::json_schema::{keys_of, object};
use serde_json::{Map, Value, json};

/// The schema as pretty text with a newline at the end; `cases/study.schema.json` holds it.
#[must_use]
pub fn text() -> String {
    let mut properties: Map<String, Value> = keys_of(&table(""));
    properties.extend(keys_of(&table("part")));
    for section in SECTIONS.iter().filter(|section| !section.name.is_empty()) {
        let schema = if is_single(section.name) {
            object(section)
        } else {
            json!({
                "type": "object", "description": section.meaning, "additionalProperties": object(section),
            })
        };
        properties.insert(section.name.to_owned(), schema);
    }
    let schema = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "A study for Coulter",
        "type": "object",
        "properties": properties,
        "required": ["format", "case", "factor"],
        "additionalProperties": false,
    });
    format!("{schema:#}\n")
}

/// One table for each section, in Markdown.
#[must_use]
pub fn tables() -> String {
    let heading = |name: &str| match name {
        "" => "Top of the file".to_owned(),
        name if is_single(name) => format!("`[{name}]`"),
        name => format!("`[{name}.NAME]`"),
    };
    SECTIONS.iter().map(|section| documentation::table(section, &heading(section.name))).collect()
}

/// Whether a file has the section once, without a name of its own.
fn is_single(section: &str) -> bool {
    ["pool", "style"].contains(&section)
}
