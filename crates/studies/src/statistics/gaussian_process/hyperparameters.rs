//! Lengths and nugget from the data: the largest restricted likelihood under weak priors.

use super::correlation::Correlation;
use super::projection::{Data, Projection};
use numerics::quasi_newton::minimise;

/// The smallest nugget (chosen): it keeps the matrix positive definite and is far below any scatter of
/// results.
const LEAST_NUGGET: f64 = 1e-10;
/// Deviation of the logarithm of a length under its prior; the prior's median is the diagonal of the unit
/// cube, √d. Source: Hvarfner, Hellsten & Nardi (2024), *Vanilla Bayesian Optimization Performs Great in High
/// Dimensions*.
const LENGTH_DEVIATION: f64 = 1.732_050_807_568_877_2;
/// Median of the nugget under its prior, and the deviation of its logarithm (chosen): noise must show to be
/// believed.
const NUGGET: [f64; 2] = [1e-5, 3.0];
/// Where searches start: lengths over their median, nugget (chosen): smooth, short, and noisy.
const STARTS: [[f64; 2]; 3] = [[1.0, 1e-6], [0.25, 1e-3], [2.0, 0.1]];

/// The hyperparameters that suit the data best; `None` where no search finds any.
pub(super) fn hyperparameters(data: &Data) -> Option<Correlation> {
    let factors = data.inputs.first().map_or(0, Vec::len);
    let median = 0.5 * (factors as f64).ln();
    let searched = STARTS.iter().filter_map(|[length, nugget]| {
        let mut start = vec![median + length.ln(); factors];
        start.push(nugget.ln());
        minimise(start, |parameters| objective(data, parameters))
    });
    // The first of equals is kept, so that the result does not hang on rounding.
    let best = searched.reduce(|best, next| if next.value < best.value { next } else { best })?;
    Some(correlation(&best.place))
}

/// The correlation of a place: logarithms of the lengths, then that of the nugget.
fn correlation(place: &[f64]) -> Correlation {
    let (lengths, nugget) = place.split_at(place.len() - 1);
    Correlation {
        inverse_lengths: lengths.iter().map(|length| (-length).exp()).collect(),
        nugget: LEAST_NUGGET + nugget[0].exp(),
    }
}

/// Minus the logarithm of the restricted likelihood and of the priors, and its gradient.
///
/// ½ [(n − p) ln yᵀPy + ln |R| + ln |HᵀR⁻¹H|], without constants: Rasmussen & Williams (2006), eq. (2.45),
/// with σ² at its optimum; the gradient ½ [tr(P ∂R) − (n − p) yᵀP ∂R P y / yᵀPy] as in their eq. (5.9).
fn objective(data: &Data, place: &[f64]) -> Option<(f64, Vec<f64>)> {
    let correlation = correlation(place);
    let projection = Projection::of(data, &correlation)?;
    let freedom = data.freedom();
    let likelihood = 0.5
        * (freedom * projection.squares.ln()
            + projection.factor.log_determinant()
            + projection.trend_factor.log_determinant());
    let mut gradient = slope(data, &correlation, &projection);
    let mut value = likelihood;
    let last = place.len() - 1;
    // The least nugget is no parameter.
    gradient[last] *= place[last].exp();
    let median = 0.5 * (last as f64).ln();
    for (k, x) in place.iter().enumerate() {
        let (middle, deviation) =
            if k < last { (median, LENGTH_DEVIATION) } else { (NUGGET[0].ln(), NUGGET[1]) };
        let away = (x - middle) / deviation;
        value += 0.5 * away * away;
        gradient[k] += away / deviation;
    }
    value.is_finite().then_some((value, gradient))
}

/// The gradient of the likelihood by the logarithm of each length, then by the nugget itself.
fn slope(data: &Data, correlation: &Correlation, projection: &Projection) -> Vec<f64> {
    let matrix = projection.matrix(data);
    let scale = data.freedom() / projection.squares;
    let (inputs, weights) = (&data.inputs, &projection.weights);
    let factors = correlation.inverse_lengths.len();
    let mut sums = vec![0.0; factors + 1];
    for i in 0..inputs.len() {
        let row = matrix.row(i);
        sums[factors] += 0.5 * (row[i] - scale * weights[i] * weights[i]);
        for j in 0..i {
            // Each pair stands twice in the sum over the matrix, which the half in front makes up for.
            let weight = row[j] - scale * weights[i] * weights[j];
            let shared = weight * correlation.with_slope(&inputs[i], &inputs[j]).1;
            for (k, sum) in sums[..factors].iter_mut().enumerate() {
                *sum += shared * correlation.part(k, &inputs[i], &inputs[j]);
            }
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gradient_is_that_of_the_objective() {
        let design = super::super::super::design::latin_hypercube(20, 2, 1).unwrap();
        let data = Data {
            basis: design.iter().map(|x| vec![1.0, x[0], x[1]]).collect(),
            values: design.iter().map(|x| (5.0 * x[0]).sin() + x[1] * x[1]).collect(),
            inputs: design,
        };
        let place = [-0.4, 0.3, -3.0];
        let (_, gradient) = objective(&data, &place).unwrap();
        for k in 0..3 {
            let at = |step: f64| {
                let mut moved = place;
                moved[k] += step;
                objective(&data, &moved).unwrap().0
            };
            let numeric = (at(1e-5) - at(-1e-5)) / 2e-5;
            assert!(
                (numeric - gradient[k]).abs() < 1e-5 * (1.0 + numeric.abs()),
                "{k} {numeric} {gradient:?}"
            );
        }
    }
}
