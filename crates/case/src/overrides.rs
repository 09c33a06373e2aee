//! The text of a case with overrides written into it, so that a result can be repeated from one file.

use super::load::parse;
use input::error::CaseError;
use input::toml_tree::split_override;
use toml_edit::{DocumentMut, Item, Table, TableLike, Value};

/// The text of a case with its overrides in it; comments stay.
///
/// # Errors
/// [`CaseError`] where the case with these overrides is wrong.
pub fn overridden(text: &str, source_name: &str, overrides: &[String]) -> Result<String, CaseError> {
    parse(text, source_name, overrides)?;
    let broken = |message: &str| {
        CaseError::unreadable(source_name, message.to_owned(), "write the keys into the file")
    };
    let mut document: DocumentMut = text.parse().map_err(|_| broken("not valid TOML"))?;
    for assignment in overrides {
        let written = split_override(assignment).and_then(|(keys, value)| {
            let value = value.parse::<Value>().unwrap_or_else(|_| Value::from(value));
            set(document.as_table_mut(), &keys, value)
        });
        written.ok_or_else(|| broken(&format!("`--set {assignment}` cannot be written into the file")))?;
    }
    Ok(document.to_string())
}

/// The text of a case that reads other files: the keys that lead to each, and the file. A text in which that
/// cannot be written stays as it is.
pub fn with_files(text: &str, files: &[(Vec<String>, String)]) -> String {
    let Ok(mut document) = text.parse::<DocumentMut>() else { return text.to_owned() };
    for (keys, file) in files {
        let keys: Vec<&str> = keys.iter().map(String::as_str).collect();
        if set(document.as_table_mut(), &keys, Value::from(file.as_str())).is_none() {
            return text.to_owned();
        }
    }
    if files.is_empty() { text.to_owned() } else { document.to_string() }
}

fn set(table: &mut dyn TableLike, keys: &[&str], value: Value) -> Option<()> {
    let (first, rest) = keys.split_first()?;
    if rest.is_empty() {
        table.insert(first, Item::Value(value));
        return Some(());
    }
    let inner = table.entry(first).or_insert_with(|| {
        let mut empty = Table::new();
        empty.set_implicit(true);
        Item::Table(empty)
    });
    set(inner.as_table_like_mut()?, rest, value)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");

    #[test]
    fn the_text_means_the_same_as_file_and_overrides() {
        let overrides = [
            "soil.friction_angle=38 deg",
            "soil.poisson_ratio = 0.25",
            "body.disc.forward.speed=\"0.1 m/s\"",
            "body.disc.heave={ load = '-5 N', start = '0 s' }",
            "numerics.contact=impulse",
            "domain.x=['-0.4 m', '0.75 m']",
            "gravity=9.80665 m/s^2",
        ]
        .map(str::to_owned);
        let text = overridden(TOWED_DISC, "case.toml", &overrides).unwrap();
        assert_eq!(
            parse(&text, "case.toml", &[]).unwrap(),
            parse(TOWED_DISC, "case.toml", &overrides).unwrap()
        );
        assert!(text.contains("# 16 cells across the disc"), "comments are lost");
    }

    #[test]
    fn nothing_to_set_changes_nothing() {
        assert_eq!(overridden(TOWED_DISC, "case.toml", &[]).unwrap(), TOWED_DISC);
    }
}
