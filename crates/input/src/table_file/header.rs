//! The header of a table: the names of its columns, and their units.

use super::lines::{Field, Line, Separator};
use super::number;
use crate::quantity::parse_any;
use std::ops::Range;

/// A column, as its header names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableColumn {
    /// What the header says, such as `sinkage (mm)`.
    pub title: String,
    /// Name of the column: the title without the unit in brackets.
    pub name: String,
    /// Unit of the column, in brackets after the name or in a line of units below the header.
    pub unit: Option<String>,
    /// Where the title stands [bytes].
    pub at: Range<usize>,
}

/// A name without what people write in several ways: small letters and digits alone.
#[must_use]
pub fn plain_name(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

impl TableColumn {
    fn new(field: &Field<'_>) -> Self {
        let title = field.text.replace("\"\"", "\"").split_whitespace().collect::<Vec<_>>().join(" ");
        let (name, unit) = match in_brackets(&title) {
            Some((name, unit)) => (name.to_owned(), Some(unit.to_owned())),
            None => (before_open_bracket(&title).unwrap_or(&title).to_owned(), None),
        };
        Self { title, name, unit, at: field.at.clone() }
    }

    /// What the column is and its unit: by its name, or, where it has no unit in brackets, by what stands
    /// before the last `_`, `/`, comma or space, if that has a meaning and the rest is a unit of it:
    /// `time_s`, `depth / m`.
    pub fn meaning<M>(
        &self,
        named: impl Fn(&str) -> Option<M>,
        has_unit: impl Fn(&M, &str) -> bool,
    ) -> Option<(M, Option<&str>)> {
        if let Some(meaning) = named(&self.name) {
            return Some((meaning, self.unit.as_deref()));
        }
        if self.unit.is_some() {
            return None;
        }
        ['_', '/', ',', ' '].into_iter().find_map(|mark| {
            let (name, unit) = self.name.rsplit_once(mark)?;
            let meaning = named(name.trim())?;
            has_unit(&meaning, unit.trim()).then_some((meaning, Some(unit.trim())))
        })
    }
}

/// What stands before a bracket that is never closed: a name whose unit is not known.
fn before_open_bracket(title: &str) -> Option<&str> {
    let (name, rest) = title.split_once(['[', '('])?;
    (!rest.contains([']', ')'])).then(|| name.trim())
}

/// What stands before the brackets at the end of a title, and in them.
fn in_brackets(title: &str) -> Option<(&str, &str)> {
    let (open, close) = if title.ends_with(']') { ('[', ']') } else { ('(', ')') };
    let inner = title.strip_suffix(close)?;
    let (name, unit) = inner.rsplit_once(open)?;
    Some((name.trim(), unit.trim()))
}

/// The columns of a header, without empty ones at its end.
pub(super) fn columns(names: &[Field<'_>]) -> Vec<TableColumn> {
    let mut columns: Vec<TableColumn> = names.iter().map(TableColumn::new).collect();
    while columns.last().is_some_and(|column| column.title.is_empty()) {
        columns.pop();
    }
    columns
}

/// Gives the columns the units of a line below the header; `false` where it holds no units.
pub(super) fn take_units(columns: &mut [TableColumn], line: &Line<'_>, separator: Separator) -> bool {
    let unit = |field: &Field<'_>| {
        let bare = field.text.trim_matches(['[', ']', '(', ')', ' ']);
        let is_unit = !number::is_number(field, separator)
            && (matches!(bare, "-" | "–" | "%") || parse_any(&format!("1 {bare}")).is_ok());
        is_unit.then(|| bare.to_owned())
    };
    let units: Vec<Option<String>> = line.fields.iter().map(unit).collect();
    let is_whole =
        line.fields.iter().zip(&units).all(|(field, unit)| field.text.is_empty() || unit.is_some());
    if !is_whole || units.len() > columns.len() + 1 || units.iter().flatten().count() == 0 {
        return false;
    }
    for (column, unit) in columns.iter_mut().zip(units) {
        column.unit = column.unit.take().or(unit);
    }
    true
}
