//! The table of limits as Markdown, for `docs/reliability.md`.

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

#[cfg(test)]
mod tests {
    #[test]
    fn documentation_is_up_to_date() {
        const BEGIN: &str = "<!-- limits:begin (written by a test with COULTER_UPDATE=1) -->\n";
        const END: &str = "<!-- limits:end -->";
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reliability.md");
        let shipped = std::fs::read_to_string(&path).unwrap();
        let (before, rest) = shipped.split_once(BEGIN).expect("the mark is gone");
        let (_, after) = rest.split_once(END).expect("the mark is gone");
        let expected = format!("{before}{BEGIN}{}{END}{after}", super::table());
        if std::env::var_os("COULTER_UPDATE").is_some() {
            std::fs::write(&path, &expected).unwrap();
        }
        let shipped = std::fs::read_to_string(&path).unwrap();
        assert_eq!(shipped, expected, "{}: run the tests with COULTER_UPDATE=1", path.display());
    }
}
