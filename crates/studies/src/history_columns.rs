//! Columns of the history of a run, as charts name them.

use crate::responses::responses;
use coulter::case::table_file::plain_name;
use coulter::history::BodySample;
use coulter::history::columns::{Column, FORCES};

/// The column of `forces.csv` of a name: its header without the unit, `displacement u`, or without its
/// symbol, `displacement`.
#[must_use]
pub fn find(name: &str) -> Option<&'static Column<BodySample>> {
    let name = name.split('[').next().unwrap_or_default();
    let plain = plain_name(name);
    let words = |column: &Column<BodySample>| {
        let (words, symbol) = column.name.rsplit_once(' ')?;
        (symbol.chars().filter(|c| *c != '_').count() <= 2).then(|| plain_name(words))
    };
    let is_meant = |column: &&'static Column<BodySample>| {
        plain_name(column.name) == plain || words(column).is_some_and(|words| words == plain)
    };
    FORCES.iter().find(is_meant).filter(|_| !plain.is_empty())
}

/// Label of an axis: words, symbol and unit.
#[must_use]
pub fn label(column: &Column<BodySample>) -> String {
    let words = match column.name {
        "time" => "time t".to_owned(),
        "rotation" => "rotation Ω".to_owned(),
        "spin" => "rate of rotation ω".to_owned(),
        "u_bar" => "dimensionless displacement ū".to_owned(),
        name => {
            let known = responses().into_iter().find(|response| {
                let own = column.figure.map_or(name, |figure| figure.name);
                response.name == own
            });
            known.map_or_else(|| name.to_owned(), |response| response.label)
        }
    };
    if column.unit == "-" { words } else { format!("{words} [{}]", column.unit) }
}

/// All names, for messages.
#[must_use]
pub fn names() -> Vec<&'static str> {
    FORCES.iter().map(|column| column.name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_found_by_header_or_words() {
        for (typed, name) in [
            ("time", "time"),
            ("displacement", "displacement u"),
            ("rotation [rad]", "rotation"),
            ("F_H_bar", "F_H_bar"),
            ("turn_ratio", "turn ratio"),
            ("drag", "drag F_H"),
        ] {
            assert_eq!(find(typed).map(|column| column.name), Some(name), "{typed}");
        }
        assert!(find("").is_none() && find("lift").is_none());
        assert_eq!(label(find("drag").unwrap()), "drag F_H [N]");
        assert_eq!(label(find("F_H_bar").unwrap()), "dimensionless drag F̄_H");
    }
}
