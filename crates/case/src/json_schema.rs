//! The JSON schema of a case file, generated from the tables of keys: editors use it to complete and check
//! case files.

use super::format::FORMAT;
use super::key::words::{DENSITIES, WALLS};
use super::keys::{self, AllowedRange, Bound, DefaultValue, Key, KeyTable, Kind, SHAPE_KEYS};
use input::quantity::{Measure, TURN_RATE};
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
            "stage" => {
                let mut stage = object(&section);
                stage["additionalProperties"] = stage_motions();
                let named = json!({ "type": "object", "description": section.meaning,
                    "additionalProperties": stage });
                properties.insert(section.name.into(), named);
            }
            "layer" | "soil_body" => {
                let mut layer = object(&section);
                for key in keys::find("soil").map(|soil| soil.keys).unwrap_or_default() {
                    layer["properties"][key.name] =
                        json!({ "$ref": format!("#/properties/soil/properties/{}", key.name) });
                }
                let shapes = keys::find("body").map(|body| &body.keys[..SHAPE_KEYS]).unwrap_or_default();
                for key in shapes.iter().filter(|_| section.name == "soil_body") {
                    let of_body = "#/properties/body/additionalProperties/properties";
                    layer["properties"][key.name] = json!({ "$ref": format!("{of_body}/{}", key.name) });
                }
                let named = json!({ "type": "object", "description": section.meaning,
                    "additionalProperties": layer });
                properties.insert(section.name.into(), named);
            }
            "body" | "joint" => {
                let named = json!({ "type": "object", "description": section.meaning,
                    "additionalProperties": object(&section) });
                properties.insert(section.name.into(), named);
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
        "required": ["format", "soil", "grid"],
        "additionalProperties": false,
    })
}

/// The motions of a body that change in a stage.
fn stage_motions() -> Value {
    let keys = keys::find("body").map(|body| body.keys).unwrap_or_default().iter();
    let of_body =
        |name: &str| json!({ "$ref": format!("#/properties/body/additionalProperties/properties/{name}") });
    let motions = keys.filter(|key| key.kind.is_motion());
    let properties: Map<String, Value> =
        motions.map(|key| (key.name.to_owned(), of_body(key.name))).collect();
    json!({ "type": "object", "description": "A body, and its motions that change.",
        "properties": properties, "additionalProperties": false })
}

/// The schema of a section.
#[must_use]
pub fn object(section: &KeyTable) -> Value {
    let required: Vec<&str> =
        section.keys.iter().filter(|k| k.default == DefaultValue::Required).map(|k| k.name).collect();
    json!({
        "type": "object",
        "description": section.meaning,
        "properties": keys_of(section),
        "required": required,
        "additionalProperties": false,
    })
}

/// The schemas of the keys of a section.
#[must_use]
pub fn keys_of(section: &KeyTable) -> Map<String, Value> {
    section.keys.iter().map(|key| (key.name.to_owned(), property(key))).collect()
}

fn property(key: &Key) -> Value {
    let mut value = kind(key);
    if let Value::Object(map) = &mut value {
        map.insert("description".into(), description(key).into());
        map.extend(default(&key.default).map(|value| ("default".to_owned(), value)));
    }
    value
}

fn description(key: &Key) -> String {
    let range = key.range_text().map_or_else(String::new, |range| format!(" Allowed: {range}."));
    let usual = key.usual_text().map_or_else(String::new, |usual| format!(" Usual: {usual}."));
    format!("{}{range}{usual} Default: {}.", key.meaning, key.default.text())
}

/// A default as it would be typed.
fn default(default: &DefaultValue) -> Option<Value> {
    match *default {
        DefaultValue::Number(number) => Some(json!(number)),
        DefaultValue::Ratios(numbers) => Some(json!(numbers)),
        DefaultValue::Quantity(text) | DefaultValue::Word(text) => Some(json!(text)),
        DefaultValue::Flag(flag) => Some(json!(flag)),
        DefaultValue::Walls(walls) => Some(json!(walls)),
        _ => None,
    }
}

