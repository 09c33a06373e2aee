//! Fitting: checked data, hyperparameters, process.

use super::super::StatisticsError;
use super::super::data::check;
use super::super::design::generator;
use super::hyperparameters::hyperparameters;
use super::process::GaussianProcess;
use super::projection::Data;
use super::scaling::Scaling;

/// Fewest points of a fit, and points more than factors (chosen).
const LEAST_POINTS: usize = 5;
const MORE_THAN_FACTORS: usize = 2;
/// Points from which hyperparameters are found, at most (chosen): the time grows with the third power.
const POINTS_FOR_HYPERPARAMETERS: usize = 250;
/// Points of a process, at most (chosen): some seconds and 100 MB.
const MOST_POINTS: usize = 2000;

/// Fits a Gaussian process to the values of a response at inputs, `n × factors` numbers in any units.
///
/// Deterministic. Of more than 250 points as many are drawn for lengths and nugget; of more than 2000 the
/// process itself keeps as many.
///
/// # Errors
/// [`StatisticsError`] for fewer than five points or than factors and two, lists that do not agree, numbers
/// that are not finite, inputs or values that are all equal, and data whose covariance is not positive
/// definite.
pub fn fit(inputs: &[Vec<f64>], values: &[f64]) -> Result<GaussianProcess, StatisticsError> {
    let factors = inputs.first().map_or(0, Vec::len);
    check(inputs, values, LEAST_POINTS.max(factors + MORE_THAN_FACTORS), "a surrogate")?;
    let kept = drawn(inputs.len(), MOST_POINTS);
    let inputs: Vec<Vec<f64>> = kept.iter().map(|n| inputs[*n].clone()).collect();
    let values: Vec<f64> = kept.iter().map(|n| values[*n]).collect();
    let scaling = Scaling::of(&inputs, &values)?;
    let all: Vec<usize> = (0..inputs.len()).collect();
    let data = scaled(&scaling, &inputs, &values, &all);
    let few = drawn(inputs.len(), POINTS_FOR_HYPERPARAMETERS);
    let correlation = if few.len() == all.len() {
        hyperparameters(&data)
    } else {
        hyperparameters(&scaled(&scaling, &inputs, &values, &few))
    };
    let correlation = correlation.ok_or(StatisticsError::NotPositiveDefinite)?;
    GaussianProcess::of(scaling, data, correlation).ok_or(StatisticsError::NotPositiveDefinite)
}

/// At most `most` of the numbers below `count`, in order, drawn at random: a fixed stride would alias with
/// the design.
fn drawn(count: usize, most: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    if count > most {
        let mut random = generator(count as u64);
        for n in 0..most {
            order.swap(n, n + random.below(count - n));
        }
        order.truncate(most);
        order.sort_unstable();
    }
    order
}

fn scaled(scaling: &Scaling, inputs: &[Vec<f64>], values: &[f64], which: &[usize]) -> Data {
    let inputs: Vec<Vec<f64>> = which.iter().map(|n| scaling.input(&inputs[*n])).collect();
    let basis = inputs.iter().map(|input| scaling.basis(input)).collect();
    Data { basis, inputs, values: which.iter().map(|n| scaling.value(values[*n])).collect() }
}

#[cfg(test)]
mod tests {
    use super::super::super::design::latin_hypercube;
    use super::*;

    /// A smooth response of two factors that matter and one that does not.
    fn smooth(x: &[f64]) -> f64 {
        1000.0 + 300.0 * (4.0 * x[0]).sin() * (1.0 + x[1]) + 50.0 * x[1] * x[1]
    }

    #[test]
    fn a_smooth_response_is_predicted_and_its_error_known() {
        let design = latin_hypercube(60, 3, 1).unwrap();
        let values: Vec<f64> = design.iter().map(|x| smooth(x)).collect();
        let process = fit(&design, &values).unwrap();
        assert!(process.predictivity() > 0.99, "{}", process.predictivity());
        assert!(process.trusted().is_ok());
        let lengths = process.lengths();
        assert!(lengths[2] > 3.0 * lengths[0], "{lengths:?}");
        let fresh = latin_hypercube(200, 3, 2).unwrap();
        let within = fresh.iter().filter(|x| {
            let predicted = process.predict(x);
            assert_eq!(predicted.mean, process.mean(x));
            assert!((predicted.mean - smooth(x)).abs() < 40.0);
            (predicted.mean - smooth(x)).abs() < 2.0 * predicted.deviation + 1e-3
        });
        assert!(within.count() > 170);
        let at_a_point = process.predict(&design[0]);
        assert!((at_a_point.mean - values[0]).abs() < 1.0 && at_a_point.deviation < 3.0, "{at_a_point:?}");
    }

