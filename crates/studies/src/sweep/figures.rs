//! The figures for print that a study file asks for, and their files.

use super::assembly::ALL_BODIES;
use super::id::CaseId;
use super::part_rows::of_part;
use super::store::{Store, StudyError};
use crate::charts::{ChartRequest, NamedChart, RunCurve, ToldFigure, family_figure, history_figure};
use crate::history_columns;
use crate::page::PageFigure;
use crate::sources::{BodySamples, read_samples};
use crate::study::{ChartWish, Study};
use crate::table::{Column, Role, Table, Values};
use coulter::history::BodySample;
use coulter::history::columns::Column as HistoryColumn;
use coulter::output::figure::{
    Figure, FigureAxis, FigureFiles, FigurePoint, FigureSeries, SeriesKind, figure_files, script,
};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// The figures of a study.
#[derive(Default)]
pub(super) struct FigureSet {
    /// The figures with their files.
    pub(super) figures: Vec<(Figure, FigureFiles)>,
    /// The figures as the page shows them.
    pub(super) shown: Vec<PageFigure>,
    /// What could not be drawn and why, a sentence each.
    pub(super) remarks: Vec<String>,
}

/// The figures that the file asks for.
pub(super) fn figures(store: &Store, study: &Study, table: &Table) -> FigureSet {
    let mut set = FigureSet::default();
    let is_left_out = |name: &String| study.evaluated_parts().all(|part| part.name != *name);
    for wish in study.charts.iter().filter(|wish| !wish.part.as_ref().is_some_and(is_left_out)) {
        let part = study.parts.iter().find(|part| wish.part.as_ref() == Some(&part.name));
        let rows = part.map_or_else(|| table.clone(), |part| of_part(table, part)).without_unused();
        let told = if wish.history {
            history(store, &rows, wish, &mut set.remarks)
        } else {
            family_figure(&rows, &request(wish))
        };
        match told {
            Ok(told) => {
                let figure = finished(told.figure, study, wish);
                let files = figure_files(&figure);
                let part = part.filter(|part| !part.name.is_empty());
                let part = part.map(|part| format!("Part {}: ", part.name)).unwrap_or_default();
                let chart = NamedChart {
                    name: figure.name.clone(),
                    title: told.caption.clone(),
                    caption: format!("{part}{}", told.caption),
                    svg: files.svg.clone(),
                };
                set.shown.push(PageFigure { chart, is_wide: wish.columns > 1 });
                set.figures.push((figure, files));
            }
            Err(why) => set.remarks.push(format!("The figure {} is not drawn: {why}.", wish.name)),
        }
    }
    set
}

/// Writes the files of all figures; returns the paths of the documents.
///
/// # Errors
/// Where one cannot be written.
pub(super) fn write(store: &Store, all: &[(Figure, FigureFiles)]) -> Result<Vec<PathBuf>, StudyError> {
    let mut paths = Vec::new();
    for (Figure { name, .. }, files) in all {
        store.write(&format!("figures/{name}.svg"), files.svg.as_bytes())?;
        store.write(&format!("figures/{name}.csv"), files.csv.as_bytes())?;
        paths.push(store.write(&format!("figures/{name}.pdf"), &files.pdf)?);
    }
    if !all.is_empty() {
        let figures: Vec<Figure> = all.iter().map(|(figure, _)| figure.clone()).collect();
        store.write("figures/figures.py", script(&figures).as_bytes())?;
    }
    Ok(paths)
}

fn request(wish: &ChartWish) -> ChartRequest {
    ChartRequest {
        name: wish.name.clone(),
        x: wish.x.clone(),
        y: wish.y.clone(),
        family: wish.family.clone(),
        logarithmic: wish.logarithmic,
        logarithmic_x: wish.logarithmic_x,
        collapse: wish.collapse,
    }
}

