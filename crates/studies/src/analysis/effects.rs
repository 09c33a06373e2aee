//! The table of main effects of a response.

use super::factors::VariedFactor;
use super::indices::column;
use super::named::NamedTable;
use crate::charts::plain_label;
use crate::statistics::effects::LevelMean;
use crate::table::{Column, Role, Table, Values};
use coulter::case::quantity::short;

/// A row of the table.
#[derive(Clone, Debug)]
pub(super) struct EffectRow {
    /// Names of model and factor, and the level with its unit.
    words: [String; 3],
    /// The mean at this level.
    level: LevelMean,
}

impl EffectRow {
    /// The row of a level of a factor.
    pub(super) fn of(model: &str, factor: &VariedFactor<'_>, level: LevelMean) -> Self {
        let place = level.level.round().max(0.0) as usize;
        let text = match factor.words.get(place) {
            Some(word) => word.clone(),
            None if factor.column.unit == "-" => short(level.level),
            None => format!("{} {}", short(level.level), factor.column.unit),
        };
        Self { words: [model.to_owned(), factor.column.name.clone(), text], level }
    }
}

/// The rows as a table `effects_…`.
pub(super) fn effect_table(response: &Column, rows: &[EffectRow]) -> NamedTable {
    let words = |name: &str, which: usize| {
        let word = |row: &EffectRow| Some(row.words[which].clone()).filter(|word| !word.is_empty());
        column(name, name, "", Role::Key, Values::Words(rows.iter().map(word).collect()))
    };
    let numbers = |[name, label, unit]: [&str; 3], value: &dyn Fn(&LevelMean) -> Option<f64>| {
        let list = rows.iter().map(|row| value(&row.level)).collect();
        column(name, label, unit, Role::Response, Values::Numbers(list))
    };
    let unit = response.unit.as_str();
    let columns = vec![
        words("model", 0),
        words("factor", 1),
        words("level", 2),
        numbers(["mean", "mean", unit], &|level| Some(level.mean)),
        numbers(["standard_error", "standard error", unit], &|level| level.error),
        numbers(["points", "points", "-"], &|level| Some(level.points as f64)),
    ];
    let title = format!("{}: main effects", plain_label(response));
    NamedTable { name: format!("effects_{}", response.name), title, table: Table { columns } }
}
