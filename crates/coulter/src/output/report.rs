//! `report.html`: one page with everything in it, made from the histories, the summary and the pictures.

use super::energy_plot::{closure_plot, energy_plot};
use super::error::{Named, OutputError, read_text, write_whole};
use super::picture::PICTURES;
use super::plot::{BodyHistory, Plot};
use super::report_rows::{
    CheckRow, TableRow, body_rows, check_rows, energy_rows, facts, ledger_rows, scales_text, statistics,
    window_text,
};
use super::run_record::{Outcome, RunRecord};
use super::summary::{BodySummary, Summary};
use crate::history::History;
use crate::history::reference::Reference;
use crate::trust::Verdict;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use std::fs;
use std::path::Path;

const TEMPLATE: &str = include_str!("../../assets/report.html");

/// The case in words, for those who want to see it.
#[derive(Clone, Debug, Default)]
pub(super) struct ReportText {
    /// The case as understood.
    pub(super) resolved: Option<String>,
    /// The case as typed.
    pub(super) typed: Option<String>,
}

#[derive(Debug, Serialize)]
struct Figure {
    title: String,
    caption: String,
    svg: Option<String>,
    image: Option<String>,
}

#[derive(Debug, Serialize)]
struct BodyPart {
    name: String,
    kind: String,
    window: String,
    scales: String,
    rows: Vec<TableRow>,
    plots: Vec<Figure>,
}

#[derive(Debug, Serialize)]
struct Page<'a> {
    record: &'a RunRecord,
    facts: Vec<[String; 2]>,
    trouble: Option<String>,
    verdict: Verdict,
    checks: Vec<CheckRow>,
    bodies: Vec<BodyPart>,
    pictures: Vec<Figure>,
    energy: Vec<TableRow>,
    ledgers: Vec<TableRow>,
    ledger_plots: Vec<Figure>,
    statistics: Vec<[String; 2]>,
    resolved: Option<String>,
    typed: Option<String>,
}

/// Writes the page, and its plots as files of their own.
pub(super) fn write_report(
    dir: &Path,
    record: &RunRecord,
    summary: &Summary,
    history: &History,
    text: &ReportText,
) -> Result<(), OutputError> {
    let empty = BodySummary::default();
    let mut bodies = Vec::new();
    for (reference, samples) in record.bodies.iter().zip(&history.bodies) {
        let body = summary.bodies.get(&reference.name).unwrap_or(&empty);
        let view = BodyHistory { reference, samples, steady: &body.steady, overlays: &record.overlays };
        let plots = view.plots();
        keep_plots(dir, &plots)?;
        bodies.push(body_part(record, reference, body, plots));
    }
    let ledger_plots = vec![energy_plot(&history.energy), closure_plot(&history.energy)];
    keep_plots(dir, &ledger_plots)?;
    let page = Page {
        facts: facts(record, summary),
        trouble: trouble(&record.statistics.outcome),
        verdict: summary.trust.verdict,
        checks: check_rows(&summary.trust),
        bodies,
        pictures: pictures(dir)?,
        energy: energy_rows(summary),
        ledgers: ledger_rows(record, summary),
        ledger_plots: ledger_plots.into_iter().map(figure).collect(),
        statistics: statistics(record, summary),
        resolved: text.resolved.clone(),
        typed: text.typed.clone(),
        record,
    };
    let path = dir.join("report.html");
    let html = render(&page).map_err(|e| OutputError::content(&path, e))?;
    write_whole(&path, html.as_bytes())
}

fn render(page: &Page<'_>) -> Result<String, minijinja::Error> {
    let mut environment = minijinja::Environment::new();
    // The name ends in .html, so that everything put in is escaped unless it is marked safe.
    environment.add_template("report.html", TEMPLATE)?;
    environment.get_template("report.html")?.render(minijinja::value::Serde(page))
}

fn keep_plots(dir: &Path, plots: &[Plot]) -> Result<(), OutputError> {
    for plot in plots {
        let name = super::csv::file_safe(&plot.name);
        write_whole(&dir.join("plots").join(format!("{name}.svg")), plot.svg.as_bytes())?;
    }
    Ok(())
}

fn figure(plot: Plot) -> Figure {
    Figure { title: String::new(), caption: lowered(&plot.caption), svg: Some(plot.svg), image: None }
}

/// Text as HTML, with subscripts: the letter behind `_` is lowered.
fn lowered(text: &str) -> String {
    let mut html = String::new();
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '_' => html.extend(letters.next().map(|low| format!("<sub>{low}</sub>"))),
            '<' => html.push_str("&lt;"),
            '&' => html.push_str("&amp;"),
            _ => html.push(letter),
        }
    }
    html
}

/// The pictures that the run has left, in the order of the report.
fn pictures(dir: &Path) -> Result<Vec<Figure>, OutputError> {
    let mut figures = Vec::new();
    for picture in &PICTURES {
        let path = dir.join("pictures").join(picture.file);
        if !path.is_file() {
            continue;
        }
        let (svg, image) = if picture.file.ends_with(".svg") {
            (Some(read_text(&path)?), None)
        } else {
            let bytes = fs::read(&path).named("read", &path)?;
            (None, Some(format!("data:image/png;base64,{}", STANDARD.encode(bytes))))
        };
        figures.push(Figure { title: picture.title.into(), caption: picture.text.into(), svg, image });
    }
    Ok(figures)
}

fn trouble(outcome: &Outcome) -> Option<String> {
    match outcome {
        Outcome::Finished => None,
        Outcome::Running => Some("The run has not come to its end.".to_owned()),
        Outcome::Interrupted => {
            Some("The run was stopped before its end; it can go on with --resume.".to_owned())
        }
        Outcome::BrokeDown(message) => Some(format!("The run broke down: {message}")),
    }
}

fn body_part(record: &RunRecord, reference: &Reference, body: &BodySummary, plots: Vec<Plot>) -> BodyPart {
    BodyPart {
        name: reference.name.clone(),
        kind: reference.kind.clone(),
        window: window_text(body),
        scales: scales_text(record, reference),
        rows: body_rows(reference, body),
        plots: plots.into_iter().map(figure).collect(),
    }
}
