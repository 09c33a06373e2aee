//! The values that are usual for a key: what lies outside is allowed, and doubted.

/// Which values are usual for a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UsualRange {
    /// Low end, as one would write it in a case file.
    pub low: &'static str,
    /// High end.
    pub high: &'static str,
    /// What the range is taken from.
    pub source: &'static str,
}

/// A range, and what it is taken from.
#[must_use]
pub const fn usual(low: &'static str, high: &'static str, source: &'static str) -> UsualRange {
    UsualRange { low, high, source }
}
