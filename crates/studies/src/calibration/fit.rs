//! The best values: penalised least squares by Levenberg and Marquardt's method from several starts.

use super::likelihood::{Likelihood, Response};
use super::prior::Prior;
use crate::statistics::design::latin_hypercube;
use numerics::symmetric::{Cholesky, Square, dot};

/// The most likely coordinates of the unknowns, and the covariance of the density around them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Best {
    /// Coordinates, with that of the noise where it is estimated.
    pub(super) coordinates: Vec<f64>,
    /// The logarithm of the posterior density there.
    pub(super) log_density: f64,
    /// Covariance of the coordinates by linear theory.
    pub(super) covariance: Vec<Vec<f64>>,
}

/// Starts besides the middle of the priors (chosen).
const STARTS: usize = 12;
/// Starts that are followed to their end: the best of them.
const FOLLOWED: usize = 4;
/// Steps at most.
const STEPS: usize = 30;
/// Difference of a derivative, in standard deviations of the prior: values are rounded to six digits.
const DIFFERENCE: f64 = 1e-2;
/// Change of the coordinates at which a search ends.
const CONVERGED: f64 = 1e-4;
/// Variance of a coordinate that the data leave open, by linear theory.
const OPEN: f64 = 1.0;

/// Searches for the most likely coordinates; `None` where the model has no value at any start.
pub(super) fn best(likelihood: &Likelihood, response: &dyn Response, seed: u64) -> Option<Best> {
    let mut starts = starts(likelihood, seed);
    let density = |start: &Vec<f64>| likelihood.log_density(start, response);
    starts.retain(|start| density(start) > f64::NEG_INFINITY);
    starts.sort_by(|a, b| density(b).total_cmp(&density(a)));
    let followed = starts.iter().take(FOLLOWED).map(|start| follow(likelihood, response, start));
    followed.reduce(|best, next| if next.log_density > best.log_density { next } else { best })
}

fn starts(likelihood: &Likelihood, seed: u64) -> Vec<Vec<f64>> {
    let dimension = likelihood.dimension();
    let priors: Vec<Prior> = likelihood.space.unknowns.iter().map(|u| u.prior).collect();
    let place = |unit: Vec<f64>| -> Vec<f64> {
        let spread = |n: usize| priors.get(n).map_or([-1.0, 1.0], Prior::spread);
        unit.iter().enumerate().map(|(n, u)| spread(n)[0] + u * (spread(n)[1] - spread(n)[0])).collect()
    };
    let design = latin_hypercube(STARTS, dimension, seed).unwrap_or_default();
    std::iter::once(vec![0.0; dimension]).chain(design.into_iter().map(place)).collect()
}

/// Residuals over their noise, those of normal priors included; `None` where the model has no value.
fn residuals(likelihood: &Likelihood, response: &dyn Response, coordinates: &[f64]) -> Option<Vec<f64>> {
    let seen = response.at(&likelihood.space.values(coordinates)).ok()?;
    let own = |n: usize| {
        let shared: f64 = seen.shared.iter().map(|column| column[n] * column[n]).sum();
        seen.variances.get(n).copied().unwrap_or(0.0) + shared
    };
    let deviations = likelihood.deviations(coordinates);
    let measured = likelihood.measured();
    let of_points = measured.iter().zip(&seen.values).zip(deviations).enumerate();
    let mut list: Vec<f64> = of_points.map(|(n, ((m, s), d))| (s - m) / (d * d + own(n)).sqrt()).collect();
    let normal = likelihood.space.unknowns.iter().zip(coordinates).filter(|(u, _)| u.prior.is_normal());
    list.extend(normal.map(|(_, c)| *c));
    list.iter().all(|r| r.is_finite()).then_some(list)
}

/// Derivatives of the residuals by the coordinates of the unknowns, column by column.
fn derivatives(
    likelihood: &Likelihood,
    response: &dyn Response,
    coordinates: &[f64],
    here: &[f64],
) -> Option<Vec<Vec<f64>>> {
    let column = |n: usize| {
        let moved = |step: f64| {
            let mut place = coordinates.to_vec();
            place[n] += step;
            let inside = likelihood.log_prior(&place) > f64::NEG_INFINITY;
            let there = inside.then(|| residuals(likelihood, response, &place))??;
            Some(there.iter().zip(here).map(|(there, here)| (there - here) / step).collect::<Vec<f64>>())
        };
        moved(DIFFERENCE).or_else(|| moved(-DIFFERENCE))
    };
    (0..likelihood.space.dimension()).map(column).collect()
}

