//! `coulter sweep expand`: from a study to its cases.

use super::folder::Expanded;
use super::source::Source;
use crate::common::{say, say_json};
use crate::failure::Failure;
use coulter::case::resources::format_bytes;
use coulter::formats;
use serde_json::json;
use std::collections::BTreeSet;
use studies::study::ModelKind;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    source: Source,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

pub(super) fn expand(arguments: &Arguments) -> Result<(), Failure> {
    let expanded = arguments.source.expanded()?;
    let Expanded { store, lines, .. } = &expanded;
    let count = |model: ModelKind| {
        lines.iter().filter(|line| line.model == model).map(|line| &line.id).collect::<BTreeSet<_>>().len()
    };
    let refused = lines.iter().filter(|line| !line.refused.is_empty()).count();
    if arguments.json {
        return say_json(&json!({
            "format": formats::DOCUMENT,
            "folder": store.folder,
            "points": lines.last().map_or(0, |line| line.point),
            "closed_form_cases": count(ModelKind::ClosedForm),
            "solver_cases": count(ModelKind::Solver),
            "refused": refused,
            "memory_bytes": lines.iter().map(|line| line.memory_bytes).fold(0.0, f64::max),
        }));
    }
    say(&summary(&expanded))?;
    say(&format!("wrote {}\n", store.list().display()))
}

/// What a study consists of, in a few lines.
pub(super) fn summary(Expanded { study, lines, .. }: &Expanded) -> String {
    let points = lines.last().map_or(0, |line| line.point);
    let distinct = |model: ModelKind| {
        lines.iter().filter(|line| line.model == model).map(|line| &line.id).collect::<BTreeSet<_>>().len()
    };
    let (closed, runs) = (distinct(ModelKind::ClosedForm), distinct(ModelKind::Solver));
    let mut text =
        format!("{}: {points} points, {closed} closed-form cases, {runs} runs of the solver\n", study.title);
    if runs > 0 {
        let most = lines.iter().map(|line| line.memory_bytes).fold(0.0, f64::max);
        text.push_str(&format!("a run needs up to {} of memory\n", format_bytes(most)));
    }
    let mut refused = lines.iter().filter(|line| !line.refused.is_empty());
    if let Some(first) = refused.next() {
        text.push_str(&format!(
            "{} cases are not valid and will be listed as refused; the first one, point {}: {}\n",
            1 + refused.count(),
            first.point,
            first.refused
        ));
    }
    text
}
