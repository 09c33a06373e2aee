//! `report.html`: one self-contained page, made from the histories, the summary and the pictures.

use super::assembly::{self, ForceRow};
use super::meshes::{self, IntervalRow, MeshRow};
use super::rows::{
    CheckRow, TableRow, balance_rows, body_rows, check_rows, energy_rows, facts, scales_text, statistics,
    window_text,
};
use super::summary::{BodySummary, Summary};
use crate::history::History;
use crate::history::reference::Reference;
use crate::history::rim::RimLine;
use crate::output::files::{Named, OutputError, file_safe, read_text, write_whole};
use crate::output::folder::{Outcome, RunRecord};
use crate::output::pictures::PICTURES;
use crate::output::plots::{BodyHistory, Plot, closure_plot, energy_plot, rim_plots};
use crate::trust::Verdict;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use std::fs;
use std::path::Path;

const TEMPLATE: &str = include_str!("../../../assets/report.html");

/// The text of the case.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReportText {
    /// The case as understood.
    pub(crate) resolved: Option<String>,
    /// The case as typed.
    pub(crate) typed: Option<String>,
}

#[derive(Debug, Serialize)]
struct Figure {
    title: String,
    caption: String,
    svg: Option<String>,
    image: Option<String>,
}

#[derive(Debug, Serialize)]
struct BodySection {
    name: String,
    kind: String,
    window: String,
    scales: String,
    rows: Vec<TableRow>,
    /// Whether any of the rows has an interval.
    has_intervals: bool,
    plots: Vec<Figure>,
}

/// A body of a mesh study.
#[derive(Debug, Serialize)]
struct MeshSection {
    name: String,
    problem: Option<String>,
    meshes: Vec<MeshRow>,
    intervals: Vec<IntervalRow>,
    plots: Vec<Figure>,
}

#[derive(Debug, Serialize)]
struct Page<'a> {
    record: &'a RunRecord,
    facts: Vec<[String; 2]>,
    problem: Option<String>,
    verdict: Verdict,
    checks: Vec<CheckRow>,
    bodies: Vec<BodySection>,
    all_bodies: Vec<[String; 2]>,
    parts: Vec<ForceRow>,
    joints: Vec<ForceRow>,
    meshes: Vec<MeshSection>,
    pictures: Vec<Figure>,
    energy: Vec<TableRow>,
    balances: Vec<TableRow>,
    balance_plots: Vec<Figure>,
    statistics: Vec<[String; 2]>,
    resolved: Option<String>,
    typed: Option<String>,
}

/// Writes the page, and its plots as separate files; `rims` are the rims of the bodies, averaged over their steady windows.
pub(crate) fn write_report(
    dir: &Path,
    record: &RunRecord,
    summary: &Summary,
    (history, rims): (&History, &[Vec<RimLine>]),
    text: &ReportText,
) -> Result<(), OutputError> {
    let empty = BodySummary::default();
    let mut bodies = Vec::new();
    for (n, (reference, samples)) in record.bodies.iter().zip(&history.bodies).enumerate() {
        if !reference.has_surface() {
            continue;
        }
        let body = summary.bodies.get(&reference.name).unwrap_or(&empty);
        let view = BodyHistory { reference, samples, steady: &body.steady, overlays: &record.overlays };
        let mut plots = view.plots();
        plots.extend(rim_plots(reference, rims.get(n).map_or(&[], Vec::as_slice)));
        write_plots(dir, &plots)?;
        bodies.push(body_section(record, reference, body, plots));
    }
    let balance_plots = vec![energy_plot(&history.energy), closure_plot(&history.energy)];
    write_plots(dir, &balance_plots)?;
    let page = Page {
        facts: facts(record, summary),
        problem: problem(&record.statistics.outcome),
        verdict: summary.trust.verdict,
        checks: check_rows(&summary.trust),
        bodies,
        all_bodies: assembly::all_bodies(summary),
        parts: assembly::part_rows(record, summary),
        joints: assembly::joint_rows(record, summary),
        meshes: mesh_sections(dir, summary)?,
        pictures: pictures(dir)?,
        energy: energy_rows(summary),
        balances: balance_rows(record, summary),
        balance_plots: balance_plots.into_iter().map(figure).collect(),
        statistics: statistics(record, summary),
        resolved: text.resolved.clone(),
        typed: text.typed.clone(),
        record,
    };
    let path = dir.join("report.html");
    let html = render(&page).map_err(|e| OutputError::content(&path, e))?;
    write_whole(&path, html.as_bytes())
}

/// The bodies of the mesh study, if there is one.
fn mesh_sections(dir: &Path, summary: &Summary) -> Result<Vec<MeshSection>, OutputError> {
    let mut sections = Vec::new();
    for body in summary.mesh_study.iter().flat_map(meshes::body_rows) {
        write_plots(dir, &body.plots)?;
        sections.push(MeshSection {
            name: body.name,
            problem: body.problem,
            meshes: body.meshes,
            intervals: body.intervals,
            plots: body.plots.into_iter().map(figure).collect(),
        });
    }
    Ok(sections)
}

fn render(page: &Page<'_>) -> Result<String, minijinja::Error> {
    let mut environment = minijinja::Environment::new();
    // Because the name ends in .html, everything inserted is escaped unless it is marked safe.
    environment.add_template("report.html", TEMPLATE)?;
    environment.get_template("report.html")?.render(minijinja::value::Serde(page))
}

fn write_plots(dir: &Path, plots: &[Plot]) -> Result<(), OutputError> {
    for plot in plots {
        let name = file_safe(&plot.name);
        write_whole(&dir.join("plots").join(format!("{name}.svg")), plot.svg.as_bytes())?;
    }
    Ok(())
}

fn figure(plot: Plot) -> Figure {
    Figure { title: String::new(), caption: lowered(&plot.caption), svg: Some(plot.svg), image: None }
}

/// Text as HTML, with subscripts: the letter after `_` is lowered.
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

/// The pictures of the run, in the order of the report.
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

fn problem(outcome: &Outcome) -> Option<String> {
    match outcome {
        Outcome::Finished => None,
        Outcome::Running => Some("The run has not reached its end.".to_owned()),
        Outcome::Interrupted => Some("The run was stopped before its end; --resume continues it.".to_owned()),
        Outcome::BrokeDown(message) => Some(format!("The run broke down: {message}")),
    }
}

fn body_section(
    record: &RunRecord,
    reference: &Reference,
    body: &BodySummary,
    plots: Vec<Plot>,
) -> BodySection {
    let rows = body_rows(reference, body);
    BodySection {
        has_intervals: rows.iter().any(|row| !row.interval.is_empty()),
        name: reference.name.clone(),
        kind: reference.kind.clone(),
        window: window_text(body),
        scales: scales_text(record, reference),
        rows,
        plots: plots.into_iter().map(figure).collect(),
    }
}
