//! The variations of a case, and what they cost.

use super::cost::time_in_words;
use coulter::case::Case;
use coulter::confidence::variations::{LeftOut, VariationPlan};
use coulter::run::relative_cost;
use serde::Serialize;
use std::fmt::Write;

/// One variation.
#[derive(Debug, Serialize)]
struct VariationCost {
    name: String,
    source: &'static str,
    what: String,
    /// Work over that of the case itself.
    relative_cost: f64,
    /// Estimated time of the variation's run on this machine [s].
    estimated_wall_s: Option<f64>,
}

/// The cost of all variations, and those that do not apply: name and reason.
#[derive(Debug, Serialize)]
pub(super) struct VariationCosts {
    runs: Vec<VariationCost>,
    left_out: Vec<[String; 2]>,
}

impl VariationCosts {
    pub(super) fn of(case: &Case, seconds: Option<f64>, plan: &VariationPlan) -> Self {
        let runs = plan.variations.iter().map(|variation| VariationCost {
            name: variation.name.clone(),
            source: variation.source.word(),
            what: variation.what.clone(),
            relative_cost: relative_cost(case, variation),
            estimated_wall_s: seconds.map(|seconds| seconds * relative_cost(case, variation)),
        });
        let asked = plan.left_out.iter().filter(|left_out| left_out.is_asked_for);
        let left_out = |left_out: &LeftOut| [left_out.name.clone(), left_out.why.clone()];
        Self { runs: runs.collect(), left_out: asked.map(left_out).collect() }
    }

    /// A line for each, and one for all of them.
    pub(super) fn describe(&self, text: &mut String) -> std::fmt::Result {
        for VariationCost { source, what, relative_cost, .. } in &self.runs {
            writeln!(
                text,
                "varied   {source}: {what}, {relative_cost:.2} times the work of the case itself"
            )?;
        }
        for [name, why] in &self.left_out {
            writeln!(text, "varied   not {}: {why}", name.replace('_', " "))?;
        }
        let sum: f64 = self.runs.iter().map(|run| run.relative_cost).sum();
        let seconds: Option<f64> = self.runs.iter().map(|run| run.estimated_wall_s).sum();
        let time = seconds.map_or(String::new(), |seconds| format!(", about {}", time_in_words(seconds)));
        writeln!(text, "varied   together {sum:.2} times the work of the case itself{time}")
    }
}
