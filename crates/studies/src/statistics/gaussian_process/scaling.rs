//! Inputs and values brought to a common scale, and the trend that the points can determine.

use super::super::StatisticsError;

/// Points per coefficient from which on the trend is linear (chosen); with fewer it is a constant.
const POINTS_PER_COEFFICIENT: usize = 3;
/// Least size of the part of a column of the trend that does not follow from those before it, over the
/// column's own size (chosen).
const INDEPENDENT: f64 = 1e-6;

/// How inputs and values are scaled: inputs to 0–1 over their range, values to mean 0 and deviation 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scaling {
    /// Factors of an input, those that do not vary included.
    pub(super) factors: usize,
    /// The factors that vary.
    pub(super) varying: Vec<usize>,
    /// Lowest value of each of the inputs that vary, and their range.
    pub(super) ranges: Vec<[f64; 2]>,
    /// Mean of the values.
    pub(super) mean: f64,
    /// Standard deviation of the values.
    pub(super) deviation: f64,
    /// Scaled inputs that stand in the trend beside the constant.
    pub(super) trend: Vec<usize>,
}

impl Scaling {
    /// The scales of checked data.
    pub(super) fn of(inputs: &[Vec<f64>], values: &[f64]) -> Result<Self, StatisticsError> {
        let factors = inputs.first().map_or(0, Vec::len);
        let (mut varying, mut ranges) = (Vec::new(), Vec::new());
        for factor in 0..factors {
            let column = || inputs.iter().map(|input| input[factor]);
            let (low, high) =
                (column().fold(f64::INFINITY, f64::min), column().fold(f64::NEG_INFINITY, f64::max));
            if high > low {
                varying.push(factor);
                ranges.push([low, high - low]);
            }
        }
        if varying.is_empty() {
            return Err(StatisticsError::EqualInputs);
        }
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let deviation = (values.iter().map(|y| (y - mean) * (y - mean)).sum::<f64>() / count).sqrt();
        // A deviation within rounding of the values is none.
        if deviation <= 1e-13 * mean.abs() || deviation == 0.0 {
            return Err(StatisticsError::EqualValues);
        }
        let mut scaling = Self { factors, varying, ranges, mean, deviation, trend: Vec::new() };
        let scaled: Vec<Vec<f64>> = inputs.iter().map(|input| scaling.input(input)).collect();
        if scaled.len() >= POINTS_PER_COEFFICIENT * (scaling.varying.len() + 1) {
            scaling.trend = independent(&scaled);
        }
        Ok(scaling)
    }

    /// An input in scaled coordinates; what is missing in it is not a number.
    pub(super) fn input(&self, input: &[f64]) -> Vec<f64> {
        let place = |(factor, [low, range]): (&usize, &[f64; 2])| {
            (input.get(*factor).copied().unwrap_or(f64::NAN) - low) / range
        };
        self.varying.iter().zip(&self.ranges).map(place).collect()
    }

    /// A value in scaled coordinates.
    pub(super) fn value(&self, value: f64) -> f64 {
        (value - self.mean) / self.deviation
    }

    /// The functions h(x) of the trend at a scaled input: 1, x.
    pub(super) fn basis(&self, scaled: &[f64]) -> Vec<f64> {
        std::iter::once(1.0).chain(self.trend.iter().map(|k| scaled[*k])).collect()
    }
}

/// The factors whose columns do not follow linearly from those before them: inputs may depend on each other.
fn independent(scaled: &[Vec<f64>]) -> Vec<usize> {
    let length = |column: &[f64]| column.iter().map(|x| x * x).sum::<f64>().sqrt();
    let count = scaled.len() as f64;
    let mut directions = vec![vec![1.0 / count.sqrt(); scaled.len()]];
    let mut found = Vec::new();
    for factor in 0..scaled[0].len() {
        let mut column: Vec<f64> = scaled.iter().map(|input| input[factor]).collect();
        let before = length(&column);
        for direction in &directions {
            let along: f64 = column.iter().zip(direction).map(|(a, b)| a * b).sum();
            column.iter_mut().zip(direction).for_each(|(x, d)| *x -= along * d);
        }
        let after = length(&column);
        if after > INDEPENDENT * before {
            column.iter_mut().for_each(|x| *x /= after);
            directions.push(column);
            found.push(factor);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_that_do_not_vary_or_follow_from_others_are_left_out_of_the_trend() {
        let inputs: Vec<Vec<f64>> =
            (0..12).map(f64::from).map(|x: f64| vec![x, 7.0, 3.0 * x + 1.0, x * x]).collect();
        let values: Vec<f64> = (0..12).map(f64::from).collect();
        let scaling = Scaling::of(&inputs, &values).unwrap();
        assert_eq!(scaling.varying, [0, 2, 3]);
        assert_eq!(scaling.trend, [0, 2]);
        assert_eq!(scaling.basis(&scaling.input(&inputs[11])), [1.0, 1.0, 1.0]);
        assert!(scaling.input(&[0.0]).iter().any(|x| x.is_nan()));
    }
}
