//! One line of the verification table: what was expected, what was obtained, and whether that is close
//! enough.

use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What a benchmark expects.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Expected {
    /// The figure is to have this value.
    Value(f64),
    /// The figure is to have at least this value.
    AtLeast(f64),
    /// The figure is to lie from the first to the second value.
    Between(f64, f64),
    /// No expectation: the figure is for information.
    Nothing,
}

/// How far a figure may deviate from what is expected.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tolerance {
    /// A fraction of the expected value (of the nearer end of a range).
    Relative(f64),
    /// A number, in the unit of the quantity.
    Absolute(f64),
    /// The figure is not judged.
    None,
}

/// One line of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Benchmark, as in the design's list: "B1".
    #[serde(skip)]
    pub id: &'static str,
    /// Variant of the benchmark: "B/h = 16".
    pub case: String,
    /// The quantity that was measured, with its unit.
    pub quantity: String,
    /// The expected value.
    pub expected: Expected,
    /// The value obtained.
    pub obtained: f64,
    /// How far the value may deviate.
    pub tolerance: Tolerance,
    /// Source of the expected value.
    pub source: Cow<'static, str>,
    /// Wall-clock time of the runs behind the value [s].
    pub seconds: f64,
}

impl Row {
    /// An info row: a figure that is not judged.
    #[must_use]
    pub fn info(id: &'static str, case: impl Into<String>, quantity: &str, obtained: f64) -> Self {
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

    /// The row with what is expected of its figure.
    #[must_use]
    pub(crate) fn expecting(self, expected: Expected, tolerance: Tolerance, source: &'static str) -> Self {
        Self { expected, tolerance, source: source.into(), ..self }
    }

    /// The row with the wall-clock time of the runs behind its figure [s].
    #[must_use]
    pub fn took(self, seconds: f64) -> Self {
        Self { seconds, ..self }
    }

    /// Deviation from the expected value: a fraction of it where the tolerance is one, otherwise in the
    /// quantity's unit.
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

    /// Whether a comparison row lies in its range; `None` for a row that is judged, and for one that is
    /// compared with a single value, which is no range.
    #[must_use]
    pub fn is_inside(&self) -> Option<bool> {
        match (self.tolerance, self.expected) {
            (Tolerance::None, Expected::Between(low, high)) if low < high => {
                Some((low..=high).contains(&self.obtained))
            }
            _ => None,
        }
    }

    /// The judgement on the row.
    #[must_use]
    pub fn judgement(&self) -> Judgement {
        match (self.passes(), self.is_inside()) {
            (Some(true), _) => Judgement::Pass,
            (Some(false), _) => Judgement::Fails,
            (None, Some(true)) => Judgement::Inside,
            (None, Some(false)) => Judgement::Outside,
            (None, None) => Judgement::None,
        }
    }

    /// Whether the row is within its tolerance; `None` for an info or comparison row.
    #[must_use]
    pub fn passes(&self) -> Option<bool> {
        let (Tolerance::Relative(limit) | Tolerance::Absolute(limit)) = self.tolerance else { return None };
        self.error().map(|error| error.abs() <= limit)
    }
}

/// The judgement on a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// A row within its tolerance.
    Pass,
    /// A row outside its tolerance.
    Fails,
    /// A comparison row within its published range.
    Inside,
    /// A comparison row outside its published range.
    Outside,
    /// An info row, or one compared with a single value.
    None,
}

impl Judgement {
    /// The word in the tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fails => "fails",
            Self::Inside => "inside",
            Self::Outside => "outside",
            Self::None => "–",
        }
    }
}

/// Rows for the tests of this crate.
#[cfg(test)]
impl Row {
    /// The row, its figure expected to be `value` within a fraction of it.
    #[must_use]
    pub fn within(self, value: f64, fraction: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Value(value),
            tolerance: Tolerance::Relative(fraction),
            source: source.into(),
            ..self
        }
    }

    /// The row, its figure expected to be 0 within `limit`.
    #[must_use]
    pub fn at_most(self, limit: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Value(0.0),
            tolerance: Tolerance::Absolute(limit),
            source: source.into(),
            ..self
        }
    }

    /// The row, its figure expected to be at least `value`.
    #[must_use]
    pub fn at_least(self, value: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::AtLeast(value),
            tolerance: Tolerance::Absolute(0.0),
            source: source.into(),
            ..self
        }
    }

    /// The row, its figure expected to lie between two values, within a fraction of them.
    #[must_use]
    pub fn between(self, low: f64, high: f64, fraction: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Between(low, high),
            tolerance: Tolerance::Relative(fraction),
            source: source.into(),
            ..self
        }
    }

    /// A comparison row: the same figure compared with a published range. It lies inside or outside, and
    /// neither passes nor fails.
    #[must_use]
    pub fn compared_with(self, low: f64, high: f64, source: &'static str) -> Self {
        Self {
            expected: Expected::Between(low, high),
            tolerance: Tolerance::None,
            source: source.into(),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(obtained: f64) -> Row {
        Row::info("X1", "case", "quantity", obtained)
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
    fn a_comparison_row_is_inside_or_outside_its_range() {
        let judgement = |obtained: f64| row(obtained).compared_with(15.0, 17.0, "").judgement();
        assert_eq!(
            [16.0, 14.4, f64::NAN].map(judgement),
            [Judgement::Inside, Judgement::Outside, Judgement::Outside]
        );
        assert_eq!(row(1.0).judgement(), Judgement::None);
        assert_eq!(row(5.0).compared_with(5.1, 5.1, "").is_inside(), None, "a single value is no range");
        assert_eq!(row(5.2).within(5.0, 0.05, "").is_inside(), None);
    }

    #[test]
    fn what_is_not_a_number_never_passes() {
        assert_eq!(row(f64::NAN).within(5.0, 0.05, "").passes(), Some(false));
        assert_eq!(row(f64::NAN).at_least(5.0, "").passes(), Some(false));
        assert_eq!(row(f64::NAN).between(1.0, 2.0, 0.1, "").passes(), Some(false));
    }
}
