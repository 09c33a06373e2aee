//! The factors that a table varies, as numbers.

use crate::table::{Column, Role, Table, Values};
use std::collections::BTreeSet;

/// A factor that varies.
#[derive(Clone, Debug)]
pub(super) struct VariedFactor<'a> {
    /// Column of the factor.
    pub(super) column: &'a Column,
    /// Words of the factor in the order of the alphabet; empty for a factor of numbers.
    pub(super) words: Vec<String>,
    /// Value of the factor in each row: the number, or that of the word from 0 on.
    pub(super) numbers: Vec<Option<f64>>,
}

/// The factors of a table that have at least two values, in the order of the table.
pub(super) fn varied_factors(table: &Table) -> Vec<VariedFactor<'_>> {
    let factors = table.columns.iter().filter(|column| column.role == Role::Factor).map(factor);
    factors.filter(varies).collect()
}

fn factor(column: &Column) -> VariedFactor<'_> {
    match &column.values {
        Values::Numbers(list) => {
            let numbers = list.iter().map(|value| value.filter(|x| x.is_finite())).collect();
            VariedFactor { column, words: Vec::new(), numbers }
        }
        Values::Words(list) => {
            let words: Vec<String> =
                list.iter().flatten().cloned().collect::<BTreeSet<_>>().into_iter().collect();
            let number = |word: &Option<String>| {
                let place = words.binary_search(word.as_ref()?).ok()?;
                Some(place as f64)
            };
            VariedFactor { column, numbers: list.iter().map(number).collect(), words }
        }
    }
}

fn varies(factor: &VariedFactor<'_>) -> bool {
    let mut present = factor.numbers.iter().flatten();
    present.next().is_some_and(|first| present.any(|other| other != first))
}
