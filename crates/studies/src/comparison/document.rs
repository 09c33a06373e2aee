//! A comparison as text, CSV, JSON and a page.

use super::compare::{Compared, Comparison};
use super::item::{Item, ItemKind};
use super::steady::SteadyMean;
use crate::measured::Quantity;
use crate::sheet::{Sheet, SheetFigure, SheetSection, SheetTable, short};
use crate::sources::LeftOut;
use coulter::formats;
use coulter::output::plots::{Chart, Curve, Level, Stroke};
use coulter::printed::text_cell;
use serde_json::{Value, json};

const HEAD: [&str; 12] = [
    "quantity",
    "item",
    "points",
    "from",
    "to",
    "shift",
    "bias",
    "rms",
    "rms over mean",
    "correlation",
    "peak over reference",
    "peak at",
];
const MEANS: [&str; 4] = ["quantity", "item", "steady mean", "90 % interval"];

/// The table of differences.
fn rows(items: &[Item], comparison: &Comparison) -> SheetTable {
    let optional = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), short);
    let row = |compared: &Compared| {
        let name = items.get(compared.item).map_or("", |item| item.name.as_str());
        let mut cells = vec![header(compared.quantity), name.to_owned()];
        let shift = compared.aligned.as_ref().map_or(0.0, |aligned| aligned.shift);
        match &compared.differences {
            Some(d) => {
                let peak = d.peak_other.value / d.peak_reference.value;
                cells.extend([d.points.to_string()]);
                cells.extend([d.range[0], d.range[1], shift, d.bias, d.rms].map(short));
                cells.extend([
                    optional(d.relative),
                    optional(d.correlation),
                    short(peak),
                    short(d.peak_other.at),
                ]);
            }
            None => cells.extend(std::iter::repeat_n("–".to_owned(), HEAD.len() - 2)),
        }
        cells
    };
    SheetTable { head: HEAD.map(str::to_owned).to_vec(), rows: comparison.compared.iter().map(row).collect() }
}

fn header(quantity: Quantity) -> String {
    quantity.header()
}

/// The table of steady means.
fn means(items: &[Item], comparison: &Comparison) -> SheetTable {
    let mut rows = Vec::new();
    let mut push = |quantity: Quantity, item: usize, mean: &SteadyMean, note: &str| {
        let interval = match mean.half {
            Some(_) => {
                let [low, high] = mean.interval();
                format!("{} to {}{note}", short(low), short(high))
            }
            None => format!("–{note}"),
        };
        let name = items.get(item).map_or(String::new(), |item| item.name.clone());
        rows.push(vec![header(quantity), name, short(mean.mean), interval]);
    };
    for (quantity, _, mean) in &comparison.quantities {
        if let Some(mean) = mean {
            push(*quantity, comparison.reference, mean, " (reference)");
        }
        for compared in comparison.compared.iter().filter(|c| c.quantity == *quantity) {
            let note = match compared.overlaps {
                Some(true) => ", overlaps",
                Some(false) => ", apart",
                None => "",
            };
            if let Some(mean) = &compared.mean {
                push(*quantity, compared.item, mean, note);
            }
        }
    }
    SheetTable { head: MEANS.map(str::to_owned).to_vec(), rows }
}

/// What a terminal shows.
#[must_use]
pub fn comparison_text(items: &[Item], comparison: &Comparison) -> String {
    let reference = items.get(comparison.reference).map_or("", |item| item.name.as_str());
    let mut text = format!("reference: {reference}, along {}\n", comparison.against.header());
    for line in left_out(comparison) {
        text.push_str(&line);
        text.push('\n');
    }
    text.push_str(&rows(items, comparison).text());
    let means = means(items, comparison);
    if !means.rows.is_empty() {
        text.push('\n');
        text.push_str(&means.text());
    }
    for remark in &comparison.remarks {
        text.push_str(&format!("note: {remark}\n"));
    }
    text
}

/// Points of the reference at which models say nothing, in words; what several items leave out is said once.
fn left_out(comparison: &Comparison) -> Vec<String> {
    let mut lines: Vec<String> =
        comparison.compared.iter().flat_map(|compared| compared.left_out.iter().map(LeftOut::text)).collect();
    lines.dedup();
    lines
}

/// The differences as CSV, in SI units.
#[must_use]
pub fn comparison_csv(items: &[Item], comparison: &Comparison) -> String {
    let table = rows(items, comparison);
    let mut text = format!("{},steady mean,half of its 90 % interval,overlaps\n", HEAD.join(","));
    for (cells, compared) in table.rows.iter().zip(&comparison.compared) {
        let mut fields: Vec<String> =
            cells.iter().map(|cell| if cell == "–" { String::new() } else { cell.clone() }).collect();
        fields[1] = text_cell(&fields[1]);
        let mean = compared.mean.map_or([String::new(), String::new()], |mean| {
            [mean.mean.to_string(), mean.half.map_or(String::new(), |half| half.to_string())]
        });
        fields.extend(mean);
        fields.push(compared.overlaps.map_or(String::new(), |overlaps| overlaps.to_string()));
        text.push_str(&fields.join(","));
        text.push('\n');
    }
    text
}

