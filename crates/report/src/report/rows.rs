//! The tables of a report.

use super::summary::{BodySummary, Summary};
use case::resolved::PLANE_STRAIN_WIDTH;
use input::readable::{Unit, digits};
use results::folder::RunRecord;
use results::history::quantities::Quantity;
use results::history::reference::Reference;
use results::trust::{Check, Trust, Verdict};
use serde::Serialize;

pub(super) const NONE: &str = "–";

/// One line of a table.
#[derive(Debug, Default, Serialize)]
pub(super) struct TableRow {
    pub(super) name: String,
    pub(super) symbol: String,
    pub(super) value: String,
    /// Interval of the value; empty for none.
    pub(super) interval: String,
    pub(super) group: String,
    pub(super) note: String,
}

/// One check of the run.
#[derive(Debug, Serialize)]
pub(super) struct CheckRow {
    pub(super) verdict: &'static str,
    pub(super) name: String,
    pub(super) body: String,
    pub(super) value: String,
    pub(super) good: String,
    pub(super) doubtful: String,
    pub(super) advice: String,
}

/// The checks of a run, first those that are not good.
pub(super) fn check_rows(trust: &Trust) -> Vec<CheckRow> {
    let good = trust.checks.iter().filter(|c| c.verdict == Verdict::Good);
    let row = |check: &Check| {
        let number = |v: Option<f64>, none: &str| {
            v.map_or(none.to_owned(), |v| format!("{} {}", digits(v), check.unit).trim_end().to_owned())
        };
        CheckRow {
            verdict: check.verdict.name(),
            name: check.name.clone(),
            body: check.body.clone().unwrap_or_default(),
            value: number(check.value, "not available"),
            good: number(check.limits[0], NONE),
            doubtful: number(check.limits[1], NONE),
            advice: check.advice.clone(),
        }
    };
    trust.concerns().into_iter().chain(good).map(row).collect()
}

pub(super) fn facts(record: &RunRecord, summary: &Summary) -> Vec<[String; 2]> {
    let [x, y, z] = record.cells;
    let kind = match (record.plane_strain, record.symmetric, record.symmetric_x) {
        _ if record.bodies.is_empty() => "no body",
        // A folder of a version that reported the forces on the slab.
        (true, ..)
            if record.bodies.iter().any(|body| body.has_surface() && body.width != PLANE_STRAIN_WIDTH) =>
        {
            "plane strain; forces on the modelled slab"
        }
        (true, _, false) => "plane strain; forces per metre of width",
        (true, _, true) => {
            "plane strain, half modelled (symmetry at x = 0); forces on the whole body per metre of width"
        }
        (false, true, false) => "half of the body modelled (symmetry at y = 0); forces on the whole body",
        (false, false, true) => "half of the body modelled (symmetry at x = 0); forces on the whole body",
        (false, true, true) => {
            "a quarter of the body modelled (symmetry at x = 0 and y = 0); forces on the whole body"
        }
        (false, false, false) => "whole body modelled",
    };
    let mut facts = record.facts.clone();
    facts.push([
        "Grid".to_owned(),
        format!("{x} × {y} × {z} cells, finest {} mm; {kind}", digits(1e3 * record.finest_cell)),
    ]);
    facts.push(["Case".to_owned(), format!("{}, computed with Coulter {}", record.case, summary.version)]);
    facts
}

/// A number with its unit, or a dash.
pub(super) fn value(number: Option<f64>, unit: impl Fn(f64) -> Unit) -> String {
    number.map_or(NONE.to_owned(), |v| {
        let unit = unit(v.abs());
        format!("{} {}", digits(v / unit.size), unit.name)
    })
}

/// The symbol of a quantity in HTML.
pub(super) fn symbol(quantity: Quantity) -> String {
    match quantity.figure.symbol.split_once('_') {
        Some((symbol, index)) => format!("{symbol}<sub>{index}</sub>"),
        None => quantity.figure.symbol.to_owned(),
    }
}

pub(super) fn bare(number: Option<f64>) -> String {
    number.map_or(NONE.to_owned(), digits)
}

pub(super) fn window_text(body: &BodySummary) -> String {
    let steady = &body.steady;
    match (steady.from_m.zip(steady.to_m), steady.from_s.zip(steady.to_s)) {
        (Some((a, b)), _) if a != b => format!("u = {} … {} m", digits(a), digits(b)),
        (_, Some((a, b))) => format!("t = {} … {} s", digits(a), digits(b)),
        _ => NONE.to_owned(),
    }
}

pub(super) fn scales_text(record: &RunRecord, reference: &Reference) -> String {
    let (d, t) = (digits(1e3 * reference.length), digits(1e3 * reference.width));
    let (length, width) =
        if reference.kind == "disc" { ("diameter", "thickness") } else { ("height", "width") };
    let width = if record.plane_strain { "width in plane strain" } else { width };
    let lengths = format!("d = {d} mm ({length}), t = {t} mm ({width})");
    match reference.force() {
        Some(force) => format!("{lengths}, γ t d² = {}", value(Some(force), Unit::force)),
        None => format!("{lengths}; forces have no dimensionless form because the soil is weightless"),
    }
}

