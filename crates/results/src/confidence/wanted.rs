//! How accurate figures are to be.

use crate::history::quantities::Quantity;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// How accurate figures are to be: half-widths of their intervals over their values, by key; the empty key is
/// that of all figures that are not named.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Wanted(pub BTreeMap<String, f64>);

impl Wanted {
    /// Reads a text such as `5 %`, or `drag 5 %, sinkage 8 %`.
    ///
    /// # Errors
    /// What to write instead.
    pub fn parse(text: &str) -> Result<Self, String> {
        let example = "write such as \"5 %\", or \"drag 5 %, sinkage 8 %\"";
        let mut all = BTreeMap::new();
        for part in text.split(',') {
            let part = part.trim();
            let number = part.strip_suffix('%').unwrap_or(part).trim_end();
            let at = number
                .rfind(|c: char| !(c.is_ascii_digit() || c == '.'))
                .map_or(0, |at| at + number[at..].chars().next().map_or(1, char::len_utf8));
            let per_cent = number[at..].parse::<f64>().ok().filter(|value| *value > 0.0 && *value < 100.0);
            let Some(per_cent) = per_cent.filter(|_| part.ends_with('%')) else {
                return Err(example.to_owned());
            };
            let key = match number[..at].trim() {
                "" => String::new(),
                name => {
                    let named =
                        Quantity::with_intervals().find(|q| q.figure.words == name || q.figure.name == name);
                    let known: Vec<&str> = Quantity::with_intervals().map(|q| q.figure.words).collect();
                    named.map(|quantity| quantity.key()).ok_or_else(|| {
                        format!("no figure \"{name}\" has an interval; {example}, of {}", known.join(", "))
                    })?
                }
            };
            all.insert(key, 0.01 * per_cent);
        }
        Ok(Self(all))
    }

    /// What is wanted of the figure with this key.
    #[must_use]
    pub fn of(&self, key: &str) -> Option<f64> {
        self.0.get(key).or_else(|| self.0.get("")).copied()
    }

    /// Whether no accuracy is wanted.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        self.0.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wanted_is_read() {
        let wanted = Wanted::parse("drag 5 %, sinkage 8%").unwrap();
        assert_eq!(
            [wanted.of("drag_N"), wanted.of("sinkage_m"), wanted.of("vertical_N")],
            [Some(0.05), Some(0.08), None]
        );
        let all = Wanted::parse("2.5 %").unwrap();
        assert_eq!(all.of("turn_ratio"), Some(0.025));
        for wrong in ["", "5", "drag", "drag %", "-5 %", "0 %", "5 %,", "100 %", "ärger 5 %"] {
            assert!(Wanted::parse(wrong).unwrap_err().contains("write such as"), "{wrong}");
        }
        assert!(Wanted::parse("speed 5 %").unwrap_err().contains("no figure \"speed\""));
    }
}
