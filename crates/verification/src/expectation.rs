//! What is expected of a figure: one `[[row]]` of a file `expected.toml`.

use crate::error::VerifyError;
use crate::row::{Expected, Tolerance};
use serde::Deserialize;

/// A part of the suite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Suite {
    /// `coulter verify`.
    Full,
    /// `coulter verify --fast`.
    Fast,
    /// `coulter verify --refine`.
    Refine,
}

/// What is expected of a figure, in one variant or in several.
#[derive(Debug, Deserialize)]
#[serde(try_from = "Typed")]
pub struct Expectation {
    /// The quantity that is measured, with its unit, as in the table.
    pub quantity: String,
    /// The expected value.
    pub target: Target,
    /// How far the figure may deviate from the expected value.
    pub tolerance: Tolerance,
    /// Author and year, or the reason.
    pub source: String,
    /// Values of a reference curve, in the unit of the quantity they are compared with; empty if there is
    /// none.
    pub curve: Vec<f64>,
    cases: Vec<String>,
    fast: Vec<String>,
    refine: Vec<String>,
}

/// What a figure is compared with.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// A number, or none.
    Number(Expected),
    /// The quantity of this name in another variant of the verification.
    SameAs(String),
}

/// A row as it is typed.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Typed {
    quantity: String,
    #[serde(default)]
    cases: Vec<String>,
    #[serde(default)]
    fast: Fast,
    #[serde(default)]
    refine: Vec<String>,
    value: Option<f64>,
    at_least: Option<f64>,
    range: Option<[f64; 2]>,
    same_as: Option<String>,
    relative: Option<f64>,
    absolute: Option<f64>,
    #[serde(default)]
    source: String,
    /// How the numbers were computed; for the reader.
    #[serde(default, rename = "formula")]
    _formula: String,
    #[serde(default)]
    curve: Vec<f64>,
}

/// The variants in the fast suite as they are typed.
#[derive(Debug, Deserialize)]
#[serde(untagged, expecting = "expected true or a list of cases")]
enum Fast {
    /// The variants of the full suite, or none.
    Same(bool),
    These(Vec<String>),
}

impl Default for Fast {
    fn default() -> Self {
        Self::Same(false)
    }
}

impl Typed {
    /// What the figure is compared with.
    fn target(&self) -> Result<Target, &'static str> {
        let numbers = [
            self.value.map(Expected::Value),
            self.at_least.map(Expected::AtLeast),
            self.range.map(|[low, high]| Expected::Between(low, high)),
        ];
        let numbers = numbers.into_iter().flatten().map(Target::Number);
        let mut targets = numbers.chain(self.same_as.clone().map(Target::SameAs));
        match (targets.next(), targets.next()) {
            (Some(Target::Number(Expected::Between(low, high))), None) if low > high => {
                Err("expected the lower end of `range` first")
            }
            (target, None) => Ok(target.unwrap_or(Target::Number(Expected::Nothing))),
            _ => Err("expected one of `value`, `at_least`, `range` and `same_as`"),
        }
    }

    /// How far the figure may deviate.
    fn tolerance(&self) -> Result<Tolerance, &'static str> {
        let (limit, tolerance) = match (self.relative, self.absolute) {
            (None, None) => return Ok(Tolerance::None),
            (Some(limit), None) => (limit, Tolerance::Relative(limit)),
            (None, Some(limit)) => (limit, Tolerance::Absolute(limit)),
            (Some(_), Some(_)) => return Err("expected `relative` or `absolute`, not both"),
        };
        let is_limit = limit.is_finite() && limit >= 0.0;
        if is_limit { Ok(tolerance) } else { Err("expected a tolerance of 0 or more") }
    }

    fn read(&self) -> Result<(Target, Tolerance), &'static str> {
        let (target, tolerance) = (self.target()?, self.tolerance()?);
        let is_judged = tolerance != Tolerance::None;
        let singles = [self.value, self.at_least].into_iter().flatten();
        let ends = self.range.into_iter().flatten();
        if singles.chain(ends).chain(self.curve.iter().copied()).any(|number| !number.is_finite()) {
            return Err("expected finite numbers");
        }
        match target {
            Target::Number(Expected::Nothing) if is_judged => {
                Err("expected `value`, `at_least`, `range` or `same_as` beside a tolerance")
            }
            Target::Number(Expected::Nothing | Expected::Between(..)) if !is_judged => {
                Ok((target, tolerance))
            }
            _ if !is_judged => Err("expected `relative` or `absolute`; only a `range` may do without"),
            _ if self.source.is_empty() => Err("expected a `source`: author and year, or the reason"),
            _ => Ok((target, tolerance)),
        }
    }
}

impl TryFrom<Typed> for Expectation {
    type Error = String;

    fn try_from(typed: Typed) -> Result<Self, String> {
        let (target, tolerance) = typed.read().map_err(|why| format!("`{}`: {why}", typed.quantity))?;
        let Typed { quantity, cases, fast, refine, source, curve, .. } = typed;
        let fast = match fast {
            Fast::Same(true) => cases.clone(),
            Fast::Same(false) => Vec::new(),
            Fast::These(these) => these,
        };
        if cases.is_empty() && fast.is_empty() && refine.is_empty() {
            return Err(format!("`{quantity}`: expected `cases`, `fast` or `refine`"));
        }
        Ok(Self { quantity, target, tolerance, source, curve, cases, fast, refine })
    }
}

impl Expectation {
    /// The expected value.
    ///
    /// # Errors
    /// [`VerifyError::Expectation`] if a single number is not what is expected.
    pub fn value(&self) -> Result<f64, VerifyError> {
        match self.target {
            Target::Number(Expected::Value(value)) => Ok(value),
            _ => Err(VerifyError::Expectation(format!("expected a `value` for `{}`", self.quantity))),
        }
    }

    /// The ends of the expected range.
    ///
    /// # Errors
    /// [`VerifyError::Expectation`] if a range is not what is expected.
    pub fn range(&self) -> Result<[f64; 2], VerifyError> {
        match self.target {
            Target::Number(Expected::Between(low, high)) => Ok([low, high]),
            _ => Err(VerifyError::Expectation(format!("expected a `range` for `{}`", self.quantity))),
        }
    }

    /// The variants in a part of the suite, as in the table; `*` stands for any text.
    #[must_use]
    pub fn cases(&self, suite: Suite) -> &[String] {
        match suite {
            Suite::Full => &self.cases,
            Suite::Fast => &self.fast,
            Suite::Refine => &self.refine,
        }
    }

    /// Whether the expectation is about a variant in a part of the suite.
    pub(crate) fn is_about(&self, case: &str, suite: Suite) -> bool {
        self.cases(suite).iter().any(|pattern| matches(pattern, case))
    }
}

/// Whether a text is what a pattern says, in which `*` stands for any text.
#[must_use]
pub fn matches(pattern: &str, text: &str) -> bool {
    match pattern.split_once('*') {
        None => pattern == text,
        Some((before, after)) => text.strip_prefix(before).is_some_and(|rest| {
            let ends = rest.char_indices().map(|(n, _)| n).chain([rest.len()]);
            ends.into_iter().any(|n| matches(after, &rest[n..]))
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_any_text() {
        assert!(matches("B/h = 8", "B/h = 8") && !matches("B/h = 8", "B/h = 80"));
        assert!(matches("*", "") && matches("a*b*", "a b") && !matches("a*b", "ab c"));
        assert!(matches("φ = *°, ψ", "φ = 30°, ψ"));
    }
}
