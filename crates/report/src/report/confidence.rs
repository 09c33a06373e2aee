//! Intervals as people read them: on the terminal and in the report.

use super::rows::value;
use super::summary::{BodySummary, Summary};
use crate::plots::{MeshPlot, Plot};
use input::readable::{Unit, digits};
use results::confidence::variations::ErrorSource;
use results::confidence::{
    BodyConfidence, Confidence, ConfidenceInterval, Contribution, Status, VariationResult,
};
use results::history::quantities::Quantity;
use serde::Serialize;
use std::collections::BTreeMap;

/// A variation.
#[derive(Debug, Serialize)]
pub(super) struct VariationRow {
    pub(super) name: String,
    pub(super) source: &'static str,
    /// What differs in the variation, or why it does not count.
    pub(super) what: String,
    pub(super) status: &'static str,
    pub(super) time: String,
    /// The figures of the bodies in the variation; empty where there are none.
    pub(super) figures: String,
    /// Grade of the variation; empty where it was not run.
    pub(super) verdict: &'static str,
    pub(super) folder: String,
}

/// A figure with its interval.
#[derive(Debug, Serialize)]
pub(super) struct FigureRow {
    pub(super) name: String,
    pub(super) value: String,
    pub(super) interval: String,
    pub(super) half_width: String,
    pub(super) dominated: String,
    pub(super) parts: Vec<PartOfBar>,
}

/// A source in the bar of contributions.
#[derive(Debug, Serialize)]
pub(super) struct PartOfBar {
    pub(super) source: &'static str,
    /// Part of the source in the sum of squares [%].
    pub(super) width: f64,
    /// What the source contributes, or why it does not.
    pub(super) text: String,
}

/// A body.
#[derive(Debug, Serialize)]
pub(super) struct BodyIntervals {
    pub(super) name: String,
    pub(super) problem: Option<String>,
    pub(super) figures: Vec<FigureRow>,
    /// Figures of the body over the cell width.
    pub(super) plots: Vec<Plot>,
}

/// All that is shown of the intervals.
#[derive(Debug, Serialize)]
pub(super) struct ConfidenceSection {
    pub(super) bodies: Vec<BodyIntervals>,
    pub(super) variations: Vec<VariationRow>,
    /// What the variations took, and of how much.
    pub(super) time: String,
}

/// The section of the report; `None` without intervals.
pub(super) fn section(summary: &Summary) -> Option<ConfidenceSection> {
    let confidence = summary.confidence.as_ref()?;
    let body = |(name, body): (&String, &BodyConfidence)| BodyIntervals {
        name: name.clone(),
        problem: body.no_interval_because.clone(),
        figures: body.figures.iter().map(|(key, figure)| figure_row(key, figure)).collect(),
        plots: body
            .figures
            .iter()
            .filter_map(|(key, figure)| mesh_plot(confidence, name, key, figure))
            .collect(),
    };
    Some(ConfidenceSection {
        bodies: confidence.bodies.iter().map(body).collect(),
        variations: confidence.variations.iter().map(variation_row).collect(),
        time: match confidence.budget_s {
            Some(budget) => format!("{} s of {} s", digits(confidence.spent_s), digits(budget)),
            None => format!("{} s", digits(confidence.spent_s)),
        },
    })
}

