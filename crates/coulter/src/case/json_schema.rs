//! The JSON schema of a case file, generated from the tables of keys: editors use it to complete and check case files.

use super::format::FORMAT;
use super::keys::words::WALLS;
use super::keys::{self, KeyTable, Kind};
use serde_json::{Map, Value, json};

/// The schema as pretty text with a newline at the end; `cases/schema.json` holds it.
#[must_use]
pub fn text() -> String {
    format!("{:#}\n", schema())
}

fn schema() -> Value {
    let mut properties = Map::new();
    for section in keys::SECTIONS {
        match section.name {
            "" => properties.extend(keys_of(&section)),
            "body" => {
                let named = json!({ "type": "object", "description": section.meaning,
                    "additionalProperties": object(&section) });
                properties.insert("body".into(), named);
            }
            name => {
                properties.insert(name.into(), object(&section));
            }
        }
    }
    json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "A case for Coulter",
        "type": "object",
        "properties": properties,
        "required": ["format", "soil", "grid", "run"],
        "additionalProperties": false,
    })
}

fn object(section: &KeyTable) -> Value {
    let required: Vec<&str> =
        section.keys.iter().filter(|k| k.default == "required").map(|k| k.name).collect();
    json!({
        "type": "object",
        "description": section.meaning,
        "properties": keys_of(section),
        "required": required,
        "additionalProperties": false,
    })
}

fn keys_of(section: &KeyTable) -> Map<String, Value> {
    let one = |key: &keys::Key| {
        let mut value = kind(&key.kind);
        if let Value::Object(map) = &mut value {
            map.insert("description".into(), format!("{} Default: {}.", key.meaning, key.default).into());
        }
        (key.name.to_owned(), value)
    };
    section.keys.iter().map(one).collect()
}

fn kind(kind: &Kind) -> Value {
    let quantity = |example: &str| json!({ "type": "string", "examples": [example] });
    match kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Format => json!({ "const": FORMAT }),
        Kind::Number => json!({ "type": "number" }),
        Kind::Count => json!({ "type": "integer", "minimum": 0 }),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Quantity(measure) => quantity(measure.example),
        Kind::Choice(words) => json!({ "enum": words }),
        Kind::Range(measure) => {
            json!({ "type": "array", "items": quantity(measure.example), "minItems": 2, "maxItems": 2 })
        }
        Kind::Vector(measure) => {
            json!({ "type": "array", "items": quantity(measure.example), "minItems": 2, "maxItems": 3 })
        }
        Kind::Modulus(offset) => quantity(&format!("102 kN/m^(n+{offset})")),
        Kind::Friction => json!({ "anyOf": [
            { "type": "number", "minimum": 0 }, { "const": "rough" },
            { "type": "string", "pattern": "±", "examples": ["0.3 ± 0.05"] },
        ] }),
        Kind::WallPair => {
            json!({ "type": "array", "items": { "enum": WALLS }, "minItems": 2, "maxItems": 2 })
        }
        Kind::Motion { still, speed, load } => json!({ "anyOf": [
            { "enum": [still, "free"] },
            { "type": "object", "additionalProperties": false, "required": ["speed"], "properties": {
                "speed": quantity(speed.example), "start": quantity("0.3 s"), "ramp": quantity("0.1 s"),
                "end": quantity("2 s") } },
            { "type": "object", "additionalProperties": false, "required": ["load"], "properties": {
                "load": quantity(load.example), "start": quantity("0.3 s"), "ramp": quantity("0.1 s") } },
        ] }),
    }
}
