//! Quasi-Monte Carlo propagation: intervals and Sobol indices.

use crate::error::{ModelResult, positive, undefined, within};
use numerics::sequence::DIMENSIONS;
use numerics::{Distribution, Sequence, quantile_of_sorted};

/// Distribution of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct Uncertainty {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Quantiles of 5 %, 50 % and 95 %.
    pub quantiles: [f64; 3],
    /// First-order Sobol index of each input: the fraction of the variance that would vanish if it were
    /// known.
    pub first_order: Vec<f64>,
    /// Total Sobol index of each input: the fraction that would remain if all others were known.
    pub total: Vec<f64>,
    /// Number of evaluations.
    pub evaluations: usize,
    /// Fraction of the samples without a result; they are excluded from the statistics.
    pub failed: f64,
}

/// Propagates `distributions` through `model`, which returns N numbers at once, with about `evaluations`
/// evaluations.
///
/// First-order indices by Saltelli et al. (2010), Comput. Phys. Commun. 181, eq. (b), total by Jansen (1999),
/// on two halves of one Sobol sequence in twice as many dimensions. Reproducible: the same `seed` gives the
/// same result.
///
/// # Errors
/// With no input or more than ten, fewer than 64 or more than 10⁸ evaluations, a distribution without width,
/// or a model without a result for more than nine samples in ten.
pub fn propagate<const N: usize>(
    distributions: &[Distribution],
    evaluations: usize,
    seed: u64,
    model: impl Fn(&[f64]) -> Option<[f64; N]>,
) -> ModelResult<[Uncertainty; N]> {
    let inputs = distributions.len();
    within("number of uncertain inputs", inputs as f64, 1.0, (DIMENSIONS / 2) as f64)?;
    within("evaluations", evaluations as f64, 64.0, 1e8)?;
    distributions.iter().try_for_each(check)?;
    let rows = (evaluations / (inputs + 2)).max(8);
    let results = sample(distributions, rows, seed, model);
    if results.len() * 10 < rows {
        return undefined("the uncertainty", "the model has no result for more than nine samples in ten");
    }
    Ok(std::array::from_fn(|n| summarise(&results, n, inputs, rows)))
}

/// Refuses a distribution with a parameter that is not finite or a width that is not positive.
fn check(distribution: &Distribution) -> ModelResult<()> {
    match *distribution {
        Distribution::Uniform { low, high } => {
            within("smallest value", low, f64::MIN, f64::MAX)?;
            positive("width of the distribution", high - low)?;
        }
        Distribution::Normal { mean, deviation } => {
            within("mean", mean, f64::MIN, f64::MAX)?;
            positive("standard deviation", deviation)?;
        }
        Distribution::LogNormal { median, log_deviation } => {
            positive("median", median)?;
            within("standard deviation of the logarithm", log_deviation, 1e-12, 5.0)?;
        }
    }
    Ok(())
}

/// Rows of results (f_A, f_B, f_AB₁, …), without those in which a sample has no result.
fn sample<const N: usize>(
    distributions: &[Distribution],
    rows: usize,
    seed: u64,
    model: impl Fn(&[f64]) -> Option<[f64; N]>,
) -> Vec<Vec<[f64; N]>> {
    let inputs = distributions.len();
    let mut sequence = Sequence::new(2 * inputs, seed);
    let mut point = vec![0.0; 2 * inputs];
    let mut results = Vec::with_capacity(rows);
    for _ in 0..rows {
        sequence.next_point(&mut point);
        let value = |half: usize, i: usize| distributions[i].quantile(point[half * inputs + i]);
        let first: Vec<f64> = (0..inputs).map(|i| value(0, i)).collect();
        let second: Vec<f64> = (0..inputs).map(|i| value(1, i)).collect();
        let mixed = (0..inputs).map(|i| {
            let mut mixed = first.clone();
            mixed[i] = second[i];
            mixed
        });
        let points = [first.clone(), second.clone()].into_iter().chain(mixed);
        let result = |x: Vec<f64>| model(&x).filter(|y| y.iter().all(|y| y.is_finite()));
        let row: Option<Vec<[f64; N]>> = points.map(result).collect();
        results.extend(row);
    }
    results
}

/// Statistics of the n-th number of every result.
fn summarise<const N: usize>(results: &[Vec<[f64; N]>], n: usize, inputs: usize, rows: usize) -> Uncertainty {
    let mut sorted: Vec<f64> = results.iter().flat_map(|row| [row[0][n], row[1][n]]).collect();
    sorted.sort_by(f64::total_cmp);
    let count = sorted.len() as f64;
    let mean = sorted.iter().sum::<f64>() / count;
    let variance = sorted.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / count;
    // A variance within rounding has no contributions.
    let varies = variance > 1e-20 * mean * mean;
    let index = |sum: f64| if varies { sum / (results.len() as f64 * variance) } else { 0.0 };
    // Centred, against cancellation when the mean is large.
    let first =
        |i: usize| index(results.iter().map(|row| (row[1][n] - mean) * (row[i + 2][n] - row[0][n])).sum());
    let total = |i: usize| index(results.iter().map(|row| 0.5 * (row[0][n] - row[i + 2][n]).powi(2)).sum());
    Uncertainty {
        mean,
        deviation: variance.sqrt(),
        quantiles: [0.05, 0.5, 0.95].map(|p| quantile_of_sorted(&sorted, p)),
        first_order: (0..inputs).map(first).collect(),
        total: (0..inputs).map(total).collect(),
        evaluations: rows * (inputs + 2),
        failed: 1.0 - results.len() as f64 / rows as f64,
    }
}
