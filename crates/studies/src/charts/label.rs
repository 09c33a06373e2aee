//! How columns and their values are called in charts.

use crate::table::{Column, Values};
use coulter::output::digits;

/// The name of a column in words: its label; the name of the file where it has none of its own, without underscores, which would
/// lower letters.
#[must_use]
pub fn plain_label(column: &Column) -> String {
    if column.label.is_empty() || column.label == column.name {
        column.name.replace('_', " ")
    } else {
        column.label.clone()
    }
}

/// The label of an axis: name, symbol and unit.
#[must_use]
pub fn axis_label(column: &Column) -> String {
    let label = plain_label(column);
    match column.unit.as_str() {
        "" => label,
        "-" => format!("{label} [–]"),
        unit => format!("{label} [{unit}]"),
    }
}

/// A value of a column with its unit: `25.0 deg`.
pub(super) fn shown(column: &Column, value: f64) -> String {
    with_unit(&short(value), column)
}

/// A range of values of a column with its unit: `25.0 to 45.0 deg`.
pub(super) fn shown_range(column: &Column, [low, high]: [f64; 2]) -> String {
    with_unit(&format!("{} to {}", short(low), short(high)), column)
}

/// A number with three digits, without zeros that say nothing.
pub(super) fn short(value: f64) -> String {
    let text = digits(value);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// The text of a value: its word, or its number with unit.
pub(super) fn value_text(column: &Column, row: usize) -> Option<String> {
    match &column.values {
        Values::Words(list) => list.get(row)?.clone(),
        Values::Numbers(list) => list.get(row)?.map(|value| shown(column, value)),
    }
}

fn with_unit(text: &str, column: &Column) -> String {
    if column.unit.is_empty() || column.unit == "-" {
        text.to_owned()
    } else {
        format!("{text} {}", column.unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Role;

    #[test]
    fn labels_have_units_and_no_stray_subscripts() {
        let column = |label: &str, unit: &str| Column {
            name: "soil.friction_angle".into(),
            unit: unit.into(),
            label: label.into(),
            role: Role::Factor,
            values: Values::Numbers(vec![Some(25.0)]),
        };
        assert_eq!(axis_label(&column("drag F_H", "N")), "drag F_H [N]");
        assert_eq!(axis_label(&column("soil.friction_angle", "deg")), "soil.friction angle [deg]");
        assert_eq!(axis_label(&column("Z", "-")), "Z [–]");
        assert_eq!(value_text(&column("", "deg"), 0).as_deref(), Some("25 deg"));
        assert_eq!((short(0.5), short(100.0)), ("0.5".to_owned(), "100".to_owned()));
    }
}
