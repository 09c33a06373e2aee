//! A table for the tests.

use super::{Column, Role, Table, Values};

/// A table with numbers that are awkward to write, words with commas and quotation marks, and gaps.
pub(crate) fn table() -> Table {
    let column = |name: &str, unit: &str, label: &str, role, values| Column {
        name: name.into(),
        unit: unit.into(),
        label: label.into(),
        role,
        values,
    };
    let numbers = |list: [Option<f64>; 4]| Values::Numbers(list.to_vec());
    let words = |list: [Option<&str>; 4]| Values::Words(list.map(|word| word.map(str::to_owned)).to_vec());
    let drag = [Some(0.1), None, Some(1.0 / 3.0), Some(-6.022e23)];
    Table {
        columns: vec![
            column("point", "-", "point", Role::Key, numbers([Some(1.0), Some(2.0), Some(3.0), Some(4.0)])),
            column("id", "", "id", Role::Key, words([Some("a"), Some("b, c"), Some("\"d\"\ne"), Some("é")])),
            column(
                "soil.friction_angle",
                "deg",
                "friction angle φ",
                Role::Factor,
                numbers([Some(25.0), Some(1e-300), Some(5e-324), Some(f64::MAX)]),
            ),
            column("drag", "N", "drag F_H", Role::Response, numbers(drag)),
            column(
                "state",
                "",
                "state",
                Role::Remark,
                words([Some("done"), Some("failed"), None, Some("done")]),
            ),
        ],
    }
}
