//! Quasi-Monte-Carlo: intervals and Sobol indices.

use super::Spread;
use super::sequence::{DIMENSIONS, Sequence};
use crate::error::{Answer, none, within};

/// The answer's distribution.
#[derive(Clone, Debug, PartialEq)]
pub struct Uncertainty {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Values below which 5 %, 50 % and 95 % of the answers lie.
    pub quantiles: [f64; 3],
    /// First-order Sobol index of each input: the share of the variance that goes if it were known.
    pub first_order: Vec<f64>,
    /// Total Sobol index of each input: the share that stays if everything else were known.
    pub total: Vec<f64>,
    /// How many evaluations were made.
    pub evaluations: usize,
    /// Share of the samples that the model refused; they are left out of everything above.
    pub refused: f64,
}

/// Propagates the `spreads` through `model`, which gives N numbers at once, with about `evaluations` evaluations.
///
/// First-order indices by Saltelli et al. (2010), Comput. Phys. Commun. 181, eq. (b), total by Jansen (1999), on two
/// halves of one Sobol sequence in twice as many dimensions. Reproducible: the same `seed`, the same answer.
///
/// # Errors
/// With no input or more than ten, fewer than 64 or more than 10⁸ evaluations, a spread without width, or a model that
/// refuses more than nine samples in ten.
pub fn propagate<const N: usize>(
    spreads: &[Spread],
    evaluations: usize,
    seed: u64,
    model: impl Fn(&[f64]) -> Option<[f64; N]>,
) -> Answer<[Uncertainty; N]> {
    let inputs = spreads.len();
    within("number of uncertain inputs", inputs as f64, 1.0, (DIMENSIONS / 2) as f64)?;
    within("evaluations", evaluations as f64, 64.0, 1e8)?;
    spreads.iter().try_for_each(Spread::check)?;
    let rows = (evaluations / (inputs + 2)).max(8);
    let answers = sample(spreads, rows, seed, model);
    if answers.len() * 10 < rows {
        return none("the uncertainty", "the model refuses more than nine samples in ten");
    }
    Ok(std::array::from_fn(|n| summarise(&answers, n, inputs, rows)))
}

/// Rows of answers (f_A, f_B, f_AB₁, …), those with a refusal left out.
fn sample<const N: usize>(
    spreads: &[Spread],
    rows: usize,
    seed: u64,
    model: impl Fn(&[f64]) -> Option<[f64; N]>,
) -> Vec<Vec<[f64; N]>> {
    let inputs = spreads.len();
    let mut sequence = Sequence::new(2 * inputs, seed);
    let mut point = vec![0.0; 2 * inputs];
    let mut answers = Vec::with_capacity(rows);
    for _ in 0..rows {
        sequence.next_point(&mut point);
        let value = |half: usize, i: usize| spreads[i].quantile(point[half * inputs + i]);
        let first: Vec<f64> = (0..inputs).map(|i| value(0, i)).collect();
        let second: Vec<f64> = (0..inputs).map(|i| value(1, i)).collect();
        let mixed = (0..inputs).map(|i| {
            let mut mixed = first.clone();
            mixed[i] = second[i];
            mixed
        });
        let inputs = [first.clone(), second.clone()].into_iter().chain(mixed);
        let answer = |x: Vec<f64>| model(&x).filter(|y| y.iter().all(|y| y.is_finite()));
        let row: Option<Vec<[f64; N]>> = inputs.map(answer).collect();
        answers.extend(row);
    }
    answers
}

/// Summary of the n-th number of every answer.
fn summarise<const N: usize>(answers: &[Vec<[f64; N]>], n: usize, inputs: usize, rows: usize) -> Uncertainty {
    let mut sorted: Vec<f64> = answers.iter().flat_map(|row| [row[0][n], row[1][n]]).collect();
    sorted.sort_by(f64::total_cmp);
    let count = sorted.len() as f64;
    let mean = sorted.iter().sum::<f64>() / count;
    let variance = sorted.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / count;
    let quantile = |p: f64| {
        let place = p * (count - 1.0);
        let (below, part) = (place.floor() as usize, place.fract());
        sorted[below] + part * (sorted[(below + 1).min(sorted.len() - 1)] - sorted[below])
    };
    // What does not vary but for rounding has no shares.
    let varies = variance > 1e-20 * mean * mean;
    let share = |sum: f64| if varies { sum / (answers.len() as f64 * variance) } else { 0.0 };
    // Centred, so that a large mean does not drown the small differences.
    let first =
        |i: usize| share(answers.iter().map(|row| (row[1][n] - mean) * (row[i + 2][n] - row[0][n])).sum());
    let total = |i: usize| share(answers.iter().map(|row| 0.5 * (row[0][n] - row[i + 2][n]).powi(2)).sum());
    Uncertainty {
        mean,
        deviation: variance.sqrt(),
        quantiles: [quantile(0.05), quantile(0.5), quantile(0.95)],
        first_order: (0..inputs).map(first).collect(),
        total: (0..inputs).map(total).collect(),
        evaluations: rows * (inputs + 2),
        refused: 1.0 - answers.len() as f64 / rows as f64,
    }
}
