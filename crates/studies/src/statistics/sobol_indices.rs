//! Sobol indices: the portions of the variance of a response that its factors cause.
//!
//! Factors are independent and evenly distributed over the unit cube. First-order index S_i = V[E(y | x_i)] /
//! V(y); total index T_i = E[V(y | all but x_i)] / V(y). Sums run over rows of two samples A and B and of the
//! A_Bⁱ, which are A with factor i from B.

use super::StatisticsError;
use super::design::{SOBOL_FACTORS, generator, sobol};
use super::gaussian_process::GaussianProcess;
use numerics::quantile;

/// Rows of a sample by default (chosen): a power of two, indices of smooth functions to about 0.01.
pub const ROWS: usize = 4096;
/// Fewest rows (chosen).
const LEAST_ROWS: usize = 16;
/// Samples of the bootstrap (chosen).
const RESAMPLED: usize = 400;
/// A variance below this portion of the mean's square is rounding (chosen).
const ROUNDING: f64 = 1e-20;

/// An index with its interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index {
    /// Estimate of the index [–].
    pub value: f64,
    /// Lower and upper end of the 90 % interval of the index [–].
    pub interval: [f64; 2],
}

/// The Sobol indices of a response, one of each kind for each factor.
#[derive(Clone, Debug, PartialEq)]
pub struct SobolIndices {
    /// First-order indices: the portion of the variance that vanishes when this factor is known.
    pub first_order: Vec<Index>,
    /// Total indices: the portion that remains when all others are known.
    pub total: Vec<Index>,
    /// Mean of the response, in its unit.
    pub mean: f64,
    /// Standard deviation of the response, in its unit.
    pub deviation: f64,
    /// Evaluations of the response.
    pub evaluations: usize,
    /// Predictivity Q² of the surrogate that stood for the response [–]; `None` where the response itself was
    /// evaluated.
    pub predictivity: Option<f64>,
}

/// The indices of `response` over the unit cube of `factors` factors, from `rows` × (factors + 2)
/// evaluations.
///
/// First-order: Saltelli et al. (2010), Comput. Phys. Commun. 181, table 2 (b); total: Jansen (1999), Comput.
/// Phys. Commun. 117. A and B are the halves of one Sobol sequence, of more than ten factors random numbers.
/// Intervals: bootstrap over the rows, 5 % and 95 %.
///
/// # Errors
/// [`StatisticsError`] without factors, with fewer than 16 rows, with a response that is not finite or does
/// not vary.
pub fn sobol_indices(
    response: impl Fn(&[f64]) -> f64,
    factors: usize,
    rows: usize,
    seed: u64,
) -> Result<SobolIndices, StatisticsError> {
    if rows < LEAST_ROWS {
        return Err(StatisticsError::TooFewPoints { what: "a Sobol index", least: LEAST_ROWS, given: rows });
    }
    let sample = Sample::of(&response, factors, rows, seed)?;
    let all: Vec<usize> = (0..rows).collect();
    let whole = sample.estimates(&all);
    let mut random = generator(seed ^ 0x5eed);
    let mut again: Vec<Vec<f64>> = vec![Vec::with_capacity(RESAMPLED); 2 * factors];
    for _ in 0..RESAMPLED {
        let drawn: Vec<usize> = (0..rows).map(|_| random.below(rows)).collect();
        for (list, value) in again.iter_mut().zip(sample.estimates(&drawn)) {
            list.push(value);
        }
    }
    let mut indices = whole
        .iter()
        .zip(again)
        .map(|(value, list)| Index { value: *value, interval: [0.05, 0.95].map(|p| quantile(&list, p)) });
    Ok(SobolIndices {
        first_order: indices.by_ref().take(factors).collect(),
        total: indices.collect(),
        mean: sample.mean,
        deviation: sample.variance.sqrt(),
        evaluations: rows * (factors + 2),
        predictivity: None,
    })
}

