//! The text of a case: sections of keys with values and where they come from.

use std::fmt::Write;

/// Sections in their order.
#[derive(Debug, Default)]
pub(super) struct CaseText {
    sections: Vec<(String, Vec<[String; 3]>)>,
}

impl CaseText {
    /// Sets a key of a section (empty: the top), with a comment.
    pub(super) fn set(&mut self, section: &str, key: &str, value: impl Into<String>, comment: &str) {
        let line = [key.to_owned(), value.into(), comment.to_owned()];
        match self.sections.iter_mut().find(|(name, _)| name == section) {
            Some((_, lines)) => lines.push(line),
            None => self.sections.push((section.to_owned(), vec![line])),
        }
    }

    /// The text, comments in a column.
    pub(super) fn written(&self) -> String {
        let mut text = String::new();
        let rank = |name: &str| {
            ["body.", "joint.", "stage.", "run", "output", "numerics"]
                .iter()
                .position(|start| name.starts_with(start))
        };
        let mut sections: Vec<_> = self.sections.iter().collect();
        sections.sort_by_key(|(name, _)| rank(name).map_or(0, |rank| rank + 1));
        for (name, lines) in sections {
            if !name.is_empty() {
                let _ = writeln!(text, "\n[{name}]");
            }
            let width =
                lines.iter().map(|[key, value, _]| key.chars().count() + value.chars().count() + 3).max();
            for [key, value, comment] in lines {
                let entry = format!("{key} = {value}");
                let space = width.unwrap_or(0).min(60);
                let _ = match comment.as_str() {
                    "" => writeln!(text, "{entry}"),
                    _ => writeln!(text, "{entry:space$}   # {comment}"),
                };
            }
        }
        text
    }
}

/// A number with at most ten digits, as it would be written by hand. What is smaller than any length, time or
/// stress of soil, in SI units, is what sums of other numbers left of nothing.
pub(super) fn digits(value: f64) -> String {
    const NOTHING: f64 = 1e-12;
    let rounded: f64 = format!("{value:.9e}").parse().unwrap_or(value);
    format!("{}", if rounded.abs() < NOTHING { 0.0 } else { rounded })
}

/// A quantity: `"0.2 m"`.
pub(super) fn quantity(value: f64, unit: &str) -> String {
    format!("\"{} {unit}\"", digits(value))
}

/// Low and high: `["0 m", "1 m"]`.
pub(super) fn range([low, high]: [f64; 2], unit: &str) -> String {
    format!("[{}, {}]", quantity(low, unit), quantity(high, unit))
}

/// A text in quotes, without what would end them.
pub(super) fn quoted(text: &str) -> String {
    let plain: String =
        text.chars().map(|c| if c.is_control() || c == '"' || c == '\\' { ' ' } else { c }).collect();
    format!("\"{}\"", plain.trim())
}
