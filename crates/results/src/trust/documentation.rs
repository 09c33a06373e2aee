//! The table of limits as Markdown, for `docs/reference/reliability.md`.

use super::limits::ALL;
use std::fmt::Write;

/// The table of limits.
#[must_use]
pub fn table() -> String {
    let mut text =
        String::from("| check | figure | good | doubtful | why | what to do |\n|---|---|---|---|---|---|\n");
    for limit in ALL {
        let sign = if limit.more_is_better { "≥" } else { "≤" };
        let unit = if limit.unit.is_empty() { String::new() } else { format!(" {}", limit.unit) };
        let bound = |value: f64| {
            if value.is_finite() { format!("{sign} {value}{unit}") } else { "always".to_owned() }
        };
        let (good, doubtful) = (bound(limit.good), bound(limit.doubtful));
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {} | {} | {good} | {doubtful} | {} | {} |",
            limit.name, limit.meaning, limit.reason, limit.advice
        );
    }
    text
}
