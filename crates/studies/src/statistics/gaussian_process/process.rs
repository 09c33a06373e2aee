//! A fitted Gaussian process: what it predicts, and how well it predicts points left out of it.

use super::super::StatisticsError;
use super::correlation::Correlation;
use super::projection::{Data, Projection};
use super::scaling::Scaling;
use numerics::symmetric::dot;

/// The predictivity Q² from which on a surrogate may stand for the response (chosen; usual in practice: 0.7
/// to 0.8).
pub const LEAST_PREDICTIVITY: f64 = 0.7;
/// The least portion of a point that others leave open, below which they cannot predict it (chosen).
const SMALLEST_DIAGONAL: f64 = 1e-9;

/// A prediction, in the unit of the values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Predicted {
    /// Mean of the prediction.
    pub mean: f64,
    /// Standard deviation of the prediction.
    pub deviation: f64,
}

/// A surrogate of a response.
#[derive(Clone, Debug)]
pub struct GaussianProcess {
    scaling: Scaling,
    correlation: Correlation,
    inputs: Vec<Vec<f64>>,
    projection: Projection,
    /// σ², of scaled values.
    variance: f64,
    values: Vec<f64>,
    left_out: Vec<Predicted>,
    predictivity: f64,
}

impl GaussianProcess {
    /// The process of data under given hyperparameters; `None` where the covariance is not positive definite.
    pub(super) fn of(scaling: Scaling, data: Data, correlation: Correlation) -> Option<Self> {
        let projection = Projection::of(&data, &correlation)?;
        let variance = projection.squares / data.freedom();
        let scaled = leave_one_out(&data, &projection, variance);
        let about = data.values.iter().sum::<f64>() / data.values.len() as f64;
        let spread: f64 = data.values.iter().map(|y| (y - about) * (y - about)).sum();
        let missed: f64 = data.values.iter().zip(&scaled).map(|(y, p)| (y - p.mean) * (y - p.mean)).sum();
        let shown = |p: Predicted| Predicted {
            mean: scaling.mean + scaling.deviation * p.mean,
            deviation: scaling.deviation * p.deviation,
        };
        let left_out = scaled.into_iter().map(shown).collect();
        let values = data.values.iter().map(|y| scaling.mean + scaling.deviation * y).collect();
        let predictivity = 1.0 - missed / spread;
        Some(Self {
            scaling,
            correlation,
            inputs: data.inputs,
            projection,
            variance,
            values,
            left_out,
            predictivity,
        })
    }

    /// The response at an input, given in the factors of the fit, with the deviation of the response itself,
    /// without noise.
    ///
    /// Not a number where coordinates are missing. Source: Rasmussen & Williams (2006), eq. (2.41) and
    /// (2.42).
    #[must_use]
    pub fn predict(&self, input: &[f64]) -> Predicted {
        let (correlations, basis) = self.seen(input);
        let forward = self.projection.factor.forward(&correlations);
        let open: Vec<f64> = basis
            .iter()
            .zip(&self.projection.trend_forward)
            .map(|(h, column)| h - dot(column, &forward))
            .collect();
        let trend = self.projection.trend_factor.forward(&open);
        let variance = self.variance * (1.0 - dot(&forward, &forward) + dot(&trend, &trend));
        // At a point of the data the difference is zero within rounding.
        let deviation = if variance < 0.0 { 0.0 } else { variance.sqrt() };
        Predicted {
            mean: self.combined(&correlations, &basis),
            deviation: self.scaling.deviation * deviation,
        }
    }

    /// The mean of [`Self::predict`] alone, at a small part of its cost.
    #[must_use]
    pub fn mean(&self, input: &[f64]) -> f64 {
        let (correlations, basis) = self.seen(input);
        self.combined(&correlations, &basis)
    }

    /// Q² = 1 − Σ (y_i − ŷ₋ᵢ)² / Σ (y_i − ȳ)², with ŷ₋ᵢ predicted without point i, hyperparameters unchanged:
    /// 1 for a surrogate that predicts perfectly, 0 for one no better than the mean. [–]
    ///
    /// Source: Dubrule (1983), Math. Geol. 15, eq. (9) and following.
    #[must_use]
    pub fn predictivity(&self) -> f64 {
        self.predictivity
    }

    /// Whether the predictivity reaches [`LEAST_PREDICTIVITY`].
    ///
    /// # Errors
    /// [`StatisticsError::NotPredictive`] where it does not.
    pub fn trusted(&self) -> Result<&Self, StatisticsError> {
        let (predictivity, least) = (self.predictivity, LEAST_PREDICTIVITY);
        if predictivity >= least {
            Ok(self)
        } else {
            Err(StatisticsError::NotPredictive { predictivity, least })
        }
    }

    /// The value of each point of the fit, in their order.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The value of each point of the fit, predicted from all others; the deviation contains the noise.
    #[must_use]
    pub fn left_out(&self) -> &[Predicted] {
        &self.left_out
    }

    /// The standard deviation of the noise of single values, in their unit.
    #[must_use]
    pub fn noise(&self) -> f64 {
        self.scaling.deviation * (self.variance * self.correlation.nugget).sqrt()
    }

    /// The correlation length of each factor, in its unit; infinite for one that does not vary.
    #[must_use]
    pub fn lengths(&self) -> Vec<f64> {
        let mut lengths = vec![f64::INFINITY; self.scaling.factors];
        for ((factor, [_, range]), inverse) in
            self.scaling.varying.iter().zip(&self.scaling.ranges).zip(&self.correlation.inverse_lengths)
        {
            lengths[*factor] = range / inverse;
        }
        lengths
    }

    /// Correlations of an input with the points, and the functions of the trend there.
    fn seen(&self, input: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let scaled = self.scaling.input(input);
        let correlations = self.inputs.iter().map(|point| self.correlation.between(&scaled, point)).collect();
        let basis = self.scaling.basis(&scaled);
        (correlations, basis)
    }

    fn combined(&self, correlations: &[f64], basis: &[f64]) -> f64 {
        let scaled = dot(basis, &self.projection.trend) + dot(correlations, &self.projection.weights);
        self.scaling.mean + self.scaling.deviation * scaled
    }
}

/// The prediction of each point from all others, in scaled values: the residual is (P y)_i / P_ii, its
/// variance σ² / P_ii.
fn leave_one_out(data: &Data, projection: &Projection, variance: f64) -> Vec<Predicted> {
    let matrix = projection.matrix(data);
    let predicted = |(i, y): (usize, &f64)| {
        let diagonal = matrix.row(i)[i];
        if diagonal < SMALLEST_DIAGONAL {
            // Without this point the trend is open: nothing but the mean of all, zero, is left.
            return Predicted { mean: 0.0, deviation: 1.0 };
        }
        Predicted { mean: y - projection.weights[i] / diagonal, deviation: (variance / diagonal).sqrt() }
    };
    data.values.iter().enumerate().map(predicted).collect()
}
