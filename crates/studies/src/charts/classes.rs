//! Rows of a table in classes: by the levels of a column, or by ranges of it where it has many.

use super::label::{shown, shown_range};
use crate::table::{Column, Table, Values};

/// Levels up to which each is a class of its own, and classes of a column with more (chosen): more colours
/// cannot be told apart.
pub(super) const MOST_CLASSES: usize = 7;
const RANGES: usize = 5;

/// Rows with a common label.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Class {
    /// Label: a word, a level, a range.
    pub(crate) label: String,
    /// The rows, in the order of the table.
    pub(crate) rows: Vec<usize>,
}

/// The classes of some rows by a column; rows without a value are in none.
pub(super) fn classes(column: &Column, rows: &[usize]) -> Vec<Class> {
    match &column.values {
        Values::Words(list) => by_word(list, rows),
        Values::Numbers(list) => by_number(column, list, rows),
    }
}

/// The models of a table, in the order in which they come up, with their rows; all rows in one class without
/// a column `model`.
pub(crate) fn models(table: &Table) -> Vec<Class> {
    let all: Vec<usize> = (0..table.rows()).collect();
    match table.words("model") {
        Some(list) => by_word(list, &all),
        None => vec![Class { label: String::new(), rows: all }],
    }
}

fn by_word(list: &[Option<String>], rows: &[usize]) -> Vec<Class> {
    let mut found: Vec<Class> = Vec::new();
    for row in rows {
        let Some(word) = &list[*row] else { continue };
        match found.iter_mut().find(|class| class.label == *word) {
            Some(class) => class.rows.push(*row),
            None => found.push(Class { label: word.clone(), rows: vec![*row] }),
        }
    }
    found
}

fn by_number(column: &Column, list: &[Option<f64>], rows: &[usize]) -> Vec<Class> {
    let mut present: Vec<(f64, usize)> =
        rows.iter().filter_map(|row| Some((list[*row].filter(|x| x.is_finite())?, *row))).collect();
    present.sort_by(|a, b| a.0.total_cmp(&b.0));
    let class = |label: String, part: &[(f64, usize)]| {
        let mut rows: Vec<usize> = part.iter().map(|(_, row)| *row).collect();
        rows.sort_unstable();
        Class { label, rows }
    };
    let levels: Vec<&[(f64, usize)]> = present.chunk_by(|a, b| a.0 == b.0).collect();
    if levels.len() <= MOST_CLASSES {
        return levels.into_iter().map(|part| class(shown(column, part[0].0), part)).collect();
    }
    let edge = |n: usize| n * present.len() / RANGES;
    let range = |n: usize| &present[edge(n)..edge(n + 1)];
    let label = |part: &[(f64, usize)]| shown_range(column, [part[0].0, part[part.len() - 1].0]);
    (0..RANGES).map(range).map(|part| class(label(part), part)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Role;

    fn column(values: Values) -> Column {
        Column { name: "a".into(), unit: "m".into(), label: "a".into(), role: Role::Factor, values }
    }

    #[test]
    fn levels_words_and_ranges_make_classes() {
        let few = column(Values::Numbers(vec![Some(2.0), Some(1.0), None, Some(2.0)]));
        let found = classes(&few, &[0, 1, 2, 3]);
        assert_eq!((found[0].label.as_str(), found[1].rows.as_slice()), ("1 m", [0, 3].as_slice()));
        let many = column(Values::Numbers((0..50).map(|n| Some(f64::from(n))).collect()));
        let found = classes(&many, &(0..50).collect::<Vec<_>>());
        assert_eq!((found.len(), found[4].label.as_str()), (5, "40 to 49 m"));
        let words = column(Values::Words(vec![Some("b".into()), Some("a".into()), Some("b".into())]));
        assert_eq!(classes(&words, &[0, 1, 2])[0], Class { label: "b".into(), rows: vec![0, 2] });
    }
}