/// A figure over the cell width; `None` where its meshes were not examined.
fn mesh_plot(all: &Confidence, body: &str, key: &str, figure: &ConfidenceInterval) -> Option<Plot> {
    let convergence = figure.contributions.iter().find_map(|part| part.convergence.as_ref())?;
    let quantity = Quantity::keyed(key)?;
    let on_mesh = |result: &VariationResult| {
        let is_one = result.source == ErrorSource::Mesh && result.status == Status::Examined;
        let value = result.bodies.get(body).filter(|_| is_one)?.get(key)?;
        Some([result.width_m, *value])
    };
    let mut values: Vec<[f64; 2]> = all.variations.iter().filter_map(on_mesh).collect();
    values.push([all.width_m, figure.value]);
    values.sort_by(|a, b| b[0].total_cmp(&a[0]));
    let unit = Unit::of(quantity.column.unit, values.iter().fold(0.0, |most, v| v[1].abs().max(most)));
    let label = match unit.name {
        "" => quantity.figure.symbol.to_owned(),
        name => format!("{} [{name}]", quantity.figure.symbol),
    };
    let plot = MeshPlot {
        name: format!("{body}_meshes_{}", quantity.figure.words.replace(' ', "_")),
        title: format!("{} and cell width", quantity.title()),
        label,
        unit: unit.size,
        values: &values,
        convergence,
    };
    Some(plot.plot())
}

/// The figures of a variation in words; those of several bodies with their names.
fn figures(result: &VariationResult) -> String {
    let of_body = |(name, figures): (&String, &BTreeMap<String, f64>)| {
        let known = figures.iter().filter_map(|(key, value)| Some((named(key)?, *value)));
        let shown = known.map(|(quantity, value)| {
            let text = shown(quantity, Some(value));
            format!("{} {text}", quantity.figure.symbol.replace(' ', ""))
        });
        let text = shown.collect::<Vec<_>>().join(", ");
        if result.bodies.len() > 1 { format!("{name}: {text}") } else { text }
    };
    result.bodies.iter().map(of_body).collect::<Vec<_>>().join("; ")
}

/// The quantity with this key, if it has a symbol.
fn named(key: &str) -> Option<Quantity> {
    Quantity::keyed(key).filter(|quantity| !quantity.figure.symbol.is_empty())
}

/// A mean with its unit.
fn shown(quantity: Quantity, mean: Option<f64>) -> String {
    value(mean, |size| Unit::of(quantity.column.unit, size)).trim_end().to_owned()
}

/// The steady means of each body, a line each.
pub fn mean_lines(summary: &Summary) -> Vec<String> {
    let line = |(name, body): (&String, &BodySummary)| {
        let means =
            Quantity::with_intervals().filter(|q| !q.figure.symbol.is_empty()).filter_map(|quantity| {
                let mean = quantity.mean(&body.steady)?;
                Some(format!("{} {}", quantity.figure.symbol.replace(' ', ""), shown(quantity, Some(mean))))
            });
        format!("{name}: {}", means.collect::<Vec<_>>().join("  "))
    };
    summary.bodies.iter().map(line).collect()
}

fn variation_row(result: &VariationResult) -> VariationRow {
    let what = match &result.because {
        Some(why) if result.what.is_empty() => why.clone(),
        Some(why) => format!("{}: {why}", result.what),
        None => result.what.clone(),
    };
    VariationRow {
        name: result.name.replace('_', " "),
        source: result.source.word(),
        what,
        status: result.status.words(),
        time: result.wall_s.map_or(String::new(), |seconds| format!("{} s", digits(seconds))),
        figures: figures(result),
        verdict: result.verdict.map_or("", |verdict| verdict.name()),
        folder: result.folder.clone(),
    }
}

fn figure_row(key: &str, figure: &ConfidenceInterval) -> FigureRow {
    let [low, high] = figure.interval;
    let quantity = Quantity::keyed(key);
    let unit = Unit::of(quantity.map_or("-", |q| q.column.unit), low.abs().max(high.abs()));
    let number = |v: f64| format!("{} {}", digits(v / unit.size), unit.name).trim_end().to_owned();
    let squares: f64 = figure.contributions.iter().map(|c| c.size().powi(2)).sum();
    let part = |c: &Contribution| PartOfBar {
        source: c.source.word(),
        width: if squares > 0.0 { 100.0 * c.size().powi(2) / squares } else { 0.0 },
        text: part_text(c, &number),
    };
    FigureRow {
        name: quantity.map_or(key, |q| q.figure.words).to_owned(),
        value: number(figure.value),
        interval: format!("{} … {}", digits(low / unit.size), number(high)),
        half_width: figure.relative_half_width.map_or_else(
            || format!("± {}", number(figure.half_width)),
            |relative| format!("± {} %", digits(100.0 * relative)),
        ),
        dominated: figure.dominated_by.map_or("", |source| source.word()).to_owned(),
        parts: figure.contributions.iter().map(part).collect(),
    }
}

