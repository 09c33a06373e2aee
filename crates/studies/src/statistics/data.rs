//! What every statistic asks of its data.

use super::StatisticsError;

/// The number of factors of `inputs`, after a look at all of them and their values. `what` is computed from
/// `least` points or more.
pub(super) fn check(
    inputs: &[Vec<f64>],
    values: &[f64],
    least: usize,
    what: &'static str,
) -> Result<usize, StatisticsError> {
    let (factors, given) = (inputs.first().map_or(0, Vec::len), inputs.len());
    if given < least {
        return Err(StatisticsError::TooFewPoints { what, least, given });
    }
    if values.len() != given {
        let (given, expected) = (values.len(), given);
        return Err(StatisticsError::Shape { point: given.min(expected), given, expected });
    }
    for (point, (input, value)) in inputs.iter().zip(values).enumerate() {
        if input.len() != factors {
            return Err(StatisticsError::Shape { point, given: input.len(), expected: factors });
        }
        if !value.is_finite() || input.iter().any(|x| !x.is_finite()) {
            return Err(StatisticsError::NotFinite { point });
        }
    }
    Ok(factors)
}
