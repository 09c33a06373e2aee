//! Which separator a table has.

use super::lines::{Field, Separator};
use super::number::is_number;

/// The separator of the first lines of a table.
pub(super) fn separator_of(lines: &[Field<'_>]) -> Separator {
    let Some(first) = lines.first() else { return Separator::Comma };
    let bare = outside_quotes(first.text);
    if bare.contains(';') {
        return Separator::Semicolon;
    }
    if bare.trim().contains('\t') {
        return Separator::Tab;
    }
    let are_numbers = |separator: Separator| {
        separator.split(first).iter().all(|field| field.text.is_empty() || is_number(field, separator))
    };
    if bare.contains(',') && (!are_numbers(Separator::Blanks) || are_numbers(Separator::Comma)) {
        return Separator::Comma;
    }
    if bare.trim().contains(char::is_whitespace) { Separator::Blanks } else { Separator::Comma }
}

/// The text without what stands in quotes.
fn outside_quotes(text: &str) -> String {
    let parts: Vec<&str> = text.split('"').collect();
    if parts.len().is_multiple_of(2) { text.to_owned() } else { parts.into_iter().step_by(2).collect() }
}
