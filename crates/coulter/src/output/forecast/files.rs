//! The files of a forecast: the models as a table and a document, their curves as a table and as plots.

use crate::forecast::{Curves, Series};
use input::readable::{Unit, largest};
use report::plots::{Chart, Curve, Stroke};
use results::files::{Inside, OutputError, make_folder, write_json, write_whole};
use results::tables::push_line;
use std::path::{Path, PathBuf};

const MODELS: &str = "models.csv";
const DOCUMENT: &str = "forecast.json";
const CURVE: &str = "curve.csv";
/// Models that are drawn wherever they have an answer, so that their crossing is visible; others only where
/// they apply.
const ALWAYS_DRAWN: [&str; 3] = ["weaker of BC and PW", "BC", "PW"];

/// The content of the files of a forecast.
#[derive(Clone, Copy, Debug)]
pub struct ForecastFiles<'a> {
    /// The models as comma-separated values.
    pub models: &'a str,
    /// The JSON document.
    pub document: &'a serde_json::Value,
    /// The curves.
    pub curves: &'a Curves,
}

/// Writes the files into `dir` and returns their paths. Existing files are replaced only with `force`.
///
/// # Errors
/// When one of the files exists already or cannot be written.
pub fn write_forecast(
    dir: &Path,
    files: &ForecastFiles<'_>,
    force: bool,
) -> Result<Vec<PathBuf>, OutputError> {
    let plots = plots(files.curves);
    let names = [MODELS, DOCUMENT, CURVE].into_iter().map(str::to_owned);
    let paths: Vec<PathBuf> =
        names.chain(plots.iter().map(|(name, _)| name.clone())).map(|n| dir.join(n)).collect();
    if !force && paths.iter().any(|p| Inside::at(p).exists()) {
        return Err(OutputError::Exists { path: dir.to_path_buf() });
    }
    make_folder(&Inside::of(dir, ""))?;
    write_whole(&Inside::of(dir, MODELS), files.models.as_bytes())?;
    write_json(&Inside::of(dir, DOCUMENT), files.document)?;
    write_whole(&Inside::of(dir, CURVE), curve_text(files.curves).as_bytes())?;
    for (name, svg) in &plots {
        write_whole(&Inside::of(dir, name), svg.as_bytes())?;
    }
    Ok(paths)
}

/// One line per value; per model whether it applies, and its numbers with and without dimensions.
fn curve_text(curves: &Curves) -> String {
    let mut header = vec![curves.label.clone(), format!("{} [group]", curves.group_label)];
    for series in &curves.series {
        let columns = [
            "applicable [-]",
            "drag F_H [N]",
            "vertical F_V [N]",
            "sinkage z [m]",
            "slip [-]",
            "F_H_bar [-]",
            "F_V_bar [-]",
            "Z [-]",
        ];
        header.extend(columns.iter().map(|column| format!("{} {column}", series.name)));
    }
    let mut text = format!("{}\n", header.join(","));
    for (n, value) in curves.values.iter().enumerate() {
        let mut line = vec![*value, curves.group[n]];
        let (force, length) = (curves.force_scale[n], curves.length_scale[n]);
        for s in &curves.series {
            let applies = if s.applicable[n] { 1.0 } else { 0.0 };
            line.extend([applies, s.drag[n], s.vertical[n], s.sinkage[n], s.slip[n]]);
            line.extend([s.drag[n] / force, s.vertical[n] / force, s.sinkage[n] / length]);
        }
        push_line(&mut text, &line);
    }
    text
}

/// File name and SVG text of every plot.
fn plots(curves: &Curves) -> Vec<(String, String)> {
    type Quantity = (&'static str, &'static str, &'static str, fn(&Series) -> &[f64], bool);
    let forces: [Quantity; 3] = [
        ("drag", "drag F_H", "F_H/(γ t d²)", |s| &s.drag, true),
        ("vertical", "vertical force F_V", "F_V/(γ t d²)", |s| &s.vertical, true),
        ("sinkage", "sinkage z", "Z = z/d", |s| &s.sinkage, false),
    ];
    let mut plots = Vec::new();
    for (name, label, group, of, is_force) in forces {
        // What is pressed down has no drag.
        let is_pressed =
            curves.series.iter().all(|s| s.drag.iter().all(|drag| *drag == 0.0 || drag.is_nan()));
        if name == "sinkage" && !curves.sinks || name == "drag" && is_pressed {
            continue;
        }
        let all = || curves.series.iter().flat_map(|s| drawn(s, of(s)));
        let unit = if is_force { Unit::force(largest(all())) } else { Unit::length(largest(all())) };
        let y_label = format!("{label} [{}]", unit.name);
        let size = vec![unit.size; curves.values.len()];
        let plain =
            chart(curves, &curves.label, &curves.values, Ordinate { label: y_label, of, scale: &size });
        plots.push((format!("{name}.svg"), plain.svg()));
        let scale = if is_force { &curves.force_scale } else { &curves.length_scale };
        if scale.iter().any(|scale| scale.is_nan()) {
            continue;
        }
        let bare =
            chart(curves, curves.group_label, &curves.group, Ordinate { label: group.to_owned(), of, scale });
        plots.push((format!("{name}_dimensionless.svg"), bare.svg()));
    }
    plots
}

/// The ordinate of a chart: its label, its values, and what they are divided by, by point.
struct Ordinate<'a> {
    label: String,
    of: fn(&Series) -> &[f64],
    scale: &'a [f64],
}

fn chart(curves: &Curves, x_label: &str, along: &[f64], ordinate: Ordinate<'_>) -> Chart {
    let Ordinate { label: y_label, of, scale } = ordinate;
    let line = |(colour, series): (usize, &Series)| {
        let values = drawn(series, of(series));
        let points: Vec<[f64; 2]> =
            values.iter().zip(along).zip(scale).map(|((y, x), scale)| [*x, y / scale]).collect();
        let stroke = match series.name {
            // Only the recommended model is drawn as a solid line.
            name if name == curves.recommended => Stroke::Solid,
            _ => Stroke::Marked { dash: 1 + colour % 7, mark: colour },
        };
        let any = points.iter().any(|p| p[1].is_finite());
        any.then(|| Curve { name: series.name.to_owned(), points, colour, stroke })
    };
    Chart {
        title: format!("{}, by every model that applies", y_label.split(" [").next().unwrap_or_default()),
        x_label: x_label.to_owned(),
        y_label,
        with_zero: true,
        logarithmic: curves.logarithmic,
        curves: curves.series.iter().enumerate().filter_map(line).collect(),
        ..Chart::default()
    }
}

/// The values to draw; not-a-number where a model does not apply.
fn drawn(series: &Series, values: &[f64]) -> Vec<f64> {
    let always = ALWAYS_DRAWN.contains(&series.name);
    let seen = |(value, applies): (&f64, &bool)| if *applies || always { *value } else { f64::NAN };
    values.iter().zip(&series.applicable).map(seen).collect()
}
