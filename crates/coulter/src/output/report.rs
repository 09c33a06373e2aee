//! `report.html`: one page with everything in it, made from the histories, the summary and the pictures.

use super::error::{Named, OutputError, read_text, write_whole};
use super::picture::PICTURES;
use super::plot::{BodyHistory, Plot, closure_plot, digits, energy_plot};
use super::record::History;
use super::reference::Reference;
use super::run_record::{Outcome, RunRecord};
use super::scale::Unit;
use super::summary::{BodySummary, Summary};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use std::fs;
use std::path::Path;

const TEMPLATE: &str = include_str!("../../assets/report.html");
const NONE: &str = "–";

/// The case in words, for those who want to see it.
#[derive(Clone, Debug, Default)]
pub(super) struct ReportText {
    /// The case as understood.
    pub(super) resolved: Option<String>,
    /// The case as typed.
    pub(super) typed: Option<String>,
}

/// One line of a table.
#[derive(Debug, Serialize)]
struct Row {
    name: String,
    symbol: &'static str,
    value: String,
    group: String,
    note: String,
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
    rows: Vec<Row>,
    plots: Vec<Figure>,
}

#[derive(Debug, Serialize)]
struct Page<'a> {
    record: &'a RunRecord,
    facts: Vec<[String; 2]>,
    trouble: Option<String>,
    bodies: Vec<BodyPart>,
    pictures: Vec<Figure>,
    energy: Vec<Row>,
    ledgers: Vec<Row>,
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
        bodies.push(body_part(reference, body, plots));
    }
    let ledger_plots = vec![energy_plot(&history.energy), closure_plot(&history.energy)];
    keep_plots(dir, &ledger_plots)?;
    let page = Page {
        facts: facts(record, summary),
        trouble: trouble(&record.statistics.outcome),
        bodies,
        pictures: pictures(dir)?,
        energy: energy_rows(summary),
        ledgers: ledger_rows(summary),
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
    Figure { title: String::new(), caption: plot.caption, svg: Some(plot.svg), image: None }
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

fn facts(record: &RunRecord, summary: &Summary) -> Vec<[String; 2]> {
    let [x, y, z] = record.cells;
    let kind = match (record.plane_strain, record.symmetric) {
        (true, _) => "plane strain; forces of the slab modelled",
        (false, true) => "half of the body modelled (symmetry at y = 0); forces of the whole",
        (false, false) => "whole body modelled",
    };
    let mut facts = vec![
        ["Case".to_owned(), record.case.clone()],
        ["Grid".to_owned(), format!("{x} × {y} × {z} cells, finest {} mm", digits(1e3 * record.finest_cell))],
        ["Model".to_owned(), kind.to_owned()],
    ];
    facts.push(["Version".to_owned(), format!("Coulter {}", summary.version)]);
    facts
}

/// A number with its unit, or a dash.
fn value(number: Option<f64>, unit: impl Fn(f64) -> Unit) -> String {
    number.map_or(NONE.to_owned(), |v| {
        let unit = unit(v.abs());
        format!("{} {}", digits(v / unit.size), unit.name)
    })
}

fn bare(number: Option<f64>) -> String {
    number.map_or(NONE.to_owned(), digits)
}

fn body_part(reference: &Reference, body: &BodySummary, plots: Vec<Plot>) -> BodyPart {
    let (steady, peak) = (&body.steady, &body.peak);
    let force = |f: Option<f64>| f.and_then(|f| reference.force_group(f)).map_or(NONE.to_owned(), digits);
    let torque = |m: Option<f64>| force(m.map(|m| m / reference.length));
    let length = |z: Option<f64>| z.and_then(|z| reference.length_group(z)).map_or(NONE.to_owned(), digits);
    let row = |name: &str, symbol, value: String, group: String, note: String| Row {
        name: name.into(),
        symbol,
        value,
        group,
        note,
    };
    let at = peak.at_m.map_or(String::new(), |u| format!("at u = {} m", digits(u)));
    let percent = steady.drag_noise.map_or(NONE.to_owned(), |n| format!("{} %", digits(100.0 * n)));
    let mut rows = vec![
        row(
            "Drag",
            "F<sub>H</sub>",
            value(steady.drag_N, Unit::force),
            force(steady.drag_N),
            "steady mean".into(),
        ),
        row(
            "Vertical force",
            "F<sub>V</sub>",
            value(steady.vertical_N, Unit::force),
            force(steady.vertical_N),
            "steady mean, up positive".into(),
        ),
        row(
            "Sinkage",
            "z",
            value(steady.sinkage_m, Unit::length),
            length(steady.sinkage_m),
            "steady mean".into(),
        ),
    ];
    if reference.radius.is_some() {
        let note = "1 rolls, 0 slides".to_owned();
        rows.push(row("Turn ratio", "ω r / v", NONE.into(), bare(steady.turn_ratio), note));
        let note = "steady mean; forward positive; group M / (γ t d³)".to_owned();
        rows.push(row(
            "Axle torque",
            "M",
            value(steady.axle_torque_Nm, Unit::torque),
            torque(steady.axle_torque_Nm),
            note,
        ));
    }
    rows.push(row(
        "Drag noise",
        "",
        percent,
        NONE.into(),
        "rms about a moving mean over 0.02 d, over the mean drag".into(),
    ));
    rows.push(row("Peak drag", "", value(peak.drag_N, Unit::force), force(peak.drag_N), at));
    rows.push(row(
        "Peak vertical force",
        "",
        value(peak.vertical_N, Unit::force),
        force(peak.vertical_N),
        String::new(),
    ));
    rows.push(row(
        "Deepest sinkage",
        "",
        value(peak.sinkage_m, Unit::length),
        length(peak.sinkage_m),
        String::new(),
    ));
    BodyPart {
        name: reference.name.clone(),
        kind: reference.kind.clone(),
        window: window_text(body),
        scales: scales_text(reference),
        rows,
        plots: plots.into_iter().map(figure).collect(),
    }
}

fn window_text(body: &BodySummary) -> String {
    let steady = &body.steady;
    match (steady.from_m.zip(steady.to_m), steady.from_s.zip(steady.to_s)) {
        (Some((a, b)), _) if a != b => format!("u = {} … {} m", digits(a), digits(b)),
        (_, Some((a, b))) => format!("t = {} … {} s", digits(a), digits(b)),
        _ => NONE.to_owned(),
    }
}

fn scales_text(reference: &Reference) -> String {
    let (d, t) = (digits(1e3 * reference.length), digits(1e3 * reference.width));
    let lengths = if reference.kind == "disc" {
        format!("d = {d} mm (diameter), t = {t} mm (thickness)")
    } else {
        format!("d = {d} mm (height of the {}), t = {t} mm (its width)", reference.kind)
    };
    match reference.force() {
        Some(force) => format!("{lengths}, γ t d² = {}", value(Some(force), Unit::force)),
        None => format!("{lengths}; the soil is weightless, so forces have no group"),
    }
}

fn energy_rows(summary: &Summary) -> Vec<Row> {
    let energy = &summary.energy;
    let share = |e: Option<f64>| {
        let ratio = e.zip(energy.external_J).filter(|(_, all)| *all != 0.0).map(|(e, all)| e / all);
        ratio.map_or(NONE.to_owned(), |r| format!("{} %", digits(100.0 * r)))
    };
    let entries = [
        ("External work", energy.external_J, "loads, drives and gravity"),
        ("Plastic dissipation", energy.plastic_J, ""),
        ("Contact", energy.friction_J, "friction, and what the contact method takes"),
        ("Kinetic energy", energy.kinetic_J, "soil and bodies"),
        ("Elastic energy", energy.elastic_J, "less that at the start"),
        ("Bulk viscosity", energy.viscous_J, "numerical"),
        ("Hourglass viscosity", energy.hourglass_J, "numerical"),
        ("Remap loss", energy.remap_loss_J, "numerical"),
    ];
    let row = |(name, e, note): (&str, Option<f64>, &str)| Row {
        name: name.into(),
        symbol: "",
        value: value(e, Unit::energy),
        group: share(e),
        note: note.into(),
    };
    let mut rows: Vec<Row> = entries.into_iter().map(row).collect();
    let closure = energy.closure.map_or(NONE.to_owned(), |c| format!("{} %", digits(100.0 * c)));
    let note = "what no entry explains".to_owned();
    rows.push(Row { name: "Unexplained".into(), symbol: "", value: NONE.into(), group: closure, note });
    rows
}

fn ledger_rows(summary: &Summary) -> Vec<Row> {
    let row = |name: &str, value: String, note: &str| Row {
        name: name.into(),
        symbol: "",
        value,
        group: String::new(),
        note: note.into(),
    };
    let litres = |v: f64| {
        if v.abs() < 1e-3 { format!("{} cm³", digits(1e6 * v)) } else { format!("{} dm³", digits(1e3 * v)) }
    };
    let surface = &summary.surface;
    let change =
        summary.soil.volume_ratio.map_or(NONE.to_owned(), |v| format!("{v:.6}").replace('-', "\u{2212}"));
    vec![
        row("Soil volume, end over start", change, "dilation and elastic compression included"),
        row("Soil inside the bodies", litres(summary.soil.leaked_m3), "leakage at the end; 0 is right"),
        row(
            "Depth of the rut",
            format!("{} mm", digits(1e3 * surface.rut_depth_m)),
            "deepest point of the free surface",
        ),
        row(
            "Height of the berm",
            format!("{} mm", digits(1e3 * surface.berm_height_m)),
            "highest point of the free surface",
        ),
        row("Volume of the rut", litres(surface.rut_volume_m3), "below the undisturbed surface"),
        row("Volume of the berms", litres(surface.berm_volume_m3), "above it"),
    ]
}

fn statistics(record: &RunRecord, summary: &Summary) -> Vec<[String; 2]> {
    let rate = summary
        .cell_steps_per_second()
        .map_or(NONE.to_owned(), |r| format!("{} million cell-steps/s", digits(r / 1e6)));
    let threads = record.statistics.threads;
    [
        ("Cells", format!("{} ({} with soil)", grouped(summary.cells), grouped(summary.filled_cells))),
        ("Steps", grouped(summary.steps)),
        ("Simulated time", format!("{} s", digits(record.duration))),
        ("Wall time", duration_text(summary.wall_s)),
        ("Speed", rate),
        ("Threads", threads.to_string()),
        ("Version", summary.version.clone()),
    ]
    .map(|(name, text)| [name.to_owned(), text])
    .to_vec()
}

/// A whole number with thin spaces between thousands.
fn grouped(number: u64) -> String {
    let plain = number.to_string();
    let mut text = String::new();
    for (n, digit) in plain.chars().enumerate() {
        if n > 0 && (plain.len() - n).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

fn duration_text(seconds: f64) -> String {
    let whole = seconds.max(0.0) as u64;
    match whole {
        0..60 => format!("{} s", digits(seconds)),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole / 60 % 60),
    }
}