/// A figure with measured points, and laid out as the file says.
fn finished(mut figure: Figure, study: &Study, wish: &ChartWish) -> Figure {
    for measured in &wish.measured {
        let [x_ends, y_ends] = &measured.ends;
        let of = |ends: &Option<Vec<[f64; 2]>>, n: usize| ends.as_ref().and_then(|list| list.get(n).copied());
        let point = |(n, at): (usize, &[f64; 2])| FigurePoint {
            at: *at,
            x_ends: of(x_ends, n),
            y_ends: of(y_ends, n),
            grade: String::new(),
        };
        figure.series.push(FigureSeries {
            kind: SeriesKind::Measured,
            level: String::new(),
            source: measured.label.clone(),
            points: measured.points.iter().enumerate().map(point).collect(),
        });
    }
    let axes = [&mut figure.x, &mut figure.y];
    for ((axis, range), label) in axes.into_iter().zip(wish.ranges).zip(&wish.labels) {
        axis.range = range;
        if let Some(label) = label {
            axis.label.clone_from(label);
        }
    }
    figure.legend = wish.legend;
    figure.style = study.style.of(wish.columns);
    figure
}

/// The figure of the histories of all runs in a table.
fn history(
    store: &Store,
    table: &Table,
    wish: &ChartWish,
    remarks: &mut Vec<String>,
) -> Result<ToldFigure, String> {
    let find = |name: &str| history_columns::find(name).ok_or(format!("`{name}` is no column of forces.csv"));
    let columns = [find(&wish.x)?, find(&wish.y)?];
    let mut curves = Vec::new();
    let mut seen = BTreeSet::new();
    for row in 0..table.rows() {
        let word = |name: &str| table.words(name).and_then(|list| list[row].clone());
        let is_run = word("model").as_deref() == Some("solver") && table.is_done(row);
        let Some(id) = word("id").filter(|id| is_run && seen.insert(id.clone())) else { continue };
        let points = CaseId::try_from(id.clone())
            .and_then(|id| store.run_folder(&id).map_err(|error| error.to_string()))
            .and_then(|folder| read_samples(&folder, one_body(word("body")).as_deref()))
            .map(|samples| along(&samples, columns));
        match points {
            Ok(points) => {
                let grade = word("grade").unwrap_or_default();
                curves.push(RunCurve { level: level(table, wish, row), grade, points });
            }
            Err(why) => remarks.push(format!("The figure {} lacks the run {id}: {why}.", wish.name)),
        }
    }
    let [x, y] = [(columns[0], wish.logarithmic || wish.logarithmic_x), (columns[1], wish.logarithmic)].map(
        |(column, logarithmic)| FigureAxis {
            label: history_columns::label(column),
            name: column.name.to_owned(),
            unit: column.unit.to_owned(),
            logarithmic,
            ..FigureAxis::default()
        },
    );
    history_figure(&wish.name, [x, y], &curves)
}

/// The body whose history is shown: of all bodies together, which have none, the first.
fn one_body(named: Option<String>) -> Option<String> {
    named.filter(|name| name != ALL_BODIES)
}

/// The values of a history along two columns.
fn along(of: &BodySamples, columns: [&HistoryColumn<BodySample>; 2]) -> Vec<[f64; 2]> {
    of.samples.iter().map(|sample| columns.map(|column| column.value(sample, &of.reference))).collect()
}

/// What tells a run from others: the level of the family, or of every factor that varies.
fn level(table: &Table, wish: &ChartWish, row: usize) -> String {
    let varies = |column: &&Column| {
        let differs = |other: usize| match &column.values {
            Values::Numbers(list) => list[other] != list[row],
            Values::Words(list) => list[other] != list[row],
        };
        column.role == Role::Factor && (0..table.rows()).any(differs)
    };
    let columns: Vec<&Column> = match &wish.family {
        Some(name) => table.column(name).into_iter().collect(),
        None => table.columns.iter().filter(varies).collect(),
    };
    let shown = columns.iter().filter_map(|column| crate::charts::level_name(column, row));
    shown.collect::<Vec<_>>().join(", ")
}
