//! Dimensionless groups, and the spread over the models.

use super::{Load, ModelForecast, Towing};

/// Dimensionless groups; the scales are d for lengths and γ t d² for forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groups {
    /// Sinkage Z = z/d.
    pub sinkage: Option<f64>,
    /// Thickness or width t̄ = t/d.
    pub thickness: f64,
    /// Weight W̄ = W/(γ t d²).
    pub weight: Option<f64>,
    /// Stiffness Ē = E/(γ d).
    pub stiffness: Option<f64>,
    /// Cohesion c/(γ d).
    pub cohesion: f64,
    /// Drag F̄_H = F_H/(γ t d²).
    pub drag: Option<f64>,
    /// Vertical force F̄_V = F_V/(γ t d²).
    pub vertical: Option<f64>,
}

impl Groups {
    /// The groups of a case and of the answer of its best model.
    pub(super) fn of(towing: &Towing, best: Option<&ModelForecast>) -> Self {
        let found = best.and_then(|model| model.prediction);
        let (d, gamma) = (towing.body.length(), towing.soil.unit_weight);
        let scale = towing.body.force_scale(gamma);
        let (held, weight) = match towing.load {
            Load::Weight(weight) => (None, Some(weight / scale)),
            Load::Sinkage(z) => (Some(z / d), None),
        };
        Self {
            sinkage: held.or_else(|| found.and_then(|p| p.sinkage).map(|z| z / d)),
            thickness: towing.body.width() / d,
            weight,
            stiffness: towing.elastic_modulus.map(|modulus| modulus / (gamma * d)),
            cohesion: towing.soil.cohesion / (gamma * d),
            drag: found.map(|p| p.drag / scale),
            vertical: found.map(|p| p.vertical / scale),
        }
    }
}

/// Least, middle and largest of several values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Least.
    pub low: f64,
    /// Median.
    pub middle: f64,
    /// Largest.
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

/// How far the applicable models lie apart; the models are not independent, so this is no confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// How many models.
    pub count: usize,
    /// Drag [N].
    pub drag: Range,
    /// Vertical force [N].
    pub vertical: Range,
    /// Sinkage [m].
    pub sinkage: Option<Range>,
}

impl Spread {
    /// Over the applicable models; BC and PW of a disc count once, as the weaker of them.
    pub(super) fn of(models: &[ModelForecast]) -> Option<Self> {
        use super::Candidate::{Bearing, Weaker, Wedge};
        let joined = models.iter().any(|m| m.model == Weaker && m.applicable);
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
