//! `report.html`: one self-contained page, made from the histories, the summary and the pictures.

use super::assembly::{self, ForceRow};
use super::body_rows::body_rows;
use super::cite::{Citation, citation};
use super::confidence::{self, ConfidenceSection};
use super::drawing::is_drawing;
use super::headline::{Tile, sentences, tiles};
use super::rows::{
    CheckRow, TableRow, balance_rows, check_rows, energy_rows, facts, scales_text, statistics, window_text,
};
use super::space::{Space, space};
use super::summary::{BodySummary, Summary};
use crate::page::{lowered, render_page};
use crate::pictures::{PICTURES, dark_variant};
use crate::plots::{BodyHistory, Plot, Units, closure_plot, energy_plot, rim_plots};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use results::files::{Inside, Named, OutputError, PLOTS, file_safe, read_text, write_whole};
use results::folder::{Outcome, RunRecord};
use results::history::History;
use results::history::reference::Reference;
use results::history::rim::RimLine;
use results::overlay::Overlay;
use results::trust::Verdict;
use serde::Serialize;
use std::path::Path;

const TEMPLATE: &str = include_str!("../../assets/report.html");
/// Largest picture that is put into the page [bytes].
const MOST_BYTES: u64 = 256 << 20;
/// The script of the soil surface in three dimensions.
const VIEW: &str = include_str!("../../assets/view.js");

/// The text of the case.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReportText {
    /// The case as understood.
    pub(crate) resolved: Option<String>,
    /// The case as typed.
    pub(crate) typed: Option<String>,
    /// What this report alone shows.
    pub(crate) wishes: ReportWishes,
}

/// What a report shows that is built anew; nothing of it is kept in the folder of the results.
#[derive(Clone, Debug, Default)]
pub struct ReportWishes {
    /// Curves of measurements and other runs that are overlaid on the plots.
    pub laid_over: Vec<Overlay>,
    /// Remarks on these curves.
    pub remarks: Vec<String>,
    /// The units of the plots.
    pub units: Units,
}

#[derive(Debug, Default, Serialize)]
struct Figure {
    title: String,
    caption: String,
    svg: Option<String>,
    image: Option<String>,
    /// The image for dark screens.
    dark_image: Option<String>,
}

#[derive(Debug, Serialize)]
struct BodySection {
    name: String,
    kind: String,
    window: String,
    scales: String,
    tiles: Vec<Tile>,
    /// The key numbers of this kind of motion.
    rows: Vec<TableRow>,
    /// Further numbers.
    further: Vec<TableRow>,
    /// Whether any of the rows has an interval.
    has_intervals: bool,
    plots: Vec<Figure>,
}

#[derive(Debug, Serialize)]
struct Page<'a> {
    record: &'a RunRecord,
    facts: Vec<[String; 2]>,
    sentences: Vec<String>,
    problem: Option<String>,
    verdict: Verdict,
    checks: Vec<CheckRow>,
    bodies: Vec<BodySection>,
    all_bodies: Vec<[String; 2]>,
    parts: Vec<ForceRow>,
    joints: Vec<ForceRow>,
    confidence: Option<ConfidenceSection>,
    pictures: Vec<Figure>,
    energy: Vec<TableRow>,
    balances: Vec<TableRow>,
    balance_plots: Vec<Figure>,
    statistics: Vec<[String; 2]>,
    space: Space,
    citation: Citation,
    resolved: Option<String>,
    typed: Option<String>,
}