/// The comparison as JSON, in SI units.
#[must_use]
pub fn comparison_document(items: &[Item], comparison: &Comparison) -> Value {
    let mean =
        |mean: &Option<SteadyMean>| mean.map(|m| json!({ "mean": m.mean, "half_interval_90": m.half }));
    let one = |compared: &Compared| {
        let figures = compared.differences.map(|d| {
            json!({
                "points": d.points, "range": d.range, "bias": d.bias, "rms": d.rms, "rms_over_mean": d.relative,
                "correlation": d.correlation,
                "peak": { "value": d.peak_other.value, "at": d.peak_other.at },
                "peak_reference": { "value": d.peak_reference.value, "at": d.peak_reference.at },
            })
        });
        json!({
            "item": compared.item, "quantity": compared.quantity.name(), "unit": compared.quantity.unit(),
            "shift": compared.aligned.as_ref().map(|aligned| aligned.shift), "differences": figures,
            "steady": mean(&compared.mean), "intervals_overlap": compared.overlaps,
        })
    };
    json!({
        "format": formats::DOCUMENT,
        "items": items.iter().map(|item| json!({ "name": item.name, "kind": item.kind.name() })).collect::<Vec<_>>(),
        "reference": comparison.reference,
        "against": { "name": comparison.against.name(), "unit": comparison.against.unit() },
        "steady_reference": comparison.quantities.iter().map(|(quantity, _, m)| json!({
            "quantity": quantity.name(), "steady": mean(m),
        })).collect::<Vec<_>>(),
        "compared": comparison.compared.iter().map(one).collect::<Vec<_>>(),
        "left_out": left_out(comparison),
        "remarks": comparison.remarks,
    })
}

/// The comparison as a page of HTML.
///
/// # Errors
/// What the template engine says.
pub fn comparison_page(items: &[Item], comparison: &Comparison) -> Result<String, String> {
    let kind = |item: &Item| [item.kind.name().to_owned(), item.name.clone()];
    let charts = comparison.quantities.iter().map(|(quantity, curve, mean)| {
        let svg = chart(items, comparison, *quantity, (curve, *mean));
        SheetFigure { svg, caption: format!("{} along {}.", quantity.label(), comparison.against.name()) }
    });
    let curves = SheetSection {
        title: "Curves".to_owned(),
        note: "Loading only: what lies behind the farthest place so far is left out.".to_owned(),
        tables: Vec::new(),
        figures: charts.collect(),
    };
    let differences = SheetSection {
        title: "Differences".to_owned(),
        note: "Other less reference, in SI units, where both have values. A shift moves the zero of the abscissa.".to_owned(),
        tables: vec![rows(items, comparison)],
        figures: Vec::new(),
    };
    let mut sections = vec![curves, differences];
    let means = means(items, comparison);
    if !means.rows.is_empty() {
        let note =
            "Intervals of the means, from averages over blocks; docs/how-to/compare.md says how.".to_owned();
        let title = "Steady means".to_owned();
        sections.push(SheetSection { title, note, tables: vec![means], figures: Vec::new() });
    }
    let reference = items.get(comparison.reference).map_or("", |item| item.name.as_str());
    let sheet = Sheet {
        title: format!("Compared with {reference}"),
        facts: items.iter().map(kind).collect(),
        warnings: left_out(comparison)
            .into_iter()
            .chain(comparison.remarks.iter().cloned())
            .map(|line| [line, String::new()])
            .collect(),
        sections,
        footer: "Made by coulter compare.".to_owned(),
    };
    sheet.html()
}

fn chart(
    items: &[Item],
    comparison: &Comparison,
    quantity: Quantity,
    (curve, mean): (&[[f64; 2]], Option<SteadyMean>),
) -> String {
    let stroke = |item: &Item, mark: usize| match item.kind {
        ItemKind::Measured => Stroke::Marks(mark),
        ItemKind::ClosedForm | ItemKind::Forecast => Stroke::Marked { dash: 1 + mark % 7, mark },
        ItemKind::Run => Stroke::Marked { dash: 0, mark },
    };
    let ends = [curve.first().map_or(0.0, |p| p[0]), curve.last().map_or(0.0, |p| p[0])];
    let mut curves = Vec::new();
    let mut levels = Vec::new();
    let mut add = |number: usize, points: &[[f64; 2]], mean: Option<SteadyMean>| {
        let Some(item) = items.get(number) else { return };
        curves.push(Curve {
            name: item.name.replace('_', " "),
            points: points.to_vec(),
            colour: number,
            stroke: stroke(item, number),
        });
        levels.extend(mean.map(|mean| Level {
            label: short(mean.mean),
            value: mean.mean,
            from: ends[0],
            to: ends[1],
            colour: number,
        }));
    };
    for compared in comparison.compared.iter().filter(|compared| compared.quantity == quantity) {
        add(compared.item, &compared.curve, compared.mean);
    }
    add(comparison.reference, curve, mean);
    let label = |quantity: Quantity| format!("{} [{}]", quantity.label(), quantity.unit());
    let chart = Chart {
        title: quantity.label().to_owned(),
        x_label: label(comparison.against),
        y_label: label(quantity),
        with_zero: true,
        curves,
        levels,
        ..Chart::default()
    };
    chart.svg()
}
