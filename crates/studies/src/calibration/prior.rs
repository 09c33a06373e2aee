//! What is known of a parameter before the calibration: even over a range, normal, or log-normal.

use numerics::distribution::NORMAL_95;

/// The distribution of a parameter before the calibration, in the unit in which it was typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Prior {
    /// Even between two values.
    Even {
        /// The lower end.
        low: f64,
        /// The higher end.
        high: f64,
    },
    /// Normal.
    Normal {
        /// The mean.
        mean: f64,
        /// The standard deviation.
        deviation: f64,
    },
    /// Normal in the logarithm.
    LogNormal {
        /// The median.
        median: f64,
        /// The factor that is one standard deviation of the logarithm.
        factor: f64,
    },
}

/// Standard deviation of the even distribution over the coordinates 0 to 1, times which coordinates are
/// scaled.
const EVEN: f64 = 3.464_101_615_137_754_5;
/// Half of the width over which designs spread a normal prior, in standard deviations (chosen: 95 % of it).
const SPREAD: f64 = 2.0;

/// Parameters are sampled in coordinates in which each prior has the mean 0 and the standard deviation 1.
impl Prior {
    /// The value at a coordinate.
    #[must_use]
    pub fn value(&self, coordinate: f64) -> f64 {
        match *self {
            Self::Even { low, high } => low + (high - low) * (0.5 + coordinate / EVEN),
            Self::Normal { mean, deviation } => mean + deviation * coordinate,
            Self::LogNormal { median, factor } => median * (factor.ln() * coordinate).exp(),
        }
    }

    /// The coordinate of a value.
    #[must_use]
    pub fn coordinate(&self, value: f64) -> f64 {
        match *self {
            Self::Even { low, high } => EVEN * ((value - low) / (high - low) - 0.5),
            Self::Normal { mean, deviation } => (value - mean) / deviation,
            Self::LogNormal { median, factor } => (value / median).ln() / factor.ln(),
        }
    }

    /// The logarithm of the density at a coordinate, without its constant; −∞ outside a range.
    #[must_use]
    pub fn log_density(&self, coordinate: f64) -> f64 {
        match self {
            Self::Even { .. } if coordinate.abs() > 0.5 * EVEN => f64::NEG_INFINITY,
            Self::Even { .. } => 0.0,
            Self::Normal { .. } | Self::LogNormal { .. } => -0.5 * coordinate * coordinate,
        }
    }

    /// The coordinates over which a design spreads it: the range, or two standard deviations to both sides.
    #[must_use]
    pub fn spread(&self) -> [f64; 2] {
        let half = if let Self::Even { .. } = self { 0.5 * EVEN } else { SPREAD };
        [-half, half]
    }

    /// Width of the 90 % interval of the prior, in coordinates.
    #[must_use]
    pub fn width(&self) -> f64 {
        if let Self::Even { .. } = self { 0.9 * EVEN } else { 2.0 * NORMAL_95 }
    }

    /// Whether the prior is normal in the coordinates, which contributes to a sum of squares.
    #[must_use]
    pub fn is_normal(&self) -> bool {
        !matches!(self, Self::Even { .. })
    }

    /// The prior as it may be typed, with the unit.
    #[must_use]
    pub fn text(&self, unit: &str) -> String {
        let blank = if unit.is_empty() { "" } else { " " };
        match *self {
            Self::Even { low, high } => format!("{low}{blank}{unit}..{high}{blank}{unit}"),
            Self::Normal { mean, deviation } => format!("{mean} ± {deviation}{blank}{unit}"),
            Self::LogNormal { median, factor } => format!("{median}{blank}{unit} */ {factor}"),
        }
    }

