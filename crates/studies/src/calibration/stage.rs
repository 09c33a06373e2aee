//! One calibration of one model: the best values, samples of the posterior, the band of its curves.

use super::data::MeasuredCurve;
use super::fit::best;
use super::likelihood::{Likelihood, Response};
use super::posterior::{Advice, Posterior};
use super::sampler::sample;
use numerics::quantile_of_sorted;

/// Samples whose curves make the band.
const BAND: usize = 200;
/// Standard deviations of a sum of squares from which the model does not follow the measurements.
const FAR: f64 = 3.0;

/// A curve at the best values, and the band of the posterior: values [SI] at the points of the measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Values at the best values of the unknowns [SI].
    pub best: Vec<f64>,
    /// 5 % quantile over the posterior.
    pub low: Vec<f64>,
    /// 95 % quantile over the posterior.
    pub high: Vec<f64>,
}

/// The result of a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The model, for people.
    pub model: String,
    /// The best values, in the units of the unknowns.
    pub best: Vec<f64>,
    /// The posterior of the unknowns.
    pub posterior: Posterior,
    /// The curves that were fitted.
    pub curves: Vec<MeasuredCurve>,
    /// The model's values of the fitted curves.
    pub bands: Vec<Band>,
    /// The sum of the squared residuals at the best values over their noise.
    pub squares: f64,
    /// The number of points.
    pub points: usize,
    /// What a user must know.
    pub advice: Vec<Advice>,
}

/// How long and from where to sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Samples of each of the four chains that are kept.
    pub samples: usize,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// Calibrates a response.
///
/// # Errors
/// That it has no value anywhere within the priors, with the reason at their middle.
pub fn calibrate_response(
    likelihood: &Likelihood,
    response: &dyn Response,
    model: &str,
    effort: Effort,
) -> Result<Stage, String> {
    let Some(best) = best(likelihood, response, effort.seed) else {
        let middle = likelihood.space.values(&vec![0.0; likelihood.space.dimension()]);
        let why = response.at(&middle).err().unwrap_or_else(|| "the density is 0 there".to_owned());
        return Err(format!("{model} has no value within the priors; at their middle: {why}"));
    };
    let density = |coordinates: &[f64]| likelihood.log_density(coordinates, response);
    let chains = sample(&best, effort.samples, effort.seed, &density);
    let posterior = Posterior::of(likelihood, &best.coordinates, &chains);
    let values = likelihood.space.values(&best.coordinates);
    let seen = response.at(&values)?;
    let squares = likelihood.squares(&best.coordinates, &seen);
    let mut advice = posterior.advice();
    advice.extend(misfit(likelihood, squares));
    Ok(Stage {
        model: model.to_owned(),
        curves: likelihood.curves.clone(),
        bands: bands(likelihood, response, &seen.values, &posterior.samples),
        points: likelihood.points(),
        best: values,
        posterior,
        squares,
        advice,
    })
}

/// The warning that the model does not follow the measurements within their noise.
fn misfit(likelihood: &Likelihood, squares: f64) -> Option<Advice> {
    let points = likelihood.points() as f64;
    let most = points + FAR * (2.0 * points).sqrt();
    let is_given = !likelihood.estimates_noise() && likelihood.model_error <= 0.0;
    (is_given && squares > most).then(|| Advice {
        message: format!(
            "the model does not follow the measurements within their noise: the sum of the squared residuals is {squares:.1} for {points} points"
        ),
        cure: "the intervals are too narrow then; calibrate the solver, give the error of the model with --model-error 10%, or leave the \
               noise to be estimated"
            .to_owned(),
    })
}

/// The bands of all curves.
fn bands(likelihood: &Likelihood, response: &dyn Response, best: &[f64], samples: &[Vec<f64>]) -> Vec<Band> {
    let every = samples.len().div_ceil(BAND).max(1);
    let curves = samples.iter().step_by(every).filter_map(|values| response.at(values).ok());
    let curves: Vec<Vec<f64>> = curves.map(|seen| seen.values).collect();
    let mut first = 0;
    let mut list = Vec::new();
    for curve in &likelihood.curves {
        let points = curve.values.len();
        let at = |n: usize, q: f64| {
            let mut values: Vec<f64> = curves.iter().map(|seen| seen[first + n]).collect();
            values.sort_by(f64::total_cmp);
            curve.unseen(n, quantile_of_sorted(&values, q))
        };
        list.push(Band {
            best: (0..points).map(|n| curve.unseen(n, best[first + n])).collect(),
            low: (0..points).map(|n| at(n, 0.05)).collect(),
            high: (0..points).map(|n| at(n, 0.95)).collect(),
        });
        first += points;
    }
    list
}
