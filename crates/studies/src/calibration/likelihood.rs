//! How likely measurements are: noise of each point, an error of the model that a curve has in common, the
//! error of a surrogate.
//!
//! Residuals r are those of logarithms, or parts of a scale ([`MeasuredCurve::seen`]). With the noise σ of
//! each point and columns B of errors that points share, ln L = −½ rᵀΣ⁻¹r − ½ ln |Σ|, Σ = diag σ² + B Bᵀ.
//! Source: Kennedy & O'Hagan (2001), Bayesian calibration of computer models, JRSS B 63(3), with the model
//! inadequacy reduced to a factor on each curve.

use super::data::MeasuredCurve;
use super::space::Space;
use numerics::symmetric::{Cholesky, Square, dot};

/// What a model says of all points, as residuals see it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Seen {
    /// Values at the points of all curves.
    pub values: Vec<f64>,
    /// Errors that points have in common: each a list of standard deviations, one for each point.
    pub shared: Vec<Vec<f64>>,
    /// Variances of the model's own errors; empty for none.
    pub variances: Vec<f64>,
}

/// What is calibrated: a model, or its surrogate.
pub trait Response {
    /// The values that the model gives for values of the unknowns.
    ///
    /// # Errors
    /// Why the model has no values there.
    fn at(&self, values: &[f64]) -> Result<Seen, String>;
}

/// The noise of measurements without standard deviations of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Noise {
    /// A standard deviation, as a part of the value.
    Given(f64),
    /// Found with the unknowns: log-normal around 10 %, a factor of 3 being one standard deviation.
    Estimated,
}

/// Median of a noise that is estimated, and the factor of its standard deviation (chosen: force gauges and
/// repeated tests).
const ESTIMATED: [f64; 2] = [0.1, 3.0];

impl Noise {
    /// The noise at the last coordinate of a sample.
    #[must_use]
    pub fn at(self, coordinate: Option<f64>) -> f64 {
        match self {
            Self::Given(noise) => noise,
            Self::Estimated => ESTIMATED[0] * (ESTIMATED[1].ln() * coordinate.unwrap_or(0.0)).exp(),
        }
    }
}

/// The posterior density of unknowns, up to a factor.
#[derive(Clone, Debug)]
pub struct Likelihood {
    /// The unknowns.
    pub space: Space,
    /// The measured curves.
    pub curves: Vec<MeasuredCurve>,
    /// The noise.
    pub noise: Noise,
    /// Standard deviation of an error that all points of a curve have in common, as a part of the value; 0
    /// for none.
    pub model_error: f64,
}

