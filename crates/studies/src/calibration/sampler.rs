//! Samples of the posterior: adaptive Metropolis in several chains.
//!
//! A proposal is normal with 2.38²/d times the covariance of the chain so far; it is adapted during the
//! warm-up and fixed afterwards. Sources: Haario, Saksman & Tamminen (2001), An adaptive Metropolis
//! algorithm, Bernoulli 7(2); Gelman et al. (2013), *Bayesian Data Analysis*, section 11.4 (R̂ of split
//! chains, effective number of draws) and 12.2 (the factor 2.38²/d).

use super::fit::Best;
use numerics::Draws;
use numerics::symmetric::{Cholesky, Square};

/// Chains.
const CHAINS: usize = 4;
/// Keeps the random numbers of chains apart from those of designs.
const PURPOSE: u64 = 0x2545_f491_4f6c_dd1d;
/// Steps between two adaptations.
const EVERY: usize = 50;
/// What is added to the diagonal of a covariance, so that no direction is lost.
const LEAST_VARIANCE: f64 = 1e-8;

/// Samples of several chains.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chains {
    /// The samples after the warm-up, chain by chain.
    pub chains: Vec<Vec<Vec<f64>>>,
    /// Fraction of proposals that were accepted.
    pub acceptance: f64,
}

/// Samples a density around its best place: `steps` of each chain are kept, half as many before them only
/// adapt the proposal.
pub(super) fn sample(best: &Best, steps: usize, seed: u64, density: &dyn Fn(&[f64]) -> f64) -> Chains {
    let mut all = Chains::default();
    for chain in 0..CHAINS {
        let mut draws = Draws::new(seed.wrapping_mul(31).wrapping_add(chain as u64), PURPOSE);
        let (samples, accepted) = one_chain(best, steps, &mut draws, density);
        all.acceptance += accepted / CHAINS as f64;
        all.chains.push(samples);
    }
    all
}

fn one_chain(
    best: &Best,
    steps: usize,
    draws: &mut Draws,
    density: &dyn Fn(&[f64]) -> f64,
) -> (Vec<Vec<f64>>, f64) {
    let dimension = best.coordinates.len();
    let scale = 2.38 * 2.38 / dimension as f64;
    let mut factor = scaled_factor(&best.covariance, scale);
    let (mut place, mut here) = start(best, draws, density);
    let warm_up = steps / 2;
    let mut history: Vec<Vec<f64>> = Vec::with_capacity(warm_up);
    let mut samples = Vec::with_capacity(steps);
    let mut accepted = 0_usize;
    for step in 0..warm_up + steps {
        let proposed = moved(&place, &factor, draws);
        let there = density(&proposed);
        if (1.0 - draws.uniform()).ln() < there - here {
            (place, here) = (proposed, there);
            accepted += usize::from(step >= warm_up);
        }
        if step < warm_up {
            history.push(place.clone());
            // Half of the history: its beginning depends on the start.
            if history.len().is_multiple_of(EVERY) && history.len() >= 2 * EVERY {
                factor = scaled_factor(&covariance(&history[history.len() / 2..]), scale);
            }
        } else {
            samples.push(place.clone());
        }
    }
    (samples, accepted as f64 / steps.max(1) as f64)
}

/// A start away from the best place, so that chains that agree have found the same; there if nothing else is
/// possible.
fn start(best: &Best, draws: &mut Draws, density: &dyn Fn(&[f64]) -> f64) -> (Vec<f64>, f64) {
    let factor = scaled_factor(&best.covariance, 2.0);
    let away = (0..20).map(|_| moved(&best.coordinates, &factor, draws));
    let found = away.map(|place| (density(&place), place)).find(|(value, _)| *value > f64::NEG_INFINITY);
    found.map_or_else(|| (best.coordinates.clone(), best.log_density), |(value, place)| (place, value))
}

/// A place at a random distance from another: L z, with normal z.
fn moved(place: &[f64], factor: &Cholesky, draws: &mut Draws) -> Vec<f64> {
    let normal: Vec<f64> = place.iter().map(|_| draws.normal()).collect();
    place.iter().zip(factor.times(&normal)).map(|(x, change)| x + change).collect()
}

/// The factor of a covariance times a scale; of its diagonal alone where rounding has made it indefinite.
fn scaled_factor(covariance: &[Vec<f64>], scale: f64) -> Cholesky {
    let size = covariance.len();
    let entry = |i: usize, j: usize| scale * (covariance[i][j] + if i == j { LEAST_VARIANCE } else { 0.0 });
    Cholesky::of(Square::lower(size, entry)).unwrap_or_else(|| {
        let deviations: Vec<f64> = (0..size).map(|i| entry(i, i).abs().sqrt()).collect();
        Cholesky::diagonal(&deviations)
    })
}

