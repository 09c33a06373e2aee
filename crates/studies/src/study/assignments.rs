//! Tables of keys of a case and what to set them to.

use coulter::case::form::{Entry, Value, join};

/// Every key of a table of assignments with its value: `{ "grid.cell" = … }` or `grid.cell = …`.
pub(super) fn assignments(value: Option<Value>, prefix: &str) -> Vec<(String, Value)> {
    let Some(Value::Table(entries)) = value else { return Vec::new() };
    let one = |entry: &Entry| {
        let path = join(prefix, &entry.key);
        let is_key = coulter::case::keys::at(&path).is_some();
        match &entry.value {
            Value::Table(_) if !is_key => assignments(Some(entry.value.clone()), &path),
            value => vec![(path, value.clone())],
        }
    };
    entries.iter().flat_map(one).collect()
}
