//! Scatter between the models.

use super::ModelForecast;

/// Minimum, median and maximum of several values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Minimum.
    pub low: f64,
    /// Median.
    pub middle: f64,
    /// Maximum.
    pub high: f64,
}

impl Range {
    fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let (low, high) = (*values.first()?, *values.last()?);
        let half = values.len() / 2;
        let middle =
            if values.len() % 2 == 1 { values[half] } else { 0.5 * (values[half - 1] + values[half]) };
        Some(Self { low, middle, high })
    }
}

/// Scatter between the applicable models. They are not independent, so this is not a confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    /// Number of models.
    pub count: usize,
    /// Drag [N].
    pub drag: Range,
    /// Vertical force [N].
    pub vertical: Range,
    /// Sinkage [m].
    pub sinkage: Option<Range>,
}

impl Scatter {
    /// Scatter over the applicable models; BC and PW of a disc count once, by the governing mechanism.
    pub(super) fn of(models: &[ModelForecast]) -> Option<Self> {
        use super::Candidate::{Bearing, Governing, Wedge};
        let joined = models.iter().any(|m| m.model == Governing && m.applicable);
        let counted =
            models.iter().filter(|m| m.applicable && !(joined && matches!(m.model, Bearing | Wedge)));
        let found: Vec<_> = counted.filter_map(|m| m.prediction).collect();
        Some(Self {
            count: found.len(),
            drag: Range::of(found.iter().map(|p| p.drag).collect())?,
            vertical: Range::of(found.iter().map(|p| p.vertical).collect())?,
            sinkage: Range::of(found.iter().filter_map(|p| p.sinkage).collect()),
        })
    }
}