/// The indices of a response that a surrogate stands for, over the box `ranges` of its factors (lowest,
/// highest value of each).
///
/// What the surrogate leaves unexplained, 1 − Q² of the variance, may belong to any factor or to none: the
/// interval of an index s is widened from [a, b] to [Q² a, Q² b + 1 − Q²] (chosen), which the bootstrap alone
/// would not know.
///
/// # Errors
/// As [`sobol_indices`]; [`StatisticsError::NotPredictive`] for a surrogate that does not predict.
pub fn sobol_indices_of_surrogate(
    surrogate: &GaussianProcess,
    ranges: &[[f64; 2]],
    rows: usize,
    seed: u64,
) -> Result<SobolIndices, StatisticsError> {
    let predictivity = surrogate.trusted()?.predictivity();
    let place = |x: &[f64]| -> Vec<f64> {
        x.iter().zip(ranges).map(|(x, [low, high])| low + x * (high - low)).collect()
    };
    let mut indices = sobol_indices(|x| surrogate.mean(&place(x)), ranges.len(), rows, seed)?;
    for index in indices.first_order.iter_mut().chain(&mut indices.total) {
        let [low, high] = index.interval;
        index.interval = [predictivity * low, predictivity * high + 1.0 - predictivity];
    }
    indices.predictivity = Some(predictivity);
    Ok(indices)
}

/// Values of the response: f_A, f_B, and f_ABⁱ of every factor, row by row.
struct Sample {
    factors: usize,
    values: Vec<Vec<f64>>,
    mean: f64,
    variance: f64,
}

impl Sample {
    fn of(
        response: &impl Fn(&[f64]) -> f64,
        factors: usize,
        rows: usize,
        seed: u64,
    ) -> Result<Self, StatisticsError> {
        let evaluated = |pair: &Vec<f64>| {
            let (first, second) = pair.split_at(factors);
            let mut values = vec![response(first), response(second)];
            let mut mixed = first.to_vec();
            for i in 0..factors {
                mixed[i] = second[i];
                values.push(response(&mixed));
                mixed[i] = first[i];
            }
            values
        };
        let values: Vec<Vec<f64>> = pairs(factors, rows, seed)?.iter().map(evaluated).collect();
        if let Some(point) = values.iter().position(|row| row.iter().any(|y| !y.is_finite())) {
            return Err(StatisticsError::NotFinite { point });
        }
        let count = 2.0 * rows as f64;
        let mean = values.iter().map(|row| row[0] + row[1]).sum::<f64>() / count;
        let squares = |row: &Vec<f64>| (row[0] - mean) * (row[0] - mean) + (row[1] - mean) * (row[1] - mean);
        let variance = values.iter().map(squares).sum::<f64>() / count;
        if variance <= ROUNDING * mean * mean || variance == 0.0 {
            return Err(StatisticsError::NoVariance);
        }
        Ok(Self { factors, values, mean, variance })
    }

    /// First-order indices, then total ones, from the rows drawn.
    fn estimates(&self, drawn: &[usize]) -> Vec<f64> {
        let rows = || drawn.iter().map(|n| &self.values[*n]);
        let count = drawn.len() as f64;
        let mean = rows().map(|row| row[0] + row[1]).sum::<f64>() / (2.0 * count);
        let square = |y: f64| (y - mean) * (y - mean);
        let variance = rows().map(|row| square(row[0]) + square(row[1])).sum::<f64>() / (2.0 * count);
        // Rows without a variance can only be drawn where almost all are alike.
        let scale = if variance > 0.0 { 1.0 / (count * variance) } else { 0.0 };
        let mut sums = vec![0.0; 2 * self.factors];
        for row in rows() {
            for i in 0..self.factors {
                let change = row[i + 2] - row[0];
                // Centred, against cancellation where the mean is large.
                sums[i] += (row[1] - mean) * change;
                sums[self.factors + i] += 0.5 * change * change;
            }
        }
        sums.iter().map(|sum| scale * sum).collect()
    }
}

