//! Steady means with 90 % intervals that know that neighbouring values are correlated.

use coulter::history::blocks::{STUDENT_90, block_averages, standard_error};
use numerics::distribution::student_95;

/// A mean over a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyMean {
    /// The mean [SI].
    pub mean: f64,
    /// Half of the 90 % interval of the mean [SI], where that is known.
    pub half: Option<f64>,
}

impl SteadyMean {
    /// Interval of the mean; the mean alone where that is not known.
    #[must_use]
    pub fn interval(&self) -> [f64; 2] {
        let half = self.half.unwrap_or(0.0);
        [self.mean - half, self.mean + half]
    }

    /// Whether two intervals have a value in common but for round-off; `None` where neither is known.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> Option<bool> {
        self.half.or(other.half)?;
        let slack = ROUND_OFF * self.mean.abs().max(other.mean.abs());
        let ([low, high], [other_low, other_high]) = (self.interval(), other.interval());
        Some(low <= other_high + slack && other_low <= high + slack)
    }
}

/// Part of a mean within which two are the same.
const ROUND_OFF: f64 = 1e-9;
/// Fewest values of an interval.
const FEWEST: usize = 4;

/// The mean of values that follow each other evenly. With 24 or more its interval is that of averages over
/// eight blocks, as of a run; with fewer that of a first-order autoregression: n (1 − ρ)/(1 + ρ) of the n
/// values count. Source: Bayley & Hammersley (1946), The "effective" number of independent observations in an
/// autocorrelated time series, JRSS Supplement 8(2).
#[must_use]
pub fn steady_mean(values: &[f64]) -> Option<SteadyMean> {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    if !mean.is_finite() {
        return None;
    }
    if let Some(blocks) = block_averages(values) {
        return Some(SteadyMean { mean, half: Some(STUDENT_90 * standard_error(&blocks)) });
    }
    if values.len() < FEWEST {
        return Some(SteadyMean { mean, half: None });
    }
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    let products: f64 = values.windows(2).map(|pair| (pair[0] - mean) * (pair[1] - mean)).sum();
    let correlation = if squares > 0.0 { (products / squares).clamp(0.0, 0.9) } else { 0.0 };
    let effective = (count * (1.0 - correlation) / (1.0 + correlation)).max(2.0);
    let error = (squares / (count - 1.0) / effective).sqrt();
    Some(SteadyMean { mean, half: Some(student_95(effective - 1.0) * error) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn correlated_values_determine_a_mean_less_well() {
        let even: Vec<f64> = (0..20).map(|n| f64::from(n % 2)).collect();
        let slow: Vec<f64> = (0..20).map(|n| f64::from(n / 10)).collect();
        let [even, slow] = [even, slow].map(|values| steady_mean(&values).unwrap());
        assert_eq!((even.mean, slow.mean), (0.5, 0.5));
        assert!(slow.half.unwrap() > 2.5 * even.half.unwrap());
        assert_eq!(steady_mean(&[1.0, 2.0]).unwrap().half, None);
        let level = steady_mean(&[1.0; 50]).unwrap();
        let alone = |mean: f64| SteadyMean { mean, half: None };
        assert_eq!(level.overlaps(&alone(1.0)), Some(true));
        assert_eq!(level.overlaps(&alone(1.0 + 3e-16)), Some(true), "round-off");
        assert_eq!(level.overlaps(&alone(1.1)), Some(false));
        assert_eq!(alone(1.0).overlaps(&alone(1.1)), None, "no interval, no verdict");
        assert!(steady_mean(&[]).is_none());
    }
}