/// Writes the page, and its plots as separate files; `rims` are the rims of the bodies, averaged over their
/// steady windows.
pub(crate) fn write_report(
    dir: &Path,
    record: &RunRecord,
    summary: &Summary,
    (history, rims): (&History, &[Vec<RimLine>]),
    text: &ReportText,
) -> Result<(), OutputError> {
    let (empty, units) = (BodySummary::default(), text.wishes.units);
    let mut bodies = Vec::new();
    for (n, (reference, samples)) in record.bodies.iter().zip(&history.bodies).enumerate() {
        if !reference.has_surface() {
            continue;
        }
        let body = summary.bodies.get(&reference.name).unwrap_or(&empty);
        let overlays = [record.overlays.as_slice(), text.wishes.laid_over.as_slice()].concat();
        let view = BodyHistory { reference, samples, steady: &body.steady, overlays: &overlays, units };
        let mut plots = view.plots();
        plots.extend(rim_plots(reference, rims.get(n).map_or(&[], Vec::as_slice)));
        write_plots(dir, &plots)?;
        let rut = summary.ruts.get(&reference.name);
        let tiles = tiles(record, summary, history, &reference.name);
        let confidence = summary.confidence.as_ref().and_then(|all| all.bodies.get(&reference.name));
        let [rows, further] = body_rows(reference, (body, confidence), rut);
        let has_intervals = confidence.is_some_and(|body| !body.figures.is_empty());
        let section = body_section(record, reference, body, plots);
        bodies.push(BodySection { tiles, rows, further, has_intervals, ..section });
    }
    let intervals = confidence::section(summary);
    for body in intervals.iter().flat_map(|section| &section.bodies) {
        write_plots(dir, &body.plots)?;
    }
    let balance_plots = vec![energy_plot(&history.energy), closure_plot(&record.setting, &history.energy)];
    write_plots(dir, &balance_plots)?;
    let laid_over = text.wishes.remarks.iter().map(|remark| ["laid over".to_owned(), remark.clone()]);
    let page = Page {
        facts: facts(record, summary).into_iter().chain(laid_over).collect(),
        sentences: sentences(record, summary, history),
        space: space(dir, record, history),
        citation: citation(record, summary),
        problem: problem(&record.statistics.outcome),
        verdict: summary.trust.verdict,
        checks: check_rows(&summary.trust),
        bodies,
        all_bodies: assembly::all_bodies(summary),
        parts: assembly::part_rows(record, summary),
        joints: assembly::joint_rows(record, summary),
        confidence: intervals,
        pictures: pictures(dir)?,
        energy: energy_rows(record, summary),
        balances: balance_rows(record, summary),
        balance_plots: balance_plots.into_iter().map(figure).collect(),
        statistics: statistics(record, summary),
        resolved: text.resolved.clone(),
        typed: text.typed.clone(),
        record,
    };
    let file = Inside::of(dir, "report.html");
    let html = render(&page).map_err(|e| OutputError::content(&file.path(), e))?;
    write_whole(&file, html.as_bytes())
}

fn render(page: &Page<'_>) -> Result<String, minijinja::Error> {
    render_page(TEMPLATE, page, &[("view.js", VIEW)])
}

fn write_plots(dir: &Path, plots: &[Plot]) -> Result<(), OutputError> {
    for plot in plots {
        let name = file_safe(&plot.name);
        write_whole(&Inside::of(dir, PLOTS).join(format!("{name}.svg")), plot.svg.as_bytes())?;
    }
    Ok(())
}

fn figure(plot: Plot) -> Figure {
    Figure {
        title: String::new(),
        caption: lowered(&plot.caption),
        svg: Some(plot.svg),
        image: None,
        dark_image: None,
    }
}

/// The pictures of the run, in the order of the report.
fn pictures(dir: &Path) -> Result<Vec<Figure>, OutputError> {
    let mut figures = Vec::new();
    for picture in &PICTURES {
        let file = Inside::of(dir, "pictures").join(picture.file);
        if !file.exists() {
            continue;
        }
        let mut figure =
            Figure { title: picture.title.into(), caption: picture.text.into(), ..Figure::default() };
        if picture.file.ends_with(".svg") {
            let svg = read_text(&file)?;
            if !is_drawing(&svg) {
                return Err(OutputError::content(&file.path(), "it is not the drawing of a run; remove it"));
            }
            figure.svg = Some(svg);
        } else {
            figure.image = Some(embedded(&file)?);
            let dark = dark_variant(&file);
            figure.dark_image = if dark.exists() { Some(embedded(&dark)?) } else { None };
        }
        figures.push(figure);
    }
    Ok(figures)
}

/// A picture as part of the page.
fn embedded(file: &Inside) -> Result<String, OutputError> {
    let bytes = file.read(MOST_BYTES).named("read", &file.path())?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(bytes)))
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
    BodySection {
        has_intervals: false,
        name: reference.name.clone(),
        kind: reference.kind.clone(),
        window: window_text(body),
        scales: scales_text(record, reference),
        tiles: Vec::new(),
        rows: Vec::new(),
        further: Vec::new(),
        plots: plots.into_iter().map(figure).collect(),
    }
}