/// A number in the range of its key.
fn number(kind: &str, range: Option<AllowedRange>) -> Value {
    let mut map = Map::from_iter([("type".to_owned(), json!(kind))]);
    let ends = range.map(|range| {
        [("minimum", "exclusiveMinimum", range.low), ("maximum", "exclusiveMaximum", range.high)]
    });
    for (inclusive, exclusive, bound) in ends.into_iter().flatten() {
        match bound {
            Bound::None => None,
            Bound::Inclusive(end) => map.insert(inclusive.into(), json!(end)),
            Bound::Exclusive(end) => map.insert(exclusive.into(), json!(end)),
        };
    }
    Value::Object(map)
}

fn kind(key: &Key) -> Value {
    let quantity = |example: &str| json!({ "type": "string", "examples": [example] });
    match &key.kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Format => json!({ "const": FORMAT }),
        Kind::Number => number("number", key.range),
        Kind::Ratios => json!({
            "type": "array", "items": number("number", key.range), "minItems": 3, "maxItems": 3
        }),
        Kind::Interval => json!({
            "type": "array", "items": number("number", key.range), "minItems": 2, "maxItems": 2
        }),
        Kind::Count => number("integer", key.range),
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
            number("number", key.range), { "const": "rough" },
            { "type": "string", "pattern": "±", "examples": ["0.3 ± 0.05"] },
        ] }),
        Kind::RelativeDensity => json!({ "anyOf": [
            number("number", key.range), { "enum": DENSITIES.map(|(word, _)| word) },
        ] }),
        Kind::Choices(words) => json!({ "anyOf": [
            { "enum": words }, { "type": "array", "items": { "enum": words }, "minItems": 1, "uniqueItems": true }
        ] }),
        Kind::Names => json!({ "type": "array", "items": { "type": "string" } }),
        Kind::Values => json!({
            "type": "array", "items": { "type": ["string", "number", "boolean"] }, "minItems": 1
        }),
        Kind::Assignments => json!({ "type": "object" }),
        Kind::NamePair => json!({
            "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 2,
            "examples": [["frame", "disc"]]
        }),
        Kind::WallPair => {
            json!({ "type": "array", "items": { "enum": WALLS }, "minItems": 2, "maxItems": 2 })
        }
        Kind::Follow => object(&keys::FOLLOW),
        Kind::Until => object(&keys::UNTIL),
        Kind::Motion { still, way, speed, load } => motion_ways(still, way, speed, load),
    }
}

/// How a degree of freedom moves: a word, or one of several tables.
fn motion_ways(still: &str, way: &Measure, speed: &Measure, load: &Measure) -> Value {
    let mut ways = vec![
        json!({ "enum": [still, "free"] }),
        motion(speed.example, "speed", &["start", "ramp", "end"]),
        motion(load.example, "load", &["start", "ramp"]),
        motion(way.example, "displacement", &["start", "ramp"]),
        motion("tow.csv", "table", &["start", "from"]),
    ];
    if let Some(slip) = keys::MOTION.key("slip").filter(|_| *speed == TURN_RATE) {
        let properties = json!({ "slip": property(slip) });
        ways.push(json!({
            "type": "object", "additionalProperties": false, "required": ["slip"], "properties": properties
        }));
    }
    json!({ "anyOf": ways })
}

/// A motion that is written as a table: a speed or a load, and its times.
fn motion(example: &str, cause: &str, times: &[&str]) -> Value {
    let mut properties: Map<String, Value> = times
        .iter()
        .filter_map(|name| keys::MOTION.key(name))
        .map(|key| (key.name.to_owned(), property(key)))
        .collect();
    properties.insert(cause.to_owned(), json!({ "type": "string", "examples": [example] }));
    json!({ "type": "object", "additionalProperties": false, "required": [cause], "properties": properties })
}