impl Likelihood {
    /// The number of coordinates: one for each unknown, and one for a noise that is estimated.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.space.dimension() + usize::from(self.estimates_noise())
    }

    /// Whether the noise is a coordinate.
    #[must_use]
    pub fn estimates_noise(&self) -> bool {
        self.noise == Noise::Estimated && self.curves.iter().any(|curve| curve.deviations.is_none())
    }

    /// The number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.curves.iter().map(|curve| curve.values.len()).sum()
    }

    /// The measured values, as residuals see them.
    #[must_use]
    pub fn measured(&self) -> Vec<f64> {
        let seen = |curve: &MeasuredCurve| {
            let points = curve.values.iter().enumerate();
            points.map(|(n, value)| curve.seen(n, *value).unwrap_or(f64::NAN)).collect::<Vec<f64>>()
        };
        self.curves.iter().flat_map(seen).collect()
    }

    /// The standard deviation of every point at coordinates.
    #[must_use]
    pub fn deviations(&self, coordinates: &[f64]) -> Vec<f64> {
        let noise = self.noise.at(coordinates.get(self.space.dimension()).copied());
        let of = |curve: &MeasuredCurve| {
            let points = 0..curve.values.len();
            points.map(|n| curve.seen_deviation(n).unwrap_or(noise)).collect::<Vec<f64>>()
        };
        self.curves.iter().flat_map(of).collect()
    }

    /// The errors that points share: those of the model's scale, one for each curve.
    fn shared(&self) -> Vec<Vec<f64>> {
        if self.model_error <= 0.0 {
            return Vec::new();
        }
        let column = |number: usize| {
            let of = |(n, curve): (usize, &MeasuredCurve)| {
                vec![if n == number { self.model_error } else { 0.0 }; curve.values.len()]
            };
            self.curves.iter().enumerate().flat_map(of).collect()
        };
        (0..self.curves.len()).map(column).collect()
    }

    /// The logarithm of the density of the priors at coordinates, −∞ where they exclude them.
    #[must_use]
    pub fn log_prior(&self, coordinates: &[f64]) -> f64 {
        let noise = coordinates.get(self.space.dimension()).map_or(0.0, |c| -0.5 * c * c);
        self.space.log_prior(coordinates) + noise
    }

    /// The logarithm of the posterior density at coordinates, without its constant; −∞ where priors or the
    /// model exclude them.
    #[must_use]
    pub fn log_density(&self, coordinates: &[f64], response: &dyn Response) -> f64 {
        let prior = self.log_prior(coordinates);
        if prior == f64::NEG_INFINITY {
            return prior;
        }
        let Ok(seen) = response.at(&self.space.values(coordinates)) else { return f64::NEG_INFINITY };
        let density = prior + self.log_likelihood(coordinates, &seen);
        if density.is_nan() { f64::NEG_INFINITY } else { density }
    }

    /// ln L of what a model says, without its constant.
    #[must_use]
    pub fn log_likelihood(&self, coordinates: &[f64], seen: &Seen) -> f64 {
        let own = |n: usize| seen.variances.get(n).copied().unwrap_or(0.0);
        let deviations = self.deviations(coordinates);
        let variances: Vec<f64> = deviations.iter().enumerate().map(|(n, d)| d * d + own(n)).collect();
        let residuals: Vec<f64> = self.measured().iter().zip(&seen.values).map(|(m, s)| m - s).collect();
        let weighted: Vec<f64> = residuals.iter().zip(&variances).map(|(r, v)| r / v).collect();
        let mut squares = dot(&residuals, &weighted);
        let mut determinant: f64 = variances.iter().map(|v| v.ln()).sum();
        let columns: Vec<Vec<f64>> = seen.shared.iter().cloned().chain(self.shared()).collect();
        if !columns.is_empty() {
            // Woodbury: Σ⁻¹ = D⁻¹ − D⁻¹B M⁻¹ BᵀD⁻¹ and |Σ| = |D| |M| with M = I + BᵀD⁻¹B.
            let over =
                |column: &[f64]| column.iter().zip(&variances).map(|(b, v)| b / v).collect::<Vec<f64>>();
            let scaled: Vec<Vec<f64>> = columns.iter().map(|column| over(column)).collect();
            let entry = |i: usize, j: usize| dot(&columns[i], &scaled[j]) + f64::from(u8::from(i == j));
            let Some(factor) = Cholesky::of(Square::lower(columns.len(), entry)) else {
                return f64::NEG_INFINITY;
            };
            let right: Vec<f64> = columns.iter().map(|column| dot(column, &weighted)).collect();
            let solved = factor.forward(&right);
            squares -= dot(&solved, &solved);
            determinant += factor.log_determinant();
        }
        -0.5 * (squares + determinant)
    }

    /// The sum of the squared residuals over their noise: about the number of points where the model follows
    /// the measurements.
    #[must_use]
    pub fn squares(&self, coordinates: &[f64], seen: &Seen) -> f64 {
        let deviations = self.deviations(coordinates);
        let own = |n: usize| seen.variances.get(n).copied().unwrap_or(0.0);
        let measured = self.measured();
        let terms = measured.iter().zip(&seen.values).zip(deviations).enumerate();
        terms.map(|(n, ((m, s), d))| (m - s).powi(2) / (d * d + own(n))).sum()
    }
}
