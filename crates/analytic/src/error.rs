//! Why a model has no result.

use thiserror::Error;

/// Why a closed form has no result; no input is ever clamped and no result guessed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ModelError {
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
    /// Each input is valid, but the formula has no solution for their combination.
    #[error("{what} does not exist here: {why}")]
    DoesNotExist {
        /// The quantity asked for.
        what: &'static str,
        /// The reason, for the user.
        why: String,
    },
}

/// The message for a value out of range; angles in degrees, as users write them.
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
        // At most six decimals, without trailing zeros.
        if plain { format!("{}{unit}", (x * 1e6).round() / 1e6) } else { format!("{x:.5e}{unit}") }
    };
    let valid = match (low, high) {
        (f64::MIN_POSITIVE, f64::MAX) => "it must be above 0".to_owned(),
        (0.0, f64::MAX) => "it must be 0 or more".to_owned(),
        (f64::MIN_POSITIVE, high) => format!("it must be above 0 and at most {}", shown(high)),
        (low, f64::MAX) => format!("it must be {} or more", shown(low)),
        (low, high) => format!("the valid range is {} to {}", shown(low), shown(high)),
    };
    format!("{name} = {} is out of range: {valid}", shown(value))
}

/// The result of a closed form, or the reason why it has none.
pub type ModelResult<T> = Result<T, ModelError>;

/// `value`, if it is finite and `low ≤ value ≤ high`.
///
/// The bounds are relaxed by 1e-9, so that 50 degrees converted to radians still counts as 50 degrees.
///
/// # Errors
/// [`ModelError::OutOfRange`] otherwise.
pub fn within(what: &'static str, value: f64, low: f64, high: f64) -> ModelResult<f64> {
    let tolerance = 1e-9;
    if value.is_finite()
        && value >= low - tolerance * low.abs().min(1.0)
        && value <= high + tolerance * high.abs().min(1.0)
    {
        Ok(value)
    } else {
        Err(ModelError::OutOfRange { what, value, low, high })
    }
}

/// `value`, if it is finite and above zero.
///
/// # Errors
/// [`ModelError::OutOfRange`] otherwise.
pub fn positive(what: &'static str, value: f64) -> ModelResult<f64> {
    within(what, value, f64::MIN_POSITIVE, f64::MAX)
}

/// `value`, if it is finite and not below zero.
///
/// # Errors
/// [`ModelError::OutOfRange`] otherwise.
pub fn non_negative(what: &'static str, value: f64) -> ModelResult<f64> {
    within(what, value, 0.0, f64::MAX)
}

/// `value`, unless its computation overflowed.
pub(crate) fn finite(what: &'static str, value: f64) -> ModelResult<f64> {
    if value.is_finite() { Ok(value) } else { undefined(what, "the numbers overflow for this input") }
}

/// The error for a quantity that does not exist for the given input.
pub(crate) fn undefined<T>(what: &'static str, why: impl Into<String>) -> ModelResult<T> {
    Err(ModelError::DoesNotExist { what, why: why.into() })
}
