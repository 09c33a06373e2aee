//! The range of a number. It stands once, at its key: reading, `validate`, the documentation and the JSON
//! schema take it from there.

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// No end of the range.
    None,
    /// The number itself is allowed.
    Inclusive(f64),
    /// The number itself is not allowed.
    Exclusive(f64),
}

use Bound::{Exclusive, Inclusive};

/// Which numbers a key allows, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllowedRange {
    /// Low end.
    pub low: Bound,
    /// High end.
    pub high: Bound,
    /// What a number outside would mean; empty where that is plain.
    pub why: &'static str,
}

/// A range without reason.
#[must_use]
pub const fn from(low: Bound, high: Bound) -> AllowedRange {
    AllowedRange { low, high, why: "" }
}

impl AllowedRange {
    /// Whether the range contains a number; not-a-number is in no range.
    #[must_use]
    pub fn contains(&self, number: f64) -> bool {
        let low = match self.low {
            Bound::None => !number.is_nan(),
            Inclusive(low) => number >= low,
            Exclusive(low) => number > low,
        };
        let high = match self.high {
            Bound::None => !number.is_nan(),
            Inclusive(high) => number <= high,
            Exclusive(high) => number < high,
        };
        low && high
    }

    /// The range in words; `shown` writes a number with its unit.
    #[must_use]
    pub fn text(&self, shown: impl Fn(f64) -> String) -> String {
        // Zero alone needs no unit.
        let alone = |number: f64| if number == 0.0 { "0".to_owned() } else { shown(number) };
        let text = match (self.low, self.high) {
            (Bound::None, Bound::None) => "any number".to_owned(),
            (Bound::None, Inclusive(high)) => format!("at most {}", alone(high)),
            (Bound::None, Exclusive(high)) => format!("below {}", alone(high)),
            (Inclusive(low), Bound::None) => format!("{} or more", alone(low)),
            (Exclusive(low), Bound::None) => format!("above {}", alone(low)),
            (Inclusive(low), Inclusive(high)) => format!("from {} to {}", shown(low), shown(high)),
            (Inclusive(low), Exclusive(high)) => format!("{} or more and below {}", shown(low), shown(high)),
            (Exclusive(low), Inclusive(high)) => format!("above {} and at most {}", shown(low), shown(high)),
            (Exclusive(low), Exclusive(high)) => format!("above {} and below {}", shown(low), shown(high)),
        };
        if self.why.is_empty() { text } else { format!("{text} ({})", self.why) }
    }
}
