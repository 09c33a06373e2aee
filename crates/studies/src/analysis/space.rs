//! Whether a design fills its space, so that a surrogate and Sobol indices may be made of it.

use super::factors::VariedFactor;
use super::sample::Sample;
use crate::charts::plain_label;

/// Points per factor. Source: Loeppky, Sacks & Welch (2009), Technometrics 51, *Choosing the sample size of a
/// computer experiment*.
const POINTS_PER_FACTOR: usize = 10;
/// Levels of a factor of numbers, at least, and words of one of words, at most (chosen): two points show no
/// curve, and words have no distance from each other.
const LEAST_LEVELS: usize = 3;
const MOST_WORDS: usize = 2;
/// Largest correlation between two factors (chosen): indices take them for independent.
const LARGEST_CORRELATION: f64 = 0.5;

/// Why the sample does not fill its space, in words that go on from "… are not computed: "; `Ok` where it
/// does.
pub(super) fn fills_space(sample: &Sample, factors: &[VariedFactor<'_>]) -> Result<(), String> {
    let (points, needed) = (sample.values.len(), POINTS_PER_FACTOR * factors.len());
    if points < needed {
        let count = factors.len();
        return Err(format!("{points} points for {count} factors, {needed} are needed (ten per factor)"));
    }
    for (k, factor) in factors.iter().enumerate() {
        let name = plain_label(factor.column);
        let mut levels = sample.column(k);
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        if factor.words.len() > MOST_WORDS {
            return Err(format!("{name} has {} words, which have no order", factor.words.len()));
        }
        if factor.words.is_empty() && levels.len() < LEAST_LEVELS {
            return Err(format!("{name} has {} levels, {LEAST_LEVELS} are needed", levels.len()));
        }
        for (other, before) in factors[..k].iter().enumerate() {
            let r = correlation(&sample.column(other), &sample.column(k));
            // A factor that does not vary here has no correlation.
            if r.is_nan() || r.abs() > LARGEST_CORRELATION {
                let pair = plain_label(before.column);
                return Err(format!("{pair} and {name} do not vary independently (correlation {r:.2})"));
            }
        }
    }
    Ok(())
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |list: &[f64]| list.iter().sum::<f64>() / list.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let sum =
        |f: &dyn Fn(f64, f64) -> f64| a.iter().zip(b).map(|(x, y)| f(x - mean_a, y - mean_b)).sum::<f64>();
    sum(&|x, y| x * y) / (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt()
}