/// The covariance of samples.
pub(super) fn covariance(samples: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let size = samples.first().map_or(0, Vec::len);
    let count = samples.len() as f64;
    let means: Vec<f64> = (0..size).map(|n| samples.iter().map(|s| s[n]).sum::<f64>() / count).collect();
    let entry = |i: usize, j: usize| {
        let products = samples.iter().map(|s| (s[i] - means[i]) * (s[j] - means[j]));
        products.sum::<f64>() / (count - 1.0).max(1.0)
    };
    (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
}

impl Chains {
    /// All samples.
    pub fn all(&self) -> impl Iterator<Item = &Vec<f64>> {
        self.chains.iter().flatten()
    }

    /// The potential scale reduction R̂ of a coordinate: near 1 where the chains, each split into halves,
    /// have found the same.
    #[must_use]
    pub fn reduction(&self, coordinate: usize) -> f64 {
        let (within, between, length) = self.variances(coordinate);
        if within <= 0.0 {
            1.0
        } else {
            (((length - 1.0) / length * within + between / length) / within).sqrt()
        }
    }

    /// Variance within half chains, between them (times their length), and their length.
    fn variances(&self, coordinate: usize) -> (f64, f64, f64) {
        let halves: Vec<Vec<f64>> = self
            .chains
            .iter()
            .flat_map(|chain| chain.chunks(chain.len().div_ceil(2).max(1)))
            .map(|half| half.iter().map(|sample| sample[coordinate]).collect())
            .collect();
        let length = halves.iter().map(Vec::len).min().unwrap_or(0) as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
        let variance = |values: &[f64]| {
            let middle = mean(values);
            values.iter().map(|v| (v - middle).powi(2)).sum::<f64>() / (values.len() as f64 - 1.0).max(1.0)
        };
        let means: Vec<f64> = halves.iter().map(|half| mean(half)).collect();
        let within = halves.iter().map(|half| variance(half)).sum::<f64>() / halves.len().max(1) as f64;
        (within, length * variance(&means), length)
    }

    /// The effective number of independent draws of a coordinate, by the autocorrelation within chains up to
    /// where it vanishes.
    #[must_use]
    pub fn effective(&self, coordinate: usize) -> f64 {
        let total: usize = self.chains.iter().map(Vec::len).sum();
        let times: Vec<f64> = self.chains.iter().map(|chain| correlation_time(chain, coordinate)).collect();
        let mean = times.iter().sum::<f64>() / times.len().max(1) as f64;
        total as f64 / mean.max(1.0)
    }
}

/// 1 + 2 Σ ρ_k, summed in pairs as long as they are positive. Source: Geyer (1992), Practical Markov chain
/// Monte Carlo.
fn correlation_time(chain: &[Vec<f64>], coordinate: usize) -> f64 {
    let values: Vec<f64> = chain.iter().map(|sample| sample[coordinate]).collect();
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    let covariance = |lag: usize| {
        let pairs = values.iter().zip(values.get(lag..).unwrap_or_default());
        pairs.map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>()
    };
    let square = covariance(0);
    if square <= 0.0 {
        return 1.0;
    }
    let (mut time, mut lag) = (-1.0, 0);
    while lag + 1 < values.len() {
        let pair = (covariance(lag) + covariance(lag + 1)) / square;
        if pair <= 0.0 {
            break;
        }
        time += 2.0 * pair;
        lag += 2;
    }
    time
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_correlated_normal_density_is_sampled() {
        let best = Best {
            coordinates: vec![0.0, 0.0],
            log_density: 0.0,
            covariance: vec![vec![1.0, 0.0], vec![0.0, 1.0]],
        };
        // Variances 1, correlation 0.9.
        let density = |x: &[f64]| -0.5 * (x[0] * x[0] - 1.8 * x[0] * x[1] + x[1] * x[1]) / (1.0 - 0.81);
        let chains = sample(&best, 4000, 5, &density);
        let all: Vec<Vec<f64>> = chains.all().cloned().collect();
        let found = covariance(&all);
        assert!((found[0][0] - 1.0).abs() < 0.2 && (found[0][1] - 0.9).abs() < 0.2, "{found:?}");
        assert!(chains.reduction(0) < 1.03 && chains.effective(0) > 400.0, "{}", chains.effective(0));
        assert!((0.15..0.6).contains(&chains.acceptance), "{}", chains.acceptance);
        assert_eq!(sample(&best, 100, 5, &density), sample(&best, 100, 5, &density));
    }
}
