//! The checks that the variations of a case give.

use super::figures::{BodyConfidence, Confidence, ConfidenceInterval, Status, VariationResult};
use crate::confidence::variations::ErrorSource;
use crate::trust::Check;
use crate::trust::limits::{self, Limit};

/// The sources with a check of their own.
const EFFECTS: [(ErrorSource, &Limit); 4] = [
    (ErrorSource::Mesh, &limits::EFFECT_OF_MESH),
    (ErrorSource::Domain, &limits::EFFECT_OF_DOMAIN),
    (ErrorSource::Speed, &limits::EFFECT_OF_SPEED),
    (ErrorSource::Precision, &limits::EFFECT_OF_PRECISION),
];

impl Confidence {
    /// The checks: for each body the largest effect of every source that was examined, its widest interval
    /// and whether its force still changes, and what is missing.
    #[must_use]
    pub fn checks(&self) -> Vec<Check> {
        let mut checks = Vec::new();
        for (name, body) in &self.bodies {
            checks.extend(of_body(name, body));
        }
        // A broken mesh is replaced by another one.
        let is_mesh = |v: &&VariationResult| v.source == ErrorSource::Mesh;
        let has_mesh = self.variations.iter().filter(is_mesh).any(|v| v.status == Status::Examined);
        let is_replaced = |v: &&VariationResult| has_mesh && is_mesh(v) && v.status == Status::Broken;
        let missing = self.variations.iter().filter(|v| v.status.is_missing() && !is_replaced(v));
        let mut names: Vec<String> =
            missing.map(|v| format!("{} is {}", v.name.replace('_', " "), v.status.words())).collect();
        names.extend(self.bodies.iter().filter_map(|(name, body)| without_statistics(name, body)));
        let check = Check::of(&limits::MISSING_VARIATIONS, None, names.len() as f64);
        let advice =
            if names.is_empty() { String::new() } else { format!("{}: {}", names.join(", "), check.advice) };
        checks.push(Check { advice, ..check });
        checks
    }
}

fn of_body(name: &str, body: &BodyConfidence) -> Vec<Check> {
    if let Some(why) = &body.no_interval_because {
        let why = format!("there is no interval: {why}");
        return vec![Check::unavailable(&limits::CONFIDENCE, Some(name), &why)];
    }
    let figures = || body.figures.values();
    let effect = |(source, limit): (ErrorSource, &'static Limit)| {
        Some(Check::of(limit, Some(name), worst(figures().filter_map(|f| effect_of(f, source)))?))
    };
    let mut checks: Vec<Check> = EFFECTS.into_iter().filter_map(effect).collect();
    let width = |f: &ConfidenceInterval| 100.0 * f.relative_half_width.unwrap_or(f64::INFINITY);
    checks.extend(worst(figures().map(width)).map(|width| Check::of(&limits::CONFIDENCE, Some(name), width)));
    let change = body.force_change.map(|change| 100.0 * change);
    checks.extend(change.map(|change| Check::of(&limits::LEVEL_FORCE, Some(name), change)));
    checks
}

/// A body whose window is too short for statistics.
fn without_statistics(name: &str, body: &BodyConfidence) -> Option<String> {
    let parts = body.figures.values().flat_map(|figure| &figure.contributions);
    let missing =
        parts.filter(|part| part.source == ErrorSource::Statistics).find_map(|part| part.because.as_ref())?;
    Some(format!("statistics of {name}: {missing}"))
}

/// What a source contributes [%], if it was examined.
fn effect_of(figure: &ConfidenceInterval, source: ErrorSource) -> Option<f64> {
    let part = figure.contributions.iter().find(|c| c.source == source && c.because.is_none())?;
    Some(100.0 * part.relative.unwrap_or(f64::INFINITY))
}

fn worst(values: impl Iterator<Item = f64>) -> Option<f64> {
    values.reduce(f64::max)
}
