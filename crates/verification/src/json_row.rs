//! A row as JSON.

use crate::row::{Expected, Row, Tolerance};
use serde::Serialize;

/// What `coulter verify --json` prints for a row.
#[derive(Debug, Serialize)]
pub struct JsonRow<'a> {
    id: &'a str,
    case: &'a str,
    quantity: &'a str,
    expected: serde_json::Value,
    obtained: Option<f64>,
    error: Option<f64>,
    tolerance: Option<f64>,
    pass: Option<bool>,
    inside: Option<bool>,
    source: &'a str,
    seconds: f64,
}

impl Row {
    /// The row for JSON, in which a number that is not finite becomes `null`.
    #[must_use]
    pub fn json(&self) -> JsonRow<'_> {
        let finite = |value: f64| value.is_finite().then_some(value);
        JsonRow {
            id: self.id,
            case: &self.case,
            quantity: &self.quantity,
            expected: match self.expected {
                Expected::Value(value) | Expected::AtLeast(value) => value.into(),
                Expected::Between(low, high) => vec![low, high].into(),
                Expected::Nothing => serde_json::Value::Null,
            },
            obtained: finite(self.obtained),
            error: self.error().and_then(finite),
            tolerance: match self.tolerance {
                Tolerance::Relative(limit) | Tolerance::Absolute(limit) => Some(limit),
                Tolerance::None => None,
            },
            pass: self.passes(),
            inside: self.is_inside(),
            source: &self.source,
            seconds: self.seconds,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comparison_row_says_whether_it_is_inside() {
        let row = Row::info("D3", "disc", "drag", 14.4).compared_with(15.0, 17.0, "");
        let compared = serde_json::to_value(row.json()).unwrap();
        assert!(compared["inside"] == false && compared["pass"].is_null());
        let judged = serde_json::to_value(row.within(15.0, 0.1, "").json()).unwrap();
        assert!(judged["inside"].is_null() && judged["pass"] == true);
    }
}
