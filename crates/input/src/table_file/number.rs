//! Numbers as programs and people write them.

use super::lines::{Field, Separator};
use super::placed::{Placed, placed};
use crate::quantity::plain;

const PLAIN: &str = "give a number such as 12.5 or 1.25e-3; units stand in the header";
const NO_GROUPS: &str = "write it without marks between thousands, such as 1234.5";

/// Reads the numbers of one table, which writes all of them in one way.
#[derive(Clone, Debug)]
pub(super) struct Numbers {
    separator: Separator,
    /// The first number that shows how decimals are written, and whether that is with a comma.
    decimals: Option<(String, bool)>,
    /// What is to be done about a number that is not there.
    absent: &'static str,
}

impl Numbers {
    pub(super) fn new(separator: Separator, absent: &'static str) -> Self {
        Self { separator, decimals: None, absent }
    }

    /// A remark on the numbers that were read.
    pub(super) fn remark(&self) -> Option<String> {
        let (example, has_comma) = self.decimals.as_ref()?;
        let value: f64 = example.replace(',', ".").replace('−', "-").parse().ok()?;
        has_comma.then(|| format!("decimal commas were read as points: {example} is {}", plain(value)))
    }

    /// The number in a field.
    pub(super) fn read(&mut self, field: &Field<'_>) -> Result<f64, Placed> {
        let refuse = |message: String, cure: &str| Err(placed(field.at.clone(), message, cure));
        if field.text.is_empty() {
            // Nothing stands there: point at the separator.
            return Err(placed(field.at.start..field.at.start + 1, "an empty field", self.absent));
        }
        let text = ungrouped(field.text).replace('−', "-");
        let (commas, points) = (text.matches(',').count(), text.matches('.').count());
        if commas > 0 && points > 0 {
            return refuse(format!("\"{}\" has both a comma and a point", field.text), NO_GROUPS);
        }
        let Some(value) = value(&text, commas == 1) else {
            let cure = if commas > 1 { NO_GROUPS } else { PLAIN };
            return refuse(format!("\"{}\" is not a number", field.text), cure);
        };
        if !value.is_finite() {
            return refuse(format!("\"{}\" is not a finite number", field.text), self.absent);
        }
        if commas == 1 && self.separator == Separator::Comma && is_thousands(&text) {
            let message =
                format!("\"{}\" may be {} or {}", field.text, text.replace(',', "."), text.replace(',', ""));
            return refuse(message, NO_GROUPS);
        }
        if commas + points > 0 {
            let (example, has_comma) =
                self.decimals.get_or_insert_with(|| (field.text.to_owned(), commas == 1));
            if *has_comma != (commas == 1) {
                let message = format!("\"{}\" and \"{example}\" write decimals in two ways", field.text);
                return refuse(message, "write all decimals of a file with a point, or all with a comma");
            }
        }
        Ok(value)
    }
}

/// Whether a field holds a number, or what stands for one that is missing.
pub(super) fn is_number(field: &Field<'_>, separator: Separator) -> bool {
    let text = ungrouped(field.text).replace('−', "-");
    value(&text, separator != Separator::Comma || field.is_quoted).is_some()
}

fn value(text: &str, with_comma: bool) -> Option<f64> {
    if with_comma { text.replacen(',', ".", 1).parse().ok() } else { text.parse().ok() }
}

/// Whether a comma before exactly three digits may be a mark between thousands.
fn is_thousands(text: &str) -> bool {
    let (before, behind) = text.split_once(',').unwrap_or_default();
    let before = before.trim_start_matches(['+', '-']);
    (1..=3).contains(&before.len()) && !before.starts_with('0') && behind.len() == 3
}

/// The text without the blanks and apostrophes between groups of three digits.
fn ungrouped(text: &str) -> String {
    const MARKS: [char; 6] = ['\u{a0}', '\u{202f}', '\u{2009}', ' ', '\'', '’'];
    if !text.contains(MARKS) {
        return text.to_owned();
    }
    let whole = text.find([',', '.', 'e', 'E']).unwrap_or(text.len());
    let groups: Vec<&str> = text[..whole].split(MARKS).collect();
    let is_group = |group: &&str| group.len() == 3 && group.bytes().all(|byte| byte.is_ascii_digit());
    if groups[1..].iter().all(is_group) { groups.concat() + &text[whole..] } else { text.to_owned() }
}
