//! A mesh study as people read it: on the terminal and in the report.

use super::rows::{NONE, bare, grouped, value};
use super::summary::Summary;
use crate::mesh_study::{BodyOnMesh, Figures, MeshInterval, MeshResult, MeshStudy};
use crate::output::plots::{MeshPlot, Plot};
use crate::output::units::{Unit, digits};
use serde::Serialize;

/// One mesh, with the figures of one body.
#[derive(Debug, Serialize)]
pub(super) struct MeshRow {
    /// Cell size, number of cells, steps, wall time.
    pub(super) mesh: [String; 4],
    /// Drag, vertical force, sinkage, turn ratio, noise of the drag.
    pub(super) figures: [String; 5],
    pub(super) verdict: &'static str,
}

/// A figure with its interval, and what that consists of.
#[derive(Debug, Serialize)]
pub(super) struct IntervalRow {
    pub(super) name: &'static str,
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

/// A figure of a study: its name, its symbol and its unit.
struct Kind {
    name: &'static str,
    symbol: &'static str,
    unit: fn(f64) -> Unit,
}

const KINDS: Figures<Kind> = Figures {
    drag: Kind { name: "Drag", symbol: "F_H", unit: Unit::force },
    vertical: Kind { name: "Vertical force", symbol: "F_V", unit: Unit::force },
    sinkage: Kind { name: "Sinkage", symbol: "z", unit: Unit::length },
    turn_ratio: Kind { name: "Turn ratio", symbol: "ω r / v", unit: bare_unit },
};

fn bare_unit(_: f64) -> Unit {
    Unit { name: "", size: 1.0 }
}

fn in_order<T>(figures: Figures<T>) -> [T; 4] {
    [figures.drag, figures.vertical, figures.sinkage, figures.turn_ratio]
}

/// The bodies of a study, in the order of their names.
pub(super) fn body_rows(study: &MeshStudy) -> Vec<BodyRows> {
    let of_body = |name: &String| {
        let on_meshes: Vec<(&MeshResult, BodyOnMesh)> =
            study.meshes.iter().map(|m| (m, m.bodies.get(name).copied().unwrap_or_default())).collect();
        let body = study.bodies.get(name).cloned().unwrap_or_default();
        let finest = on_meshes.last().map_or_else(Figures::default, |(_, body)| body.means);
        let rows = in_order(KINDS).into_iter().zip(in_order(finest)).zip(in_order(body.figures));
        let (mut intervals, mut plots) = (Vec::new(), Vec::new());
        for (n, ((kind, mean), figure)) in rows.enumerate() {
            let Some((mean, figure)) = mean.zip(figure) else { continue };
            let values: Vec<[f64; 2]> = on_meshes
                .iter()
                .filter_map(|(mesh, body)| Some([mesh.width_m, in_order(body.means)[n]?]))
                .collect();
            let unit = (kind.unit)(values.iter().fold(0.0, |most, v| v[1].abs().max(most)));
            plots.push(plot(name, &kind, (&values, unit), &figure));
            intervals.push(interval_row(kind, mean, &figure));
        }
        let meshes = on_meshes.iter().map(|(mesh, body)| mesh_row(mesh, body)).collect();
        BodyRows { name: name.clone(), problem: body.no_interval_because, meshes, intervals, plots }
    };
    study.bodies.keys().map(of_body).collect()
}

fn plot(body: &str, kind: &Kind, (values, unit): (&[[f64; 2]], Unit), figure: &MeshInterval) -> Plot {
    let name = kind.name.to_lowercase();
    let label = if unit.name.is_empty() {
        kind.symbol.to_owned()
    } else {
        format!("{} [{}]", kind.symbol, unit.name)
    };
    let plot = MeshPlot {
        name: format!("{body}_meshes_{}", name.replace(' ', "_")),
        title: format!("{} and cell width", kind.name),
        label,
        unit: unit.size,
        values,
        interval: figure.interval,
        convergence: &figure.convergence,
    };
    plot.plot()
}

fn mesh_row(mesh: &MeshResult, body: &BodyOnMesh) -> MeshRow {
    let Figures { drag, vertical, sinkage, turn_ratio } = body.means;
    MeshRow {
        mesh: [
            cell_text(mesh.cell_m),
            grouped(mesh.cells),
            grouped(mesh.steps),
            format!("{} s", digits(mesh.wall_s)),
        ],
        figures: [
            value(drag, Unit::force),
            value(vertical, Unit::force),
            value(sinkage, Unit::length),
            bare(turn_ratio),
            per_cent(body.drag_noise),
        ],
        verdict: mesh.verdict.name(),
    }
}

fn interval_row(kind: Kind, mean: f64, figure: &MeshInterval) -> IntervalRow {
    let unit = (kind.unit)(mean.abs().max(figure.half_width));
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
        name: kind.name,
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

/// A cell size with up to five digits: 28.125 mm.
fn cell_text(cell: f64) -> String {
    let text = format!("{:.4e}", 1e3 * cell);
    format!("{} mm", text.parse::<f64>().unwrap_or(1e3 * cell))
}

fn per_cent(ratio: Option<f64>) -> String {
    ratio.map_or(NONE.to_owned(), |r| format!("{} %", digits(100.0 * r)))
}

/// The steady means of each body, a line each.
pub(crate) fn mean_lines(summary: &Summary) -> Vec<String> {
    let line = |(name, body): (&String, &super::summary::BodySummary)| {
        let steady = &body.steady;
        let turn = steady.turn_ratio.map_or(String::new(), |r| format!("  ωr/v {}", digits(r)));
        format!(
            "{name}: F_H {}  F_V {}  z {}{turn}",
            value(steady.drag, Unit::force),
            value(steady.vertical, Unit::force),
            value(steady.sinkage, Unit::length)
        )
    };
    summary.bodies.iter().map(line).collect()
}

/// The mesh study as lines of text; none without one.
#[must_use]
pub fn study_lines(summary: &Summary) -> Vec<String> {
    let Some(study) = &summary.mesh_study else { return Vec::new() };
    let mut lines = Vec::new();
    for body in body_rows(study) {
        let head = ["cell", "cells", "steps", "time", "F_H", "F_V", "z", "ω r/v", "noise", "grade"];
        let mut table = vec![head.map(str::to_owned).to_vec()];
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
    use crate::mesh_study::{BodyStudy, Convergence};

    fn study(no_interval_because: Option<&str>) -> Summary {
        let on = |drag: f64| BodyOnMesh {
            means: Figures { drag: Some(drag), vertical: Some(40.0), sinkage: Some(0.011), turn_ratio: None },
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
        let figures =
            Figures { drag: no_interval_because.is_none().then_some(interval), ..Figures::default() };
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
