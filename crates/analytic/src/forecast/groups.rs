//! Dimensionless groups of a case.

use super::{Load, ModelForecast, Towing};

/// Dimensionless groups; the scales are d for lengths and γ t d² for forces, s_u t d in undrained clay.
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
    /// Cohesion c/(γ d); none in weightless soil.
    pub cohesion: Option<f64>,
    /// Drag F̄_H = F_H/(γ t d²).
    pub drag: Option<f64>,
    /// Vertical force F̄_V = F_V/(γ t d²).
    pub vertical: Option<f64>,
}

impl Groups {
    /// The groups of a case and of the prediction of its recommended model.
    pub(super) fn of(towing: &Towing, best: Option<&ModelForecast>) -> Self {
        let found = best.and_then(|model| model.prediction);
        let (d, gamma) = (towing.body.length(), towing.soil.unit_weight);
        let scale = towing.body.force_scale(&towing.soil);
        let (held, weight) = match towing.load {
            Load::Weight(weight) => (None, Some(weight / scale)),
            Load::Sinkage(z) => (Some(z / d), None),
        };
        Self {
            sinkage: held.or_else(|| found.and_then(|p| p.sinkage).map(|z| z / d)),
            thickness: towing.body.width() / d,
            weight,
            stiffness: towing.elastic_modulus.filter(|_| gamma > 0.0).map(|modulus| modulus / (gamma * d)),
            cohesion: (gamma > 0.0).then(|| towing.soil.cohesion / (gamma * d)),
            drag: found.map(|p| p.drag / scale),
            vertical: found.map(|p| p.vertical / scale),
        }
    }
}
