//! Why a model refuses to answer.

use thiserror::Error;

/// A request that a closed form cannot answer; nothing is ever clamped or guessed instead.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Refusal {
    /// An input lies outside the range in which the formula is valid.
    #[error("{what} = {value} lies outside the valid range {low} to {high}")]
    OutOfRange {
        /// Name and unit of the input.
        what: &'static str,
        /// The value given.
        value: f64,
        /// Smallest valid value.
        low: f64,
        /// Largest valid value.
        high: f64,
    },
    /// The inputs are each valid, but together they have no answer.
    #[error("{what} does not exist here: {why}")]
    DoesNotExist {
        /// The quantity asked for.
        what: &'static str,
        /// The reason, in plain words.
        why: String,
    },
}

/// A number, or the reason why there is none.
pub type Answer<T> = Result<T, Refusal>;

/// `value`, if it is finite and `low ≤ value ≤ high`; an infinite bound leaves that side open.
///
/// The ends are let out by a hair (1e-9), so that 50 degrees converted to radians is still 50 degrees.
pub fn within(what: &'static str, value: f64, low: f64, high: f64) -> Answer<f64> {
    let hair = 1e-9;
    if value.is_finite()
        && value >= low - hair * low.abs().min(1.0)
        && value <= high + hair * high.abs().min(1.0)
    {
        Ok(value)
    } else {
        Err(Refusal::OutOfRange { what, value, low, high })
    }
}

/// `value`, if it is finite and above zero.
pub fn positive(what: &'static str, value: f64) -> Answer<f64> {
    within(what, value, f64::MIN_POSITIVE, f64::MAX)
}

/// `value`, if it is finite and not below zero.
pub fn not_negative(what: &'static str, value: f64) -> Answer<f64> {
    within(what, value, 0.0, f64::MAX)
}

/// `value`, if the arithmetic that made it did not overflow.
pub(crate) fn finite(what: &'static str, value: f64) -> Answer<f64> {
    if value.is_finite() { Ok(value) } else { none(what, "the numbers overflow for this input") }
}

/// The refusal of a quantity that does not exist.
pub(crate) fn none<T>(what: &'static str, why: impl Into<String>) -> Answer<T> {
    Err(Refusal::DoesNotExist { what, why: why.into() })
}