fn follow(likelihood: &Likelihood, response: &dyn Response, start: &[f64]) -> Best {
    let unknowns = likelihood.space.dimension();
    let mut best = Best {
        coordinates: start.to_vec(),
        log_density: likelihood.log_density(start, response),
        covariance: diagonal(likelihood.dimension()),
    };
    let mut damping = 1e-2;
    for _ in 0..STEPS {
        let Some(here) = residuals(likelihood, response, &best.coordinates) else { break };
        let Some(columns) = derivatives(likelihood, response, &best.coordinates, &here) else { break };
        let gradient: Vec<f64> = columns.iter().map(|column| dot(column, &here)).collect();
        best.covariance = covariance(&columns, likelihood.dimension());
        let mut moved = None;
        while moved.is_none() && damping < 1e6 {
            let step = step(&columns, &gradient, damping);
            let mut place = best.coordinates.clone();
            for (n, change) in step.iter().enumerate().take(unknowns) {
                let [low, high] = limits(&likelihood.space.unknowns[n].prior);
                place[n] = (place[n] - change.clamp(-1.0, 1.0)).clamp(low, high);
            }
            tune_noise(likelihood, response, &mut place);
            let density = likelihood.log_density(&place, response);
            if density > best.log_density {
                moved = Some((place, density));
                damping = (0.2 * damping).max(1e-9);
            } else {
                damping *= 5.0;
            }
        }
        let Some((place, density)) = moved else { break };
        let change = place.iter().zip(&best.coordinates).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        (best.coordinates, best.log_density) = (place, density);
        if change < CONVERGED {
            break;
        }
    }
    best
}

/// The most likely noise for what the model says at a place, by steps that halve.
fn tune_noise(likelihood: &Likelihood, response: &dyn Response, place: &mut [f64]) {
    if !likelihood.estimates_noise() {
        return;
    }
    let Ok(seen) = response.at(&likelihood.space.values(place)) else { return };
    let last = place.len() - 1;
    let density = |place: &[f64]| likelihood.log_likelihood(place, &seen) + likelihood.log_prior(place);
    let mut step = 0.5;
    while step > 1e-3 {
        let here = density(place);
        let at = place[last];
        let better = [at - step, at + step].into_iter().find(|moved| {
            place[last] = *moved;
            density(place) > here
        });
        place[last] = better.unwrap_or(at);
        if better.is_none() {
            step *= 0.5;
        }
    }
}

/// Coordinates between which a search stays.
fn limits(prior: &Prior) -> [f64; 2] {
    if prior.is_normal() { [-4.0, 4.0] } else { prior.spread() }
}

fn diagonal(size: usize) -> Vec<Vec<f64>> {
    (0..size).map(|i| (0..size).map(|j| if i == j { OPEN } else { 0.0 }).collect()).collect()
}

/// JᵀJ with its diagonal enlarged.
fn normal_matrix(columns: &[Vec<f64>], enlarged: impl Fn(f64) -> f64) -> Square {
    let entry = |i: usize, j: usize| {
        let product = dot(&columns[i], &columns[j]);
        if i == j { enlarged(product) } else { product }
    };
    Square::lower(columns.len(), entry)
}

fn step(columns: &[Vec<f64>], gradient: &[f64], damping: f64) -> Vec<f64> {
    let matrix = normal_matrix(columns, |square| square * (1.0 + damping) + 1e-6 * damping + 1e-12);
    Cholesky::of(matrix).map_or_else(|| vec![0.0; gradient.len()], |factor| factor.solve(gradient))
}

/// (JᵀJ + 1)⁻¹: an even prior counts as a normal one of the same standard deviation. A noise that is
/// estimated is taken for independent of the rest.
fn covariance(columns: &[Vec<f64>], dimension: usize) -> Vec<Vec<f64>> {
    let mut covariance = diagonal(dimension);
    let Some(factor) = Cholesky::of(normal_matrix(columns, |square| square + 1.0)) else { return covariance };
    let inverse = factor.inverse();
    for i in 0..inverse.size {
        for (j, entry) in inverse.row(i).iter().enumerate() {
            (covariance[i][j], covariance[j][i]) = (*entry, *entry);
        }
    }
    if dimension > columns.len() {
        covariance[dimension - 1][dimension - 1] = 0.1;
    }
    covariance
}