    /// Reads a prior and its unit: `28 deg..45 deg`, `33 ± 3 deg`, `32 MPa */ 3`.
    ///
    /// # Errors
    /// What is wrong, and what to write instead.
    pub fn read(text: &str) -> Result<(Self, String), [String; 2]> {
        let cure = "write \"28 deg\"..\"45 deg\", \"33 ± 3 deg\" or \"32 MPa */ 3\"";
        let wrong = |why: String| [why, cure.to_owned()];
        if let Some((low, high)) = text.split_once("..") {
            let ((low, first), (high, second)) = (split(low).map_err(wrong)?, split(high).map_err(wrong)?);
            let unit = common(&first, &second).map_err(wrong)?;
            let prior = Self::Even { low, high };
            return if low < high {
                Ok((prior, unit))
            } else {
                Err(wrong(format!("{low} is not below {high}")))
            };
        }
        if let Some((mean, deviation)) = text.split_once('±').or_else(|| text.split_once("+-")) {
            let ((mean, first), (deviation, second)) =
                (split(mean).map_err(wrong)?, split(deviation).map_err(wrong)?);
            let unit = common(&first, &second).map_err(wrong)?;
            return if deviation > 0.0 {
                Ok((Self::Normal { mean, deviation }, unit))
            } else {
                Err(wrong(format!("the standard deviation {deviation} is not above 0")))
            };
        }
        let Some((median, factor)) = text.split_once("*/") else {
            return Err(wrong(format!("`{text}` is neither a range nor a distribution")));
        };
        let ((median, unit), (factor, more)) = (split(median).map_err(wrong)?, split(factor).map_err(wrong)?);
        let unit = common(&unit, &more).map_err(wrong)?;
        if median > 0.0 && factor > 1.0 {
            return Ok((Self::LogNormal { median, factor }, unit));
        }
        Err(wrong(
            "of a log-normal distribution the median must be above 0 and the factor above 1".to_owned(),
        ))
    }
}

/// A number and its unit.
fn split(text: &str) -> Result<(f64, String), String> {
    let text = text.trim().trim_matches(['"', '\'']).trim().replace('−', "-");
    let ends = text.char_indices().map(|(n, _)| n).skip(1).chain([text.len()]);
    let read = |end: usize| Some((text.get(..end)?.trim().parse::<f64>().ok()?, end));
    match ends.filter_map(read).last() {
        Some((number, end)) if number.is_finite() => Ok((number, text[end..].trim().to_owned())),
        _ => Err(format!("`{text}` does not start with a number")),
    }
}

/// The unit of two numbers, of which one may have none.
fn common(one: &str, other: &str) -> Result<String, String> {
    match (one, other) {
        ("", unit) | (unit, "") => Ok(unit.to_owned()),
        (a, b) if a == b => Ok(a.to_owned()),
        (a, b) => Err(format!("the units {a} and {b} differ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_people_type_is_read() {
        let read = |text: &str| Prior::read(text).unwrap();
        let deg = || "deg".to_owned();
        assert_eq!(read("\"28 deg\"..\"45 deg\""), (Prior::Even { low: 28.0, high: 45.0 }, deg()));
        assert_eq!(read("28..45 deg"), (Prior::Even { low: 28.0, high: 45.0 }, deg()));
        assert_eq!(read("33 ± 3 deg"), (Prior::Normal { mean: 33.0, deviation: 3.0 }, deg()));
        assert_eq!(read("32 MPa */ 3"), (Prior::LogNormal { median: 32.0, factor: 3.0 }, "MPa".to_owned()));
        assert_eq!(read("0.2e-2 */ 3"), (Prior::LogNormal { median: 0.002, factor: 3.0 }, String::new()));
        assert_eq!(read("-0.5..0.5").0, Prior::Even { low: -0.5, high: 0.5 });
        for text in ["28..45 deg", "33 ± 3 deg", "32 MPa */ 3"] {
            let (prior, unit) = read(text);
            assert_eq!(read(&prior.text(&unit)), (prior, unit));
        }
    }

    #[test]
    fn nonsense_is_refused_with_a_cure() {
        for text in [
            "",
            "30 deg",
            "45 deg..28 deg",
            "28 deg..45 rad",
            "a..b",
            "33 ± 0 deg",
            "±",
            "-1 */ 3",
            "1 */ 1",
            "..",
        ] {
            let [message, cure] = Prior::read(text).unwrap_err();
            assert!(!message.is_empty() && cure.contains("deg"), "{text}");
        }
    }

    #[test]
    fn coordinates_have_unit_deviation() {
        for text in ["28..45 deg", "33 ± 3 deg", "32 MPa */ 3"] {
            let (prior, _) = Prior::read(text).unwrap();
            for coordinate in [-1.5, 0.0, 0.7] {
                assert!((prior.coordinate(prior.value(coordinate)) - coordinate).abs() < 1e-12);
            }
        }
        let (even, _) = Prior::read("0..1").unwrap();
        assert_eq!(even.log_density(even.coordinate(1.01)), f64::NEG_INFINITY);
        assert_eq!(even.log_density(even.coordinate(0.99)), 0.0);
    }
}
