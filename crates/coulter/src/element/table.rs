//! Element tests as text for a terminal.

use super::figures::{FigureUnit, KeyFigure};
use super::path::TestKind;
use super::shown::{decimals, stress};
use super::tested::{ElementTests, Tested};
use input::quantity::plain;
use input::text::wrapped;
use std::fmt::Write;

/// The key figures as text for a terminal: a line for each specimen, then remarks.
#[must_use]
pub fn table(tests: &ElementTests) -> String {
    let rows: Vec<Vec<[String; 2]>> =
        tests.tested.iter().enumerate().map(|(n, tested)| row(n, tested)).collect();
    let mut text = format!("{}\n\n", title(tests.kind));
    let Some(first) = rows.first() else { return text };
    let headers: Vec<&String> = first.iter().map(|cell| &cell[0]).collect();
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column)).map(|cell| cell[1].chars().count());
        cells.chain([headers[column].chars().count()]).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..headers.len()).map(width).collect();
    let mut line = |cells: Vec<&String>| {
        let padded: Vec<String> = cells.iter().zip(&widths).map(|(c, w)| format!("{c:>w$}")).collect();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", padded.join("  "));
    };
    line(headers);
    for row in &rows {
        line(row.iter().map(|cell| &cell[1]).collect());
    }
    if !tests.remarks.is_empty() {
        text.push('\n');
        for remark in &tests.remarks {
            let _ = writeln!(text, "{}", wrapped(&format!("note: {remark}")));
        }
    }
    text
}

fn title(kind: TestKind) -> &'static str {
    match kind {
        TestKind::Triaxial => "Drained triaxial compression at constant lateral stress",
        TestKind::Oedometer => "Oedometer: vertical compression without lateral strain, and unloading",
        TestKind::Isotropic => "Isotropic compression, and unloading",
        TestKind::Shear => "Simple shear at constant vertical stress",
    }
}

/// The cells of a specimen's line, each with the header of its column.
fn row(number: usize, tested: &Tested) -> Vec<[String; 2]> {
    let symbol = match tested.test.kind {
        TestKind::Triaxial => "σ₃",
        TestKind::Isotropic => "p",
        TestKind::Oedometer | TestKind::Shear => "σ_v",
    };
    let mut cells = vec![
        ["no.".to_owned(), (number + 1).to_string()],
        [symbol.to_owned(), stress(tested.test.pressure)],
        ["ρ [kg/m³]".to_owned(), format!("{:.0}", tested.test.density)],
    ];
    cells.extend(tested.relative_density.map(|r| ["I_D".to_owned(), format!("{r:.2}")]));
    let modulus = if tested.test.kind == TestKind::Isotropic { "K" } else { "E_oed" };
    cells.extend(tested.figures.moduli.iter().map(|secant| {
        let [from, to] = secant.pressures.map(|p| plain(p / 1e3));
        [format!("{modulus} {from}–{to} kPa"), stress(secant.modulus)]
    }));
    cells.extend(tested.figures.list.iter().filter(|figure| !figure.label.is_empty()).map(cell));
    cells
}

fn cell(figure: &KeyFigure) -> [String; 2] {
    let KeyFigure { label, value, .. } = figure;
    let (unit, text) = match figure.unit {
        FigureUnit::Stress => ("", stress(*value)),
        FigureUnit::Angle => (" [°]", decimals(value.to_degrees(), 1)),
        FigureUnit::Strain => (" [%]", decimals(100.0 * value, 2)),
        FigureUnit::Number => ("", decimals(*value, 2)),
        FigureUnit::Density => (" [kg/m³]", format!("{value:.0}")),
    };
    let text = if value.is_finite() { text } else { "–".to_owned() };
    [format!("{label}{unit}"), text]
}