fn part_text(contribution: &Contribution, number: &impl Fn(f64) -> String) -> String {
    if contribution.status != Status::Examined {
        return contribution.status.words().to_owned();
    }
    let Contribution { below, above, .. } = *contribution;
    if below == above {
        format!("± {}", number(above))
    } else {
        format!("−{} +{}", number(below), number(above))
    }
}

/// The intervals as lines of text; none without them.
#[must_use]
pub fn confidence_lines(summary: &Summary) -> Vec<String> {
    let Some(section) = section(summary) else { return Vec::new() };
    let mut lines = Vec::new();
    for body in section.bodies {
        lines.push(format!("90 % intervals of {}", body.name));
        lines.extend(body.problem.map(|why| format!("  none: {why}")));
        for row in body.figures {
            let dominated = match row.dominated.as_str() {
                "" => String::new(),
                source => format!(", dominated by {source}"),
            };
            lines.push(format!(
                "  {}: {}, interval {} ({}{dominated})",
                row.name, row.value, row.interval, row.half_width
            ));
            let parts: Vec<String> =
                row.parts.iter().map(|part| format!("{} {}", part.source, part.text)).collect();
            lines.push(format!("    {}", parts.join("; ")));
        }
    }
    for row in section.variations.iter().filter(|row| row.status != Status::NotAskedFor.words()) {
        let VariationRow { name, source, status, what, figures, time, verdict, .. } = row;
        lines.push(if figures.is_empty() {
            format!("  {name} ({source}): {status}; {what}")
        } else {
            format!("  {name} ({source}): {figures}; {time}, {verdict}")
        });
    }
    lines.push(format!("  variations took {}", section.time));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary() -> Summary {
        let part = |source, status, side| Contribution {
            source,
            status,
            below: side,
            above: side,
            ..Contribution::default()
        };
        let figure = ConfidenceInterval {
            value: 50.0,
            interval: [46.0, 54.0],
            half_width: 4.0,
            relative_half_width: Some(0.08),
            dominated_by: Some(ErrorSource::Mesh),
            is_complete: false,
            contributions: vec![
                part(ErrorSource::Mesh, Status::Examined, 4.0),
                part(ErrorSource::Speed, Status::NotExamined, 0.0),
            ],
        };
        let body =
            BodyConfidence { figures: [("drag_N".to_owned(), figure)].into(), ..BodyConfidence::default() };
        let unpaid = VariationResult {
            name: "half_speed".into(),
            source: ErrorSource::Speed,
            because: Some("it would take 9 s".into()),
            ..VariationResult::default()
        };
        let confidence = Confidence {
            variations: vec![unpaid],
            bodies: [("disc".to_owned(), body)].into(),
            ..Confidence::default()
        };
        Summary { confidence: Some(confidence), ..Summary::default() }
    }

    #[test]
    fn intervals_say_what_dominates_and_what_is_missing() {
        let text = confidence_lines(&summary()).join("\n");
        for words in [
            "90 % intervals of disc",
            "drag: 50.0 N, interval 46.0 … 54.0 N (± 8.00 %, dominated by mesh)",
            "mesh ± 4.00 N; speed not examined",
            "half speed (speed): not examined; it would take 9 s",
        ] {
            assert!(text.contains(words), "`{words}` is not in: {text}");
        }
        assert_eq!(confidence_lines(&Summary::default()), Vec::<String>::new());
    }
}
