//! One line of the verification table: what was expected, what came out, and whether that is near enough.

use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What a benchmark expects.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Expected {
    /// This value.
    Value(f64),
    /// At least this value.
    AtLeast(f64),
    /// Something from the first to the second value.
    Between(f64, f64),
    /// Nothing is published: the figure is for information.
    Nothing,
}

/// How far a figure may be off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tolerance {
    /// This share of the expected value (of the nearer end of a range).
    Relative(f64),
    /// This much, in the unit of the quantity.
    Absolute(f64),
    /// No judgement is made.
    None,
}

/// One line of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Benchmark, as in the design's list: "B1".
    #[serde(skip)]
    pub id: &'static str,
    /// Which variant: "B/h = 16".
    pub case: String,
    /// What was measured, with its unit.
    pub quantity: String,
    /// What it should be.
    pub expected: Expected,
    /// What it is.
    pub obtained: f64,
    /// How far it may be off.
    pub tolerance: Tolerance,
    /// Where the expectation comes from.
    pub source: Cow<'static, str>,
    /// Wall clock of the runs behind it [s].
    pub seconds: f64,
}

impl Row {
    /// A figure for information.
    #[must_use]
    pub fn note(id: &'static str, case: impl Into<String>, quantity: &str, obtained: f64) -> Self {
        Self {
            id,
            case: case.into(),
            quantity: quantity.to_owned(),
            expected: Expected::Nothing,
            obtained,
            tolerance: Tolerance::None,
            source: "".into(),
            seconds: 0.0,
        }
    }

    /// The same figure, expected to be `value` within a share of it.
    #[must_use]
    pub fn within(self, value: f64, share: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Value(value),
            tolerance: Tolerance::Relative(share),
            source: source.into(),
            ..self
        }
    }

    /// The same figure, expected to be 0 but for `limit`.
    #[must_use]
    pub fn at_most(self, limit: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Value(0.0),
            tolerance: Tolerance::Absolute(limit),
            source: source.into(),
            ..self
        }
    }

    /// The same figure, expected to be at least `value`.
    #[must_use]
    pub fn at_least(self, value: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::AtLeast(value),
            tolerance: Tolerance::Absolute(0.0),
            source: source.into(),
            ..self
        }
    }

    /// The same figure, expected to lie between two values, give or take a share of them.
    #[must_use]
    pub fn between(self, low: f64, high: f64, share: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Between(low, high),
            tolerance: Tolerance::Relative(share),
            source: source.into(),
            ..self
        }
    }

    /// The same figure beside what somebody else got: inside that range or outside, which is neither pass nor failure.
    #[must_use]
    pub fn beside(self, low: f64, high: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Between(low, high),
            tolerance: Tolerance::None,
            source: source.into(),
            ..self
        }
    }

    /// The same figure with the wall clock of the runs behind it [s].
    #[must_use]
    pub fn took(self, seconds: f64) -> Self {
        Self { seconds, ..self }
    }

    /// How far off the figure is: a share of the expected value where the tolerance is one, else in the quantity's unit.
    #[must_use]
    pub fn error(&self) -> Option<f64> {
        let (off, scale) = match self.expected {
            Expected::Value(value) => (self.obtained - value, value),
            Expected::AtLeast(value) if self.obtained >= value => (0.0, value),
            Expected::AtLeast(value) => (self.obtained - value, value),
            Expected::Between(low, _) if self.obtained < low => (self.obtained - low, low),
            Expected::Between(_, high) if self.obtained > high => (self.obtained - high, high),
            Expected::Between(..) if self.obtained.is_nan() => (f64::NAN, 1.0),
            Expected::Between(..) => (0.0, 1.0),
            Expected::Nothing => return None,
        };
        let is_absolute = matches!(self.tolerance, Tolerance::Absolute(_));
        Some(if is_absolute || scale == 0.0 { off } else { off / scale.abs() })
    }

    /// Whether a figure without tolerance lies in the range that it stands beside; `None` for one that is judged, and for one
    /// that has only a single value beside it, which no figure without tolerance can be inside.
    #[must_use]
    pub fn is_inside(&self) -> Option<bool> {
        match (self.tolerance, self.expected) {
            (Tolerance::None, Expected::Between(low, high)) if low < high => {
                Some((low..=high).contains(&self.obtained))
            }
            _ => None,
        }
    }

    /// What is said of it.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match (self.passes(), self.is_inside()) {
            (Some(true), _) => Verdict::Pass,
            (Some(false), _) => Verdict::FallsShort,
            (None, Some(true)) => Verdict::Inside,
            (None, Some(false)) => Verdict::Outside,
            (None, None) => Verdict::None,
        }
    }

    /// Whether it is near enough; `None` for a figure that is only told.
    #[must_use]
    pub fn passes(&self) -> Option<bool> {
        let (Tolerance::Relative(limit) | Tolerance::Absolute(limit)) = self.tolerance else { return None };
        self.error().map(|error| error.abs() <= limit)
    }
}

/// What is said of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Within its tolerance.
    Pass,
    /// Outside it.
    FallsShort,
    /// Without a tolerance, and within the range that others published.
    Inside,
    /// Without a tolerance, and outside that range.
    Outside,
    /// There is nothing to compare it with.
    None,
}

impl Verdict {
    /// The word of the tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::FallsShort => "falls short",
            Self::Inside => "inside",
            Self::Outside => "outside",
            Self::None => "–",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(obtained: f64) -> Row {
        Row::note("X1", "case", "quantity", obtained)
    }

    #[test]
    fn a_figure_passes_within_its_tolerance_only() {
        assert_eq!(row(5.2).within(5.0, 0.05, "").passes(), Some(true));
        assert_eq!(row(4.7).within(5.0, 0.05, "").passes(), Some(false));
        assert_eq!(row(-2e-12).at_most(1e-12, "").passes(), Some(false));
        assert_eq!(row(1.6).at_least(1.5, "").passes(), Some(true));
        assert_eq!(row(1.4).at_least(1.5, "").passes(), Some(false));
        assert_eq!(row(1.1).between(1.2, 1.8, 0.1, "").passes(), Some(true));
        assert_eq!(row(2.1).between(1.2, 1.8, 0.1, "").passes(), Some(false));
        assert_eq!(row(2.1).passes(), None);
    }

    #[test]
    fn a_figure_beside_a_range_is_inside_or_outside_it() {
        let verdict = |obtained: f64| row(obtained).beside(15.0, 17.0, "").verdict();
        assert_eq!(
            [16.0, 14.4, f64::NAN].map(verdict),
            [Verdict::Inside, Verdict::Outside, Verdict::Outside]
        );
        assert_eq!(row(1.0).verdict(), Verdict::None);
        assert_eq!(row(5.0).beside(5.1, 5.1, "").is_inside(), None, "a single value is no range");
        assert_eq!(row(5.2).within(5.0, 0.05, "").is_inside(), None);
    }

    #[test]
    fn what_is_not_a_number_never_passes() {
        assert_eq!(row(f64::NAN).within(5.0, 0.05, "").passes(), Some(false));
        assert_eq!(row(f64::NAN).at_least(5.0, "").passes(), Some(false));
        assert_eq!(row(f64::NAN).between(1.0, 2.0, 0.1, "").passes(), Some(false));
    }
}
