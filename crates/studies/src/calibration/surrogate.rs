//! A surrogate of the solver's curves: Gaussian processes of their principal components over the unknowns.
//!
//! Source: Higdon, Gattiker, Williams & Rightley (2008), Computer model calibration using high-dimensional
//! output, JASA 103(482).

use super::likelihood::{Response, Seen};
use super::space::Space;
use crate::statistics::StatisticsError;
use crate::statistics::gaussian_process::{GaussianProcess, Predicted, fit};
use numerics::symmetric::{dot, eigen};

/// Fraction of the variance of the curves that the components hold (chosen).
const KEPT: f64 = 0.9995;
/// Components at most.
const MOST: usize = 6;
/// Standard deviation of a component over that of the first below which it is none.
const NONE: f64 = 1e-6;

/// A surrogate.
#[derive(Clone, Debug)]
pub struct Surrogate {
    space: Space,
    mean: Vec<f64>,
    components: Vec<Component>,
    /// Variance of each point that the components leave out.
    left: Vec<f64>,
}

#[derive(Clone, Debug)]
struct Component {
    /// Direction of the component: one number for each point.
    direction: Vec<f64>,
    /// Amount of the component over the unknowns.
    process: GaussianProcess,
    /// Factor on the error that the process states: that of points left out over what it states of them, at
    /// least 1.
    inflation: f64,
}

/// How much larger the errors of points left out of a process are than it says, root mean square; at least 1.
/// With few runs lengths and nugget are uncertain themselves, and a process that takes them for known is too
/// sure of itself.
fn inflation(process: &GaussianProcess, amounts: &[f64]) -> f64 {
    let ratio = |(left_out, amount): (&Predicted, &f64)| {
        ((amount - left_out.mean) / left_out.deviation.max(f64::MIN_POSITIVE)).powi(2)
    };
    let squares: f64 = process.left_out().iter().zip(amounts).map(ratio).sum();
    let mean = squares / amounts.len().max(1) as f64;
    if mean.is_finite() { mean.sqrt().max(1.0) } else { 1.0 }
}

impl Surrogate {
    /// A surrogate from curves, as residuals see them, at values of the unknowns.
    ///
    /// # Errors
    /// [`StatisticsError`] where there are too few, or none varies.
    pub fn of(space: &Space, points: &[(Vec<f64>, Vec<f64>)]) -> Result<Self, StatisticsError> {
        let count = points.len();
        let length = points.first().map_or(0, |(_, curve)| curve.len());
        let mean: Vec<f64> = (0..length)
            .map(|n| points.iter().map(|(_, curve)| curve[n]).sum::<f64>() / count as f64)
            .collect();
        let centred: Vec<Vec<f64>> =
            points.iter().map(|(_, curve)| curve.iter().zip(&mean).map(|(c, m)| c - m).collect()).collect();
        let inputs: Vec<Vec<f64>> = points.iter().map(|(values, _)| space.coordinates(values)).collect();
        // Of the smaller of the two matrices of products; its eigenvectors give the directions.
        let entry = |i: usize, j: usize| centred.iter().map(|c| c[i] * c[j]).sum::<f64>() / count as f64;
        let matrix: Vec<Vec<f64>> = (0..length).map(|i| (0..length).map(|j| entry(i, j)).collect()).collect();
        let (variances, directions) = eigen(&matrix);
        let total: f64 = variances.iter().map(|v| v.max(0.0)).sum();
        let (mut components, mut held) = (Vec::new(), 0.0);
        for (variance, direction) in variances.iter().zip(directions).take(MOST) {
            let is_none = *variance <= NONE * NONE * total;
            if held >= KEPT * total || is_none {
                break;
            }
            held += variance;
            let amounts: Vec<f64> = centred.iter().map(|curve| dot(curve, &direction)).collect();
            let process = fit(&inputs, &amounts)?;
            let inflation = inflation(&process, &amounts);
            components.push(Component { process, direction, inflation });
        }
        if components.is_empty() {
            return Err(StatisticsError::EqualValues);
        }
        let left = |n: usize| {
            let held: f64 =
                components.iter().map(|c| c.direction[n].powi(2) * variance_of(c, &centred)).sum();
            (matrix[n][n] - held).max(0.0)
        };
        Ok(Self { space: space.clone(), left: (0..length).map(left).collect(), mean, components })
    }

    /// The least predictivity Q² of the components of the surrogate that matter: 1 is perfect, 0 no better
    /// than their mean.
    #[must_use]
    pub fn predictivity(&self) -> f64 {
        self.components.first().map_or(0.0, |component| component.process.predictivity())
    }

    /// The number of components.
    #[must_use]
    pub fn components(&self) -> usize {
        self.components.len()
    }

    /// Standard deviation of the surrogate's error at values, the mean over the points.
    #[must_use]
    pub fn error_at(&self, values: &[f64]) -> f64 {
        let seen = self.seen(values);
        let square = |n: usize| {
            seen.shared.iter().map(|column| column[n] * column[n]).sum::<f64>() + seen.variances[n]
        };
        let count = self.mean.len().max(1);
        ((0..self.mean.len()).map(square).sum::<f64>() / count as f64).sqrt()
    }

    fn seen(&self, values: &[f64]) -> Seen {
        let coordinates = self.space.coordinates(values);
        let mut seen = Seen { values: self.mean.clone(), shared: Vec::new(), variances: self.left.clone() };
        for component in &self.components {
            let predicted = component.process.predict(&coordinates);
            for (value, part) in seen.values.iter_mut().zip(&component.direction) {
                *value += predicted.mean * part;
            }
            // The process predicts the mean of runs; a run lies about it by its scatter, the nugget.
            let deviation = (component.inflation * predicted.deviation).hypot(component.process.noise());
            seen.shared.push(component.direction.iter().map(|part| deviation * part).collect());
        }
        seen
    }
}

fn variance_of(component: &Component, centred: &[Vec<f64>]) -> f64 {
    centred.iter().map(|curve| dot(curve, &component.direction).powi(2)).sum::<f64>() / centred.len() as f64
}

impl Response for Surrogate {
    fn at(&self, values: &[f64]) -> Result<Seen, String> {
        Ok(self.seen(values))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statistics::design::latin_hypercube;

    #[test]
    fn a_family_of_curves_is_predicted_with_its_error() {
        let space = Space::read(&["body.a=0..1".to_owned(), "body.b=0..1".to_owned()], &[]).unwrap();
        let curve = |v: &[f64]| -> Vec<f64> {
            (1..=12).map(|n| (v[0] * f64::from(n) * 0.2).exp() + v[1] * f64::from(n).sqrt()).collect()
        };
        let design = latin_hypercube(24, 2, 5).unwrap();
        let points: Vec<_> = design.iter().map(|values| (values.clone(), curve(values))).collect();
        let surrogate = Surrogate::of(&space, &points).unwrap();
        assert!(surrogate.predictivity() > 0.98 && surrogate.components() <= 4);
        for values in latin_hypercube(20, 2, 6).unwrap() {
            let seen = surrogate.at(&values).unwrap();
            for (n, (found, known)) in seen.values.iter().zip(curve(&values)).enumerate() {
                let variance: f64 = seen.shared.iter().map(|c| c[n] * c[n]).sum::<f64>() + seen.variances[n];
                assert!((found - known).abs() < 5.0 * variance.sqrt() + 0.05, "{found} {known}");
            }
        }
        assert!(Surrogate::of(&space, &points[..3]).is_err());
    }
}
