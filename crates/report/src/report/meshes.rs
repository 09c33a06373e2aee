//! A mesh study as people read it: on the terminal and in the report.

use super::rows::{NONE, grouped, value};
use super::summary::Summary;
use crate::plots::{MeshPlot, Plot};
use input::readable::{Unit, digits};
use results::history::quantities::{Figures, Quantity};
use results::mesh_study::{BodyOnMesh, MeshInterval, MeshResult, MeshStudy, millimetres};
use serde::Serialize;

/// One mesh, with the figures of one body.
#[derive(Debug, Serialize)]
pub(super) struct MeshRow {
    /// Cell size, number of cells, steps, wall time.
    pub(super) mesh: [String; 4],
    /// Means, and the noise of the drag.
    pub(super) figures: Vec<String>,
    pub(super) verdict: &'static str,
}

/// A figure with its interval, and what that consists of.
#[derive(Debug, Serialize)]
pub(super) struct IntervalRow {
    pub(super) name: String,
    pub(super) value: String,
    pub(super) interval: String,
    /// Half-width, its part due to the mesh and its statistical part.
    pub(super) parts: [String; 3],
    /// Observed order and safety factor; whether the values are monotonic.
    pub(super) convergence: [String; 3],
}

/// A body of the study.
#[derive(Debug)]
pub(super) struct BodyRows {
    pub(super) name: String,
    pub(super) problem: Option<String>,
    pub(super) meshes: Vec<MeshRow>,
    pub(super) intervals: Vec<IntervalRow>,
    pub(super) plots: Vec<Plot>,
}

/// The bodies of a study, in the order of their names.
pub(super) fn body_rows(study: &MeshStudy) -> Vec<BodyRows> {
    let of_body = |name: &String| {
        let on_meshes: Vec<(&MeshResult, BodyOnMesh)> =
            study.meshes.iter().map(|m| (m, m.bodies.get(name).cloned().unwrap_or_default())).collect();
        let body = study.bodies.get(name).cloned().unwrap_or_default();
        let finest = on_meshes.last().map_or_else(Figures::default, |(_, body)| body.means.clone());
        let (mut intervals, mut plots) = (Vec::new(), Vec::new());
        for (quantity, figure) in body.figures.iter() {
            let key = quantity.figure.name;
            let Some((mean, figure)) = finest.get(key).zip(figure.as_ref()) else { continue };
            let values: Vec<[f64; 2]> = on_meshes
                .iter()
                .filter_map(|(mesh, body)| Some([mesh.width_m, body.means.get(key)?]))
                .collect();
            plots.push(plot(name, quantity, &values, figure));
            intervals.push(interval_row(quantity, mean, figure));
        }
        let meshes = on_meshes.iter().map(|(mesh, body)| mesh_row(mesh, body)).collect();
        BodyRows { name: name.clone(), problem: body.no_interval_because, meshes, intervals, plots }
    };
    study.bodies.keys().map(of_body).collect()
}

fn plot(body: &str, quantity: Quantity, values: &[[f64; 2]], figure: &MeshInterval) -> Plot {
    let largest = values.iter().fold(0.0, |most, v| v[1].abs().max(most));
    let unit = Unit::of(quantity.column.unit, largest);
    let label = match unit.name {
        "" => quantity.figure.symbol.to_owned(),
        name => format!("{} [{name}]", quantity.figure.symbol),
    };
    let plot = MeshPlot {
        name: format!("{body}_meshes_{}", quantity.figure.words.replace(' ', "_")),
        title: format!("{} and cell width", quantity.title()),
        label,
        unit: unit.size,
        values,
        interval: figure.interval,
        convergence: &figure.convergence,
    };
    plot.plot()
}

fn mesh_row(mesh: &MeshResult, body: &BodyOnMesh) -> MeshRow {
    let means = body.means.iter().map(|(quantity, mean)| shown(quantity, *mean));
    MeshRow {
        mesh: [
            format!("{} mm", millimetres(mesh.cell_m)),
            grouped(mesh.cells),
            grouped(mesh.steps),
            format!("{} s", digits(mesh.wall_s)),
        ],
        figures: means.chain([per_cent(body.drag_noise)]).collect(),
        verdict: mesh.verdict.name(),
    }
}

/// A mean with its unit.
fn shown(quantity: Quantity, mean: Option<f64>) -> String {
    value(mean, |size| Unit::of(quantity.column.unit, size)).trim_end().to_owned()
}

fn interval_row(quantity: Quantity, mean: f64, figure: &MeshInterval) -> IntervalRow {
    let unit = Unit::of(quantity.column.unit, mean.abs().max(figure.half_width));
    let number = |v: f64| format!("{} {}", digits(v / unit.size), unit.name).trim_end().to_owned();
    let [low, high] = figure.interval;
    let convergence = &figure.convergence;
    let monotonic = convergence.is_monotonic.map_or(NONE, |is| if is { "yes" } else { "no" });
    let order = convergence.observed_order.map_or_else(
        || format!("{} (assumed)", digits(convergence.order)),
        |observed| {
            if observed == convergence.order {
                digits(observed)
            } else {
                format!("{} (used: {})", digits(observed), digits(convergence.order))
            }
        },
    );
    IntervalRow {
        name: quantity.title(),
        value: number(mean),
        interval: format!("{} … {}", digits(low / unit.size), number(high)),
        parts: [
            number(figure.half_width)
                + &figure
                    .relative_half_width
                    .map_or(String::new(), |r| format!(" ({} %)", digits(100.0 * r))),
            number(convergence.mesh_half_width),
            number(figure.statistical_half_width),
        ],
        convergence: [order, digits(convergence.safety_factor), monotonic.to_owned()],
    }
}