pub(super) fn energy_rows(record: &RunRecord, summary: &Summary) -> Vec<TableRow> {
    let energy = &summary.energy;
    // Of no energy there are no parts.
    let all = energy.external.filter(|all| all.abs() > record.setting.energy_floor);
    let per_cent = |e: Option<f64>| {
        let ratio = e.zip(all).map(|(e, all)| e / all);
        ratio.map_or(NONE.to_owned(), |r| format!("{} %", digits(100.0 * r)))
    };
    let entries = [
        ("External work", energy.external, "loads, prescribed motions and gravity"),
        ("Plastic", energy.plastic, ""),
        ("Friction", energy.friction, "on the bodies"),
        ("Contact method", energy.contact, "numerical: springs, damping, corrections"),
        ("Kinetic energy", energy.kinetic, "soil and bodies"),
        ("Elastic energy", energy.elastic, "less that at the start"),
        ("Bulk viscosity", energy.viscous, "numerical"),
        ("Hourglass", energy.hourglass, "numerical"),
        ("Remap loss", energy.remap_loss, "numerical"),
    ];
    let seepage = energy.seepage.filter(|seepage| *seepage != 0.0);
    let seepage = seepage.map(|seepage| ("Seepage", Some(seepage), "pore water that flows through the soil"));
    let row = |(name, e, note): (&str, Option<f64>, &str)| TableRow {
        name: name.into(),
        value: value(e, Unit::energy),
        group: per_cent(e),
        note: note.into(),
        ..TableRow::default()
    };
    let mut rows: Vec<TableRow> = entries.into_iter().chain(seepage).map(row).collect();
    let closure = energy.closure.map_or(NONE.to_owned(), |c| format!("{} %", digits(100.0 * c)));
    let note = "not explained by any entry".to_owned();
    let explained: Option<f64> = entries[1..].iter().map(|(_, e, _)| *e).sum();
    let rest = value(energy.external.zip(explained).map(|(all, explained)| all - explained), Unit::energy);
    let name = "Unexplained".into();
    rows.push(TableRow { name, value: rest, group: closure, note, ..TableRow::default() });
    rows
}

pub(super) fn balance_rows(record: &RunRecord, summary: &Summary) -> Vec<TableRow> {
    let row = |name: &str, value: String, note: &str| TableRow {
        name: name.into(),
        value,
        note: note.into(),
        ..TableRow::default()
    };
    let litres = |v: f64| {
        if v.abs() < 1e-3 { format!("{} cm³", digits(1e6 * v)) } else { format!("{} dm³", digits(1e3 * v)) }
    };
    let surface = &summary.surface;
    let change =
        summary.soil.volume_ratio.map_or(NONE.to_owned(), |v| format!("{v:.6}").replace('-', "\u{2212}"));
    let mut rows = vec![
        row("Soil volume ratio", change, "end over start; includes dilation and elastic compression"),
        row("Soil inside the bodies", litres(summary.soil.leaked_m3), "leakage at the end; ideally 0"),
    ];
    let height = format!("{} mm", digits(1e3 * surface.berm_height_m));
    if record.heaped {
        rows.push(row("Height of the soil", height, "highest point above the floor"));
        rows.push(row("Volume under the surface", litres(surface.berm_volume_m3), "by the height map"));
        return rows;
    }
    let depth = format!("{} mm", digits(1e3 * surface.rut_depth_m));
    rows.extend([
        row("Depth of the rut", depth, "deepest point of the free surface"),
        row("Height of the berm", height, "highest point of the free surface"),
        row("Volume of the rut", litres(surface.rut_volume_m3), "below the undisturbed surface"),
        row("Volume of the berms", litres(surface.berm_volume_m3), "above it"),
        row("Compaction", litres(surface.compaction_m3), "volume that the soil has lost by becoming denser"),
        row("Disturbed soil", litres(surface.disturbed_m3), "equivalent plastic strain above 0.1"),
    ]);
    rows
}

pub(super) fn statistics(record: &RunRecord, summary: &Summary) -> Vec<[String; 2]> {
    let rate = summary
        .cell_steps_per_second()
        .map_or(NONE.to_owned(), |r| format!("{} million cell-steps/s", digits(r / 1e6)));
    let threads = record.statistics.threads;
    let stages = record.statistics.stages.iter();
    let stages =
        stages.map(|stage| format!("{} {} to {} s", stage.name, digits(stage.from_s), digits(stage.to_s)));
    let stages: Vec<String> = stages.collect();
    let simulated = match record.statistics.stages.last() {
        Some(last) => last.to_s,
        None => record.duration,
    };
    [
        ("Cells", format!("{} ({} with soil)", grouped(summary.cells), grouped(summary.filled_cells))),
        ("Steps", grouped(summary.steps)),
        ("Simulated time", format!("{} s", digits(simulated))),
        ("Stages", stages.join(", ")),
        ("Filtered forces", format!("filtered.csv, cut-off {} Hz", digits(record.filter_cutoff))),
        ("Wall time", duration_text(summary.wall_s)),
        ("Speed", rate),
        ("Threads", threads.to_string()),
        ("Version", summary.version.clone()),
    ]
    .into_iter()
    .filter(|(_, text)| !text.is_empty())
    .map(|(name, text)| [name.to_owned(), text])
    .collect()
}

/// A whole number with thin spaces between thousands.
pub(super) fn grouped(number: u64) -> String {
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