    #[test]
    fn leaving_a_point_out_by_formula_is_leaving_it_out() {
        let design = latin_hypercube(15, 2, 4).unwrap();
        let values: Vec<f64> = design.iter().map(|x| smooth(x)).collect();
        let all: Vec<usize> = (0..15).collect();
        let scaling = Scaling::of(&design, &values).unwrap();
        let data = scaled(&scaling, &design, &values, &all);
        let correlation = hyperparameters(&data).unwrap();
        let whole = GaussianProcess::of(scaling.clone(), data, correlation.clone()).unwrap();
        for out in 0..15 {
            let others: Vec<usize> = all.iter().copied().filter(|n| *n != out).collect();
            let data = scaled(&scaling, &design, &values, &others);
            let rest = GaussianProcess::of(scaling.clone(), data, correlation.clone()).unwrap();
            let (direct, formula) = (rest.predict(&design[out]).mean, whole.left_out()[out].mean);
            assert!((direct - formula).abs() < 1e-4 * 300.0, "{out}: {direct} {formula}");
        }
    }

    #[test]
    fn noise_is_found_and_not_followed() {
        let design = latin_hypercube(150, 2, 3).unwrap();
        let mut random = generator(1);
        let noisy: Vec<f64> = design.iter().map(|x| smooth(x) + 60.0 * (random.uniform() - 0.5)).collect();
        let process = fit(&design, &noisy).unwrap();
        // The deviation of an even distribution is its width over √12: 17.3.
        assert!((process.noise() - 17.3).abs() < 5.0, "{}", process.noise());
        let fresh = latin_hypercube(100, 2, 9).unwrap();
        assert!(fresh.iter().all(|x| (process.mean(x) - smooth(x)).abs() < 40.0));
    }

    #[test]
    fn a_linear_response_is_the_trend() {
        let design = latin_hypercube(20, 2, 8).unwrap();
        let values: Vec<f64> = design.iter().map(|x| 3.0 - 2.0 * x[0] + 7.0 * x[1]).collect();
        let process = fit(&design, &values).unwrap();
        assert!(process.predictivity() > 0.999_999);
        assert!((process.mean(&[2.0, -1.0]) + 8.0).abs() < 1e-3);
    }

    #[test]
    fn chance_is_not_predicted() {
        let design = latin_hypercube(40, 4, 3).unwrap();
        let mut random = generator(2);
        let values: Vec<f64> = design.iter().map(|_| random.uniform()).collect();
        let process = fit(&design, &values).unwrap();
        assert!(matches!(process.trusted(), Err(StatisticsError::NotPredictive { .. })));
    }

    #[test]
    fn data_that_cannot_be_fitted_are_refused() {
        let design = latin_hypercube(8, 2, 3).unwrap();
        let values: Vec<f64> = design.iter().map(|x| x[0]).collect();
        let refusal = |inputs: &[Vec<f64>], values: &[f64]| fit(inputs, values).unwrap_err();
        assert!(matches!(refusal(&design[..4], &values[..4]), StatisticsError::TooFewPoints { .. }));
        assert!(matches!(refusal(&design, &values[..7]), StatisticsError::Shape { .. }));
        assert!(matches!(refusal(&design, &[1.0; 8]), StatisticsError::EqualValues));
        assert!(matches!(refusal(&vec![vec![1.0, 2.0]; 8], &values), StatisticsError::EqualInputs));
        let mut holed = values.clone();
        holed[3] = f64::NAN;
        assert_eq!(refusal(&design, &holed), StatisticsError::NotFinite { point: 3 });
        // Points that stand twice, with other values, are noise.
        let twice = [design.clone(), design].concat();
        let other: Vec<f64> = values.iter().copied().chain(values.iter().map(|y| y + 0.1)).collect();
        assert!(fit(&twice, &other).unwrap().noise() > 0.03);
    }

    #[test]
    fn of_many_points_some_are_drawn() {
        let some = drawn(1000, 250);
        assert_eq!((some.len(), some.windows(2).all(|pair| pair[0] < pair[1])), (250, true));
        assert_eq!(drawn(3, 250), [0, 1, 2]);
    }
}