fn per_cent(ratio: Option<f64>) -> String {
    ratio.map_or(NONE.to_owned(), |r| format!("{} %", digits(100.0 * r)))
}

/// The steady means of each body, a line each.
pub fn mean_lines(summary: &Summary) -> Vec<String> {
    let line = |(name, body): (&String, &super::summary::BodySummary)| {
        let mut text = format!("{name}:");
        for quantity in Quantity::on_meshes() {
            let mean = quantity.mean(&body.steady);
            // What does not turn has no ratio.
            if mean.is_some() || quantity.column.unit != "-" {
                let symbol = quantity.figure.symbol.replace(' ', "");
                text += &format!("  {symbol} {}", shown(quantity, mean));
            }
        }
        text.replacen("  ", " ", 1)
    };
    summary.bodies.iter().map(line).collect()
}

/// The mesh study as lines of text; none without one.
#[must_use]
pub fn study_lines(summary: &Summary) -> Vec<String> {
    let Some(study) = &summary.mesh_study else { return Vec::new() };
    let mut lines = Vec::new();
    for body in body_rows(study) {
        let symbols = Quantity::on_meshes().map(|quantity| quantity.figure.symbol.replace(" / ", "/"));
        let head = ["cell", "cells", "steps", "time"].map(str::to_owned).into_iter().chain(symbols);
        let mut table = vec![head.chain(["noise", "grade"].map(str::to_owned)).collect::<Vec<_>>()];
        for MeshRow { mesh, figures, verdict } in body.meshes {
            table.push(mesh.into_iter().chain(figures).chain([verdict.to_owned()]).collect());
        }
        lines.push(format!("mesh study of {}", body.name));
        lines.extend(aligned(&table));
        for row in body.intervals {
            let [whole, mesh, statistics] = row.parts;
            let [order, safety, _] = row.convergence;
            lines.push(format!(
                "  {}: {}, interval {}: ± {whole}; mesh ± {mesh} (order {order}, safety {safety}), statistics ± {statistics}",
                row.name.to_lowercase(),
                row.value,
                row.interval
            ));
        }
        lines.extend(body.problem.map(|why| format!("  no intervals: {why}")));
    }
    lines
}

/// The columns of a table, aligned to the right but for the last.
fn aligned(table: &[Vec<String>]) -> Vec<String> {
    let columns = table.first().map_or(0, Vec::len);
    let letters = |text: &String| text.chars().count();
    let widths: Vec<usize> = (0..columns)
        .map(|n| table.iter().filter_map(|row| row.get(n)).map(letters).max().unwrap_or(0))
        .collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).enumerate().map(|(n, (text, width))| {
            if n + 1 == columns {
                text.clone()
            } else {
                format!("{}{text}", " ".repeat(width - letters(text)))
            }
        });
        format!("  {}", cells.collect::<Vec<_>>().join("  "))
    };
    table.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use results::mesh_study::{BodyStudy, Convergence};

    fn study(no_interval_because: Option<&str>) -> Summary {
        let on = |drag: f64| BodyOnMesh {
            means: Figures::on_meshes(|quantity| match quantity.figure.name {
                "drag" => Some(drag),
                "vertical" => Some(40.0),
                "sinkage" => Some(0.011),
                _ => None,
            }),
            drag_noise: Some(0.02),
        };
        let mesh = |cell_m: f64, drag: f64| MeshResult {
            cell_m,
            width_m: cell_m,
            cells: 12_345,
            steps: 678,
            wall_s: 4.2,
            bodies: [("disc".to_owned(), on(drag))].into(),
            ..MeshResult::default()
        };
        let interval = MeshInterval {
            interval: [13.0, 15.0],
            half_width: 1.0,
            convergence: Convergence { order: 1.0, safety_factor: 3.0, ..Convergence::default() },
            ..MeshInterval::default()
        };
        let has_one = |quantity: Quantity| no_interval_because.is_none() && quantity.figure.name == "drag";
        let figures = Figures::on_meshes(|quantity| has_one(quantity).then_some(interval));
        let body = BodyStudy { no_interval_because: no_interval_because.map(str::to_owned), figures };
        let study = MeshStudy {
            meshes: vec![mesh(0.01875, 14.2), mesh(0.0125, 14.0)],
            bodies: [("disc".to_owned(), body)].into(),
        };
        Summary { mesh_study: Some(study), ..Summary::default() }
    }

    #[test]
    fn a_study_is_a_table_and_a_line_for_each_interval() {
        let lines = study_lines(&study(None));
        assert_eq!(lines.len(), 5, "{lines:#?}");
        assert!(lines[2].contains("18.75 mm") && lines[3].contains("12.5 mm"), "{lines:#?}");
        let length = |n: usize| lines[n].chars().count();
        assert_eq!(length(2), length(3));
        for words in
            ["drag: 14.0 N", "interval 13.0 … 15.0 N", "± 1.00 N", "order 1.00 (assumed)", "safety 3.00"]
        {
            assert!(lines[4].contains(words), "`{words}` is not in {}", lines[4]);
        }
    }

    #[test]
    fn a_study_without_intervals_says_why() {
        let lines = study_lines(&study(Some("the run on cells of 12.5 mm is not steady")));
        assert!(lines[4].contains("no intervals: the run on cells of 12.5 mm is not steady"), "{lines:#?}");
        assert_eq!(study_lines(&Summary::default()), Vec::<String>::new());
    }
}
