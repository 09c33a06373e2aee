//! Why a model refuses to answer.

use thiserror::Error;

/// A request that a closed form cannot answer; nothing is ever clamped or guessed instead.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Refusal {
    /// An input lies outside the range in which the formula is valid.
    #[error("{}", range(what, *value, *low, *high))]
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

/// The message of a value out of range; angles in degrees, which is what people type.
fn range(what: &str, value: f64, low: f64, high: f64) -> String {
    let (name, unit) = match what.split_once(" [") {
        Some((name, unit)) => (name, unit.trim_end_matches(']')),
        None => (what, ""),
    };
    let (size, unit) =
        if unit == "rad" { (1_f64.to_radians(), "°".to_owned()) } else { (1.0, format!(" {unit}")) };
    let unit = unit.trim_end();
    let shown = |x: f64| {
        let x = x / size;
        let plain = x == 0.0 || (1e-3..1e5).contains(&x.abs());
        // Six digits, and no zeros behind them.
        if plain { format!("{}{unit}", (x * 1e6).round() / 1e6) } else { format!("{x:.5e}{unit}") }
    };
    let wanted = match (low, high) {
        (f64::MIN_POSITIVE, f64::MAX) => "it must be above 0".to_owned(),
        (0.0, f64::MAX) => "it must be 0 or more".to_owned(),
        (f64::MIN_POSITIVE, high) => format!("it must be above 0 and at most {}", shown(high)),
        (low, f64::MAX) => format!("it must be {} or more", shown(low)),
        (low, high) => format!("the valid range is {} to {}", shown(low), shown(high)),
    };
    format!("{name} = {} is out of range: {wanted}", shown(value))
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