/// Rows of A and B side by side.
fn pairs(factors: usize, rows: usize, seed: u64) -> Result<Vec<Vec<f64>>, StatisticsError> {
    if 2 * factors <= SOBOL_FACTORS {
        return sobol(rows, 2 * factors, seed);
    }
    let mut random = generator(seed);
    Ok((0..rows).map(|_| (0..2 * factors).map(|_| random.uniform()).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::super::design::latin_hypercube;
    use super::super::gaussian_process::fit;
    use super::*;
    use std::f64::consts::PI;

    /// Ishigami & Homma (1990), a = 7, b = 0.1.
    fn ishigami(x: &[f64]) -> f64 {
        let [a, b, c] = [0, 1, 2].map(|i| PI * (2.0 * x[i] - 1.0));
        a.sin() + 7.0 * b.sin().powi(2) + 0.1 * c.powi(4) * a.sin()
    }
    const ISHIGAMI_FIRST: [f64; 3] = [0.3139, 0.4424, 0.0];
    const ISHIGAMI_TOTAL: [f64; 3] = [0.5576, 0.4424, 0.2437];

    fn close(indices: &[Index], exact: &[f64], tolerance: f64) {
        for (index, exact) in indices.iter().zip(exact) {
            assert!((index.value - exact).abs() < tolerance, "{indices:?} {exact:?}");
            let slack = 0.2 * tolerance;
            assert!(index.interval[0] <= exact + slack && index.interval[1] >= exact - slack, "{indices:?}");
        }
    }

    #[test]
    fn indices_of_ishigami_are_those_of_the_formula() {
        let indices = sobol_indices(ishigami, 3, ROWS, 1).unwrap();
        close(&indices.first_order, &ISHIGAMI_FIRST, 0.01);
        close(&indices.total, &ISHIGAMI_TOTAL, 0.01);
        assert_eq!((indices.evaluations, indices.predictivity), (5 * ROWS, None));
        assert!((indices.mean - 3.5).abs() < 0.02 && (indices.deviation.powi(2) - 13.845).abs() < 0.1);
    }

    #[test]
    fn indices_of_the_g_function_are_those_of_the_formula() {
        // Sobol's g-function: V_i = 1 / (3 (1 + a_i)²), V = Π (1 + V_i) − 1. Twelve factors: random numbers.
        let a = |i: usize| [0.0, 1.0, 4.5, 9.0, 99.0][i.min(4)];
        for factors in [6, 12] {
            let g = |x: &[f64]| {
                let factor = |(i, x): (usize, &f64)| ((4.0 * x - 2.0).abs() + a(i)) / (1.0 + a(i));
                x.iter().enumerate().map(factor).product::<f64>()
            };
            let part: Vec<f64> = (0..factors).map(|i| 1.0 / (3.0 * (1.0 + a(i)).powi(2))).collect();
            let all: f64 = part.iter().map(|v| 1.0 + v).product();
            let first: Vec<f64> = part.iter().map(|v| v / (all - 1.0)).collect();
            let total: Vec<f64> = part.iter().map(|v| v * all / (1.0 + v) / (all - 1.0)).collect();
            let (rows, tolerance) = if factors == 6 { (4096, 0.02) } else { (16384, 0.04) };
            let indices = sobol_indices(g, factors, rows, 3).unwrap();
            for (found, exact) in [(&indices.first_order, &first), (&indices.total, &total)] {
                assert!(
                    found.iter().zip(exact).all(|(s, e)| (s.value - e).abs() < tolerance),
                    "{found:?} {exact:?}"
                );
            }
        }
    }

    #[test]
    fn a_surrogate_finds_the_indices_of_what_it_stands_for() {
        let ranges = [[-2.0, 2.0], [10.0, 20.0], [0.0, 1.0]];
        let design = latin_hypercube(150, 3, 1).unwrap();
        let values: Vec<f64> = design.iter().map(|x| ishigami(x)).collect();
        let shown: Vec<Vec<f64>> = design
            .iter()
            .map(|x| x.iter().zip(&ranges).map(|(x, [low, high])| low + x * (high - low)).collect())
            .collect();
        let surrogate = fit(&shown, &values).unwrap();
        let indices = sobol_indices_of_surrogate(&surrogate, &ranges, ROWS, 1).unwrap();
        close(&indices.first_order, &ISHIGAMI_FIRST, 0.04);
        close(&indices.total, &ISHIGAMI_TOTAL, 0.04);
        assert_eq!(indices.predictivity, Some(surrogate.predictivity()));
    }

    #[test]
    fn what_has_no_indices_is_refused() {
        assert_eq!(sobol_indices(|_| 1.0, 2, 64, 0), Err(StatisticsError::NoVariance));
        assert!(matches!(sobol_indices(|x| x[0], 1, 8, 0), Err(StatisticsError::TooFewPoints { .. })));
        assert!(matches!(
            sobol_indices(|x| 1.0 / (x[0] - x[0]), 1, 64, 0),
            Err(StatisticsError::NotFinite { .. })
        ));
        assert!(matches!(sobol_indices(|_| 0.0, 0, 64, 0), Err(StatisticsError::Design { .. })));
    }
}
