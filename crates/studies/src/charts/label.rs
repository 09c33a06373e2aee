//! How columns and their values are called in charts.

use crate::table::{Column, Values};
use coulter::case::quantity;

/// The name of a column in words: its label; the name of the file where it has none of its own, without
/// underscores, which would lower letters.
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

/// A number with up to four digits and a true minus sign.
pub(super) fn short(value: f64) -> String {
    quantity::short(value).replace('-', "\u{2212}")
}

/// The symbol at the end of a label, `φ` of `friction angle φ`; the whole label where there is none.
pub(super) fn symbol(column: &Column) -> String {
    let is_symbol = |word: &str| word.chars().count() == 1 || !word.chars().all(|c| c.is_ascii_alphabetic());
    match column.label.rsplit_once(' ') {
        Some((_, last)) if is_symbol(last) => last.to_owned(),
        _ => plain_label(column),
    }
}

/// What a class of a column is called in a legend: `φ = 30 deg`; a model by its name alone.
pub(super) fn class_name(column: &Column, class: &str) -> String {
    let class = class.replace('_', " ");
    if column.name == "model" { class } else { format!("{} = {class}", symbol(column)) }
}

/// What the level of a row is called in a legend: `φ = 30 deg`.
#[must_use]
pub fn level_name(column: &Column, row: usize) -> Option<String> {
    Some(class_name(column, &value_text(column, row)?))
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
    fn a_class_is_named_with_its_factor() {
        let column = |name: &str, label: &str| Column {
            name: name.into(),
            unit: "deg".into(),
            label: label.into(),
            role: Role::Factor,
            values: Values::Numbers(vec![Some(25.0)]),
        };
        for (label, name) in [
            ("friction angle φ", "φ = 30 deg"),
            ("weight W/(γtd²)", "W/(γtd²) = 30 deg"),
            ("drag F_H", "F_H = 30 deg"),
            ("tip radius", "tip radius = 30 deg"),
            ("", "a b = 30 deg"),
        ] {
            assert_eq!(class_name(&column("a_b", label), "30 deg"), name);
        }
        assert_eq!(class_name(&column("model", "model"), "plain_model"), "plain model");
    }

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
