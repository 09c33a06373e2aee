//! A case from nested maps to the tree of keys and values.

use super::tree::{Entry, Value};

/// The tree of a JSON value.
pub fn tree(value: &serde_json::Value) -> Value {
    match value {
        serde_json::Value::Null => Value::Other("null"),
        serde_json::Value::Bool(flag) => Value::Flag(*flag),
        serde_json::Value::Number(number) => match number.as_i64() {
            Some(whole) => Value::Integer(whole),
            // Too large for a number: refused like an infinite one.
            None => Value::Number(number.as_f64().unwrap_or(f64::INFINITY)),
        },
        serde_json::Value::String(text) => Value::Text(text.clone()),
        serde_json::Value::Array(list) => Value::List(list.iter().map(tree).collect()),
        serde_json::Value::Object(map) => Value::Table(
            map.iter().map(|(key, value)| Entry { key: key.clone(), value: tree(value) }).collect(),
        ),
    }
}
