//! Linear regression of a response on the factors, of the numbers or of their ranks: standardised
//! coefficients.

use super::StatisticsError;
use super::data::check;
use numerics::symmetric::{Cholesky, Square, dot};

/// What the correlation matrix keeps on its diagonal, so that factors within rounding of each other are
/// refused (chosen).
const INDEPENDENT: f64 = 1e-9;

/// A linear regression.
#[derive(Clone, Debug, PartialEq)]
pub struct Regression {
    /// The change of the response, in its standard deviations, with one standard deviation of each
    /// factor [–]; 0 for a factor that does not vary.
    pub coefficients: Vec<f64>,
    /// The portion R² of the variance that the regression explains [–]: coefficients say little where it is
    /// low.
    pub determination: f64,
}

/// The regression of `values` on `inputs`, `n × factors` numbers in any units.
///
/// Source: Saltelli et al. (2008), *Global Sensitivity Analysis: The Primer*, section 1.2.5.
///
/// # Errors
/// [`StatisticsError`] for fewer points than factors and two, lists that do not agree, numbers that are not
/// finite, inputs or values that are all equal, and factors that depend linearly on each other.
pub fn linear_regression(inputs: &[Vec<f64>], values: &[f64]) -> Result<Regression, StatisticsError> {
    let factors = data(inputs, values)?;
    let columns: Vec<Vec<f64>> =
        (0..factors).map(|k| inputs.iter().map(|input| input[k]).collect()).collect();
    regression(columns, values.to_vec())
}

/// The regression of the ranks of `values` on those of `inputs`: for responses that rise or fall throughout,
/// but not along a line. Equal numbers share the mean of their ranks.
///
/// # Errors
/// As [`linear_regression`].
pub fn rank_regression(inputs: &[Vec<f64>], values: &[f64]) -> Result<Regression, StatisticsError> {
    let factors = data(inputs, values)?;
    let columns =
        (0..factors).map(|k| ranks(&inputs.iter().map(|input| input[k]).collect::<Vec<_>>())).collect();
    regression(columns, ranks(values))
}

/// The number of factors of data that a regression can be made of.
fn data(inputs: &[Vec<f64>], values: &[f64]) -> Result<usize, StatisticsError> {
    check(inputs, values, inputs.first().map_or(0, Vec::len) + 2, "a regression")
}

fn regression(columns: Vec<Vec<f64>>, values: Vec<f64>) -> Result<Regression, StatisticsError> {
    let values = standardised(values).ok_or(StatisticsError::EqualValues)?;
    let count = columns.len();
    let varying: Vec<(usize, Vec<f64>)> =
        columns.into_iter().enumerate().filter_map(|(k, column)| Some((k, standardised(column)?))).collect();
    if varying.is_empty() {
        return Err(StatisticsError::EqualInputs);
    }
    let correlation = Square::lower(varying.len(), |i, j| dot(&varying[i].1, &varying[j].1));
    let factor = Cholesky::of(correlation).filter(|factor| factor.smallest() > INDEPENDENT);
    let right: Vec<f64> = varying.iter().map(|(_, column)| dot(column, &values)).collect();
    let solution = factor.ok_or(StatisticsError::DependentFactors)?.solve(&right);
    let mut coefficients = vec![0.0; count];
    for ((k, _), coefficient) in varying.iter().zip(&solution) {
        coefficients[*k] = *coefficient;
    }
    Ok(Regression { coefficients, determination: dot(&right, &solution) })
}

/// Numbers with mean 0 and sum of squares 1; `None` where they are all equal.
fn standardised(mut column: Vec<f64>) -> Option<Vec<f64>> {
    let mean = column.iter().sum::<f64>() / column.len() as f64;
    column.iter_mut().for_each(|x| *x -= mean);
    let size = dot(&column, &column).sqrt();
    if size <= 1e-12 * mean.abs() || size == 0.0 {
        return None;
    }
    column.iter_mut().for_each(|x| *x /= size);
    Some(column)
}

/// Ranks from 1 on.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut before = 0;
    for equal in order.chunk_by(|a, b| values[*a] == values[*b]) {
        let rank = before as f64 + 0.5 * (equal.len() + 1) as f64;
        equal.iter().for_each(|n| ranks[*n] = rank);
        before += equal.len();
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::super::design::sobol;
    use super::*;

    #[test]
    fn a_linear_response_gives_its_coefficients() {
        let design = sobol(256, 3, 1).unwrap();
        let values: Vec<f64> = design.iter().map(|x| 7.0 + 3.0 * x[0] - 4.0 * x[1]).collect();
        let found = linear_regression(&design, &values).unwrap();
        assert!((found.determination - 1.0).abs() < 1e-12);
        for (coefficient, exact) in found.coefficients.iter().zip([0.6, -0.8, 0.0]) {
            assert!((coefficient - exact).abs() < 0.01, "{found:?}");
        }
    }

    #[test]
    fn ranks_follow_a_curve_that_rises_throughout() {
        let design = sobol(256, 2, 1).unwrap();
        let values: Vec<f64> = design.iter().map(|x| (12.0 * x[0]).exp()).collect();
        assert!(linear_regression(&design, &values).unwrap().determination < 0.6);
        let found = rank_regression(&design, &values).unwrap();
        assert!((found.coefficients[0] - 1.0).abs() < 1e-9 && found.determination > 0.999_999);
        assert_eq!(ranks(&[5.0, 1.0, 5.0, 0.0]), [3.5, 2.0, 3.5, 1.0]);
    }

    #[test]
    fn factors_that_depend_on_each_other_are_refused() {
        let inputs: Vec<Vec<f64>> = (0..9).map(f64::from).map(|x: f64| vec![x, 2.0 * x + 1.0, 4.0]).collect();
        let values: Vec<f64> = (0..9).map(|n| f64::from(n * n)).collect();
        assert_eq!(linear_regression(&inputs, &values), Err(StatisticsError::DependentFactors));
        let first: Vec<Vec<f64>> = inputs.iter().map(|x| vec![x[0], x[2]]).collect();
        assert_eq!(linear_regression(&first, &values).unwrap().coefficients[1], 0.0);
    }
}
