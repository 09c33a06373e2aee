//! The points of one model at which a response and all factors have values.

use super::factors::VariedFactor;

/// Inputs and values.
#[derive(Clone, Debug, Default)]
pub(super) struct Sample {
    /// The factors at each point, `n × factors`.
    pub(super) inputs: Vec<Vec<f64>>,
    /// The response at each point.
    pub(super) values: Vec<f64>,
}

impl Sample {
    /// The points among `rows`.
    pub(super) fn of(factors: &[VariedFactor<'_>], response: &[Option<f64>], rows: &[usize]) -> Self {
        let mut sample = Self::default();
        for row in rows {
            let input: Option<Vec<f64>> = factors.iter().map(|factor| factor.numbers[*row]).collect();
            if let Some((input, value)) = input.zip(response[*row].filter(|y| y.is_finite())) {
                sample.inputs.push(input);
                sample.values.push(value);
            }
        }
        sample
    }

    /// The values of a factor.
    pub(super) fn column(&self, factor: usize) -> Vec<f64> {
        self.inputs.iter().map(|input| input[factor]).collect()
    }

    /// Lowest and highest value of a factor.
    pub(super) fn range(&self, factor: usize) -> [f64; 2] {
        let values = || self.inputs.iter().map(|input| input[factor]);
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// Whether the response takes more than one value.
    pub(super) fn varies(&self) -> bool {
        self.values.iter().any(|value| *value != self.values[0])
    }
}
