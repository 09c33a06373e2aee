//! What data and hyperparameters determine: σ², the trend β, and P = R⁻¹ − R⁻¹H (HᵀR⁻¹H)⁻¹ HᵀR⁻¹, which takes
//! the trend out.

use super::correlation::Correlation;
use numerics::symmetric::{Cholesky, Square, dot};

/// Keeps a response that the trend explains entirely from a variance of zero; of values with a deviation of
/// one (chosen).
const LEAST_SQUARES: f64 = 1e-12;

/// Scaled data.
#[derive(Clone, Debug)]
pub(super) struct Data {
    /// Inputs, 0 to 1.
    pub(super) inputs: Vec<Vec<f64>>,
    /// The functions of the trend at these inputs.
    pub(super) basis: Vec<Vec<f64>>,
    /// Values, with mean 0 and deviation 1.
    pub(super) values: Vec<f64>,
}

impl Data {
    /// Number of points less that of the coefficients of the trend.
    pub(super) fn freedom(&self) -> f64 {
        (self.values.len() - self.basis.first().map_or(0, Vec::len)) as f64
    }
}

/// Data, seen through a correlation.
#[derive(Clone, Debug)]
pub(super) struct Projection {
    /// Factor of R = C + λ I.
    pub(super) factor: Cholesky,
    /// Factor of HᵀR⁻¹H.
    pub(super) trend_factor: Cholesky,
    /// L⁻¹h for each function h of the trend.
    pub(super) trend_forward: Vec<Vec<f64>>,
    /// Coefficients β of the trend: generalised least squares.
    pub(super) trend: Vec<f64>,
    /// P y = R⁻¹ (y − H β).
    pub(super) weights: Vec<f64>,
    /// yᵀ P y, never zero.
    pub(super) squares: f64,
}

impl Projection {
    /// `None` where R or HᵀR⁻¹H is not positive definite.
    pub(super) fn of(data: &Data, correlation: &Correlation) -> Option<Self> {
        let (inputs, size) = (&data.inputs, data.inputs.len());
        let entry = |i: usize, j: usize| {
            if i == j { 1.0 + correlation.nugget } else { correlation.between(&inputs[i], &inputs[j]) }
        };
        let factor = Cholesky::of(Square::lower(size, entry))?;
        let functions = data.basis.first().map_or(0, Vec::len);
        let column = |k: usize| data.basis.iter().map(|h| h[k]).collect::<Vec<f64>>();
        let trend_forward: Vec<Vec<f64>> = (0..functions).map(|k| factor.forward(&column(k))).collect();
        let product = |i: usize, j: usize| dot(&trend_forward[i], &trend_forward[j]);
        let trend_factor = Cholesky::of(Square::lower(functions, product))?;
        let forward = factor.forward(&data.values);
        let right: Vec<f64> = trend_forward.iter().map(|w| dot(w, &forward)).collect();
        let trend = trend_factor.solve(&right);
        let residual: Vec<f64> =
            data.values.iter().zip(&data.basis).map(|(y, h)| y - dot(h, &trend)).collect();
        let weights = factor.solve(&residual);
        let squares = dot(&residual, &weights) + LEAST_SQUARES;
        Some(Self { factor, trend_factor, trend_forward, trend, weights, squares })
    }

    /// The lower triangle of P.
    pub(super) fn matrix(&self, data: &Data) -> Square {
        let mut matrix = self.factor.inverse();
        let size = matrix.size;
        let columns: Vec<Vec<f64>> = (0..self.trend.len())
            .map(|k| self.factor.solve(&data.basis.iter().map(|h| h[k]).collect::<Vec<f64>>()))
            .collect();
        let at = |i: usize| self.trend_factor.forward(&columns.iter().map(|z| z[i]).collect::<Vec<f64>>());
        let rows: Vec<Vec<f64>> = (0..size).map(at).collect();
        for i in 0..size {
            for j in 0..=i {
                matrix.entries[i * size + j] -= dot(&rows[i], &rows[j]);
            }
        }
        matrix
    }
}
