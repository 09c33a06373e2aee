//! Families of curves: a response over a factor or over another response, a curve for each level of a second
//! factor and each model.

use super::classes::{Class, MOST_CLASSES, classes, models};
use super::collapse::scatter;
use super::label::{axis_label, class_name, plain_label};
use super::request::ChartRequest;
use crate::statistics::collapse::collapse;
use crate::table::{Column, Role, Table, Values};
use coulter::output::figure::{Figure, FigureAxis, FigurePoint, FigureSeries, SeriesKind};

/// Levels of the x axis up to which points are joined through their means where other factors vary, too
/// (chosen).
const MOST_LEVELS: usize = 12;

/// The model of the runs of the solver.
const SOLVER: &str = "solver";

/// A figure, and what is said of it.
#[derive(Clone, Debug, PartialEq)]
pub struct ToldFigure {
    /// The figure, with labels and scales of its columns.
    pub figure: Figure,
    /// Caption below the figure; may contain subscripts: `F_H`.
    pub caption: String,
}

/// What a chart is made of: the table, its columns, and whether closed forms are lines.
struct Shown<'a> {
    table: &'a Table,
    x: &'a Column,
    y: &'a Column,
    family: Option<&'a Column>,
    is_joined: bool,
}

/// The figure of a request.
///
/// # Errors
/// A sentence that says which column is missing or holds no numbers, or that no row has both values.
pub fn family_figure(table: &Table, request: &ChartRequest) -> Result<ToldFigure, String> {
    let find = |name: &str| table.column(name).ok_or(format!("there is no column `{name}`"));
    let (x, y) = (find(&request.x)?, find(&request.y)?);
    let family = request.family.as_deref().map(find).transpose()?;
    if let Values::Words(_) = &y.values {
        return Err(format!("the column `{}` holds words", y.name));
    }
    let title = title(x, y, family);
    let varied = others(table, &[Some(x), family]);
    let is_joined = !request.collapse && are_curves(x, family, varied.len());
    let shown = Shown { table, x, y, family, is_joined };
    let mut series = shown.series();
    if series.is_empty() {
        return Err(format!("no row has both `{}` and `{}`", x.name, y.name));
    }
    let means = if is_joined { ": lines run through the means" } else { "" };
    let mut caption = if varied.is_empty() {
        format!("{title}.")
    } else if is_joined && x.role != Role::Factor {
        format!("{title}. Along each curve {} varies.", varied.join(", "))
    } else {
        format!("{title}. Other factors vary, too ({}){means}.", varied.join(", "))
    };
    if request.collapse {
        let points: Vec<[f64; 2]> = series.iter().flat_map(|one| &one.points).map(|point| point.at).collect();
        let found = collapse(&points).map_err(|error| error.to_string())?;
        caption = format!("{title}{}", scatter(&found));
        let points = found.median.into_iter().map(|at| FigurePoint { at, ..FigurePoint::default() });
        series.push(FigureSeries {
            kind: SeriesKind::Line,
            level: String::new(),
            source: "running median".to_owned(),
            points: points.collect(),
        });
    }
    let [x, y] = [(x, request.logarithmic || request.logarithmic_x), (y, request.logarithmic)]
        .map(|(column, is_logarithmic)| axis(column, is_logarithmic));
    Ok(ToldFigure {
        figure: Figure { name: request.name.clone(), x, y, series, ..Figure::default() },
        caption,
    })
}

fn axis(column: &Column, logarithmic: bool) -> FigureAxis {
    let mut words: Vec<String> = Vec::new();
    if let Values::Words(list) = &column.values {
        for word in list.iter().flatten() {
            if !words.contains(word) {
                words.push(word.clone());
            }
        }
    }
    FigureAxis {
        label: axis_label(column),
        name: column.name.clone(),
        unit: column.unit.clone(),
        range: None,
        logarithmic,
        words,
    }
}

fn title(x: &Column, y: &Column, family: Option<&Column>) -> String {
    let by = family.map(|column| format!(", by {}", plain_label(column))).unwrap_or_default();
    format!("{} over {}{by}", plain_label(y), plain_label(x))
}

/// Labels of the factors that vary besides those in the chart.
fn others(table: &Table, shown: &[Option<&Column>]) -> Vec<String> {
    let factors = table.columns.iter().filter(|column| column.role == Role::Factor);
    let hidden = factors.filter(|column| !shown.iter().flatten().any(|other| other.name == column.name));
    let all: Vec<usize> = (0..table.rows()).collect();
    hidden.filter(|column| classes(column, &all).len() > 1).map(plain_label).collect()
}

/// Every class of the family with every model, with the rows of both.
fn groups(table: &Table, family: Option<&Column>) -> (Vec<Class>, Vec<Class>) {
    let all: Vec<usize> = (0..table.rows()).collect();
    let one = vec![Class { label: String::new(), rows: all.clone() }];
    // A family of models tells them apart already.
    let by_model =
        if family.is_some_and(|column| column.name == "model") { one.clone() } else { models(table) };
    (family.map_or(one, |column| classes(column, &all)), by_model)
}

impl Shown<'_> {
    /// A series of every class of the family with every model.
    fn series(&self) -> Vec<FigureSeries> {
        let (by_family, by_model) = groups(self.table, self.family);
        let is_by_model = self.family.is_some_and(|column| column.name == "model");
        let mut list = Vec::new();
        for members in &by_family {
            let level = match self.family {
                Some(column) if !is_by_model => class_name(column, &members.label),
                _ => String::new(),
            };
            for model in &by_model {
                let is_inside = |row: &&usize| model.rows.binary_search(row).is_ok();
                let rows: Vec<usize> = members.rows.iter().filter(is_inside).copied().collect();
                let source = if is_by_model { &members.label } else { &model.label };
                list.extend(self.one(&rows, level.clone(), source));
            }
        }
        list
    }

    /// The series of some rows of a model.
    fn one(&self, rows: &[usize], level: String, model: &str) -> Option<FigureSeries> {
        let mut points: Vec<FigurePoint> = rows.iter().filter_map(|row| self.point(*row)).collect();
        points.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]).then(a.at[1].total_cmp(&b.at[1])));
        let is_word = matches!(self.x.values, Values::Words(_));
        let kind = if model == SOLVER {
            SeriesKind::Computed
        } else if self.is_joined && !is_word {
            SeriesKind::Line
        } else {
            SeriesKind::Dots
        };
        if kind != SeriesKind::Computed && (self.is_joined || is_word) {
            points = means(&points);
        }
        let source = model.replace('_', " ");
        (!points.is_empty()).then_some(FigureSeries { kind, level, source, points })
    }

    /// The point of a row, with its intervals and its grade.
    fn point(&self, row: usize) -> Option<FigurePoint> {
        let x = match &self.x.values {
            Values::Numbers(list) => list[row]?,
            Values::Words(list) => {
                let word = list[row].as_ref()?;
                axis(self.x, false).words.iter().position(|other| other == word)? as f64
            }
        };
        let Values::Numbers(ys) = &self.y.values else { return None };
        let end = |column: &Column, end: &str| {
            self.table.numbers(&format!("{}_{end}", column.name)).and_then(|list| list[row])
        };
        let ends = |column: &Column| Some([end(column, "low")?, end(column, "high")?]);
        let grade = self.table.words("grade").and_then(|list| list[row].clone());
        Some(FigurePoint {
            at: [x, ys[row]?],
            x_ends: ends(self.x),
            y_ends: ends(self.y),
            grade: grade.unwrap_or_default(),
        })
    }
}

/// The means at each place of x; intervals of a mean are not known.
fn means(points: &[FigurePoint]) -> Vec<FigurePoint> {
    let mean = |part: &[FigurePoint]| {
        if let [alone] = part {
            return alone.clone();
        }
        let sum: f64 = part.iter().map(|point| point.at[1]).sum();
        FigurePoint { at: [part[0].at[0], sum / part.len() as f64], ..FigurePoint::default() }
    };
    points.chunk_by(|a, b| a.at[0] == b.at[0]).map(mean).collect()
}

/// Whether points are joined: those over a factor at few places, or at many where no other factor varies and
/// the family has levels; and those over a response along which a single factor leads.
fn are_curves(x: &Column, family: Option<&Column>, others: usize) -> bool {
    let places = |column: &Column| match &column.values {
        Values::Words(_) => 0,
        Values::Numbers(list) => {
            let mut present: Vec<f64> = list.iter().flatten().copied().collect();
            present.sort_by(f64::total_cmp);
            present.dedup();
            present.len()
        }
    };
    let levels = family.is_none_or(|column| places(column) <= MOST_CLASSES);
    match x.role {
        Role::Factor => levels && (places(x) <= MOST_LEVELS || others == 0),
        _ => levels && others == 1 && family.is_some(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{column, grid};
    use super::*;
    use crate::statistics::design::latin_hypercube;

    fn request(x: &str, y: &str, family: Option<&str>) -> ChartRequest {
        ChartRequest {
            name: "Drag".into(),
            x: x.into(),
            y: y.into(),
            family: family.map(str::to_owned),
            ..ChartRequest::default()
        }
    }

    #[test]
    fn a_grid_gives_a_series_for_each_level_and_model() {
        let told = family_figure(&grid(), &request("angle", "drag", Some("depth"))).unwrap();
        let names: Vec<[&str; 2]> =
            told.figure.series.iter().map(|one| [one.level.as_str(), one.source.as_str()]).collect();
        assert_eq!(names[0], ["depth = 0.1 m", "solver"]);
        assert_eq!(names[3], ["depth = 0.2 m", "plain model"]);
        // Every run is a mark, closed forms run through the means over both tips.
        let counts: Vec<(SeriesKind, usize)> =
            told.figure.series.iter().map(|one| (one.kind, one.points.len())).collect();
        assert_eq!(counts[1..], [(SeriesKind::Line, 5), (SeriesKind::Computed, 9), (SeriesKind::Line, 5)]);
        assert!(told.caption.contains("tip"), "{}", told.caption);
        assert_eq!((told.figure.x.label.as_str(), told.figure.name.as_str()), ("angle [deg]", "Drag"));
    }

    #[test]
    fn points_of_a_design_that_fills_space_are_not_joined() {
        let design = latin_hypercube(40, 2, 1).unwrap();
        let numbers = |k: usize| Values::Numbers(design.iter().map(|x| Some(x[k])).collect());
        let columns = vec![
            column("a", "m", Role::Factor, numbers(0)),
            column("b", "m", Role::Factor, numbers(1)),
            column("drag", "N", Role::Response, numbers(0)),
        ];
        let told = family_figure(&Table { columns }, &request("a", "drag", Some("b"))).unwrap();
        assert!(told.figure.series.iter().all(|one| one.kind == SeriesKind::Dots));
        assert_eq!(told.figure.series.iter().map(|one| one.points.len()).sum::<usize>(), 40);
    }

    #[test]
    fn models_that_are_the_family_are_named_once() {
        let told = family_figure(&grid(), &request("angle", "drag", Some("model"))).unwrap();
        let names: Vec<[&str; 2]> =
            told.figure.series.iter().map(|one| [one.level.as_str(), one.source.as_str()]).collect();
        assert_eq!(names, [["", "solver"], ["", "plain model"]]);
    }

    #[test]
    fn intervals_and_grades_of_the_table_are_shown() {
        let mut table = grid();
        let rows = table.rows();
        let level = |value: f64| Values::Numbers(vec![Some(value); rows]);
        table.columns.push(column("drag_low", "N", Role::Remark, level(1.0)));
        table.columns.push(column("drag_high", "N", Role::Remark, level(9.0)));
        let grades = Values::Words(vec![Some("doubtful".into()); rows]);
        table.columns.push(column("grade", "", Role::Remark, grades));
        let told = family_figure(&table, &request("angle", "drag", Some("depth"))).unwrap();
        let point = &told.figure.series[0].points[0];
        assert_eq!((point.y_ends, point.x_ends, point.grade.as_str()), (Some([1.0, 9.0]), None, "doubtful"));
        assert_eq!(told.figure.series[1].points[0].y_ends, None);
    }

    #[test]
    fn words_on_the_axis_have_a_place_each() {
        let told = family_figure(&grid(), &request("tip", "drag", None)).unwrap();
        assert_eq!(told.figure.x.words, ["sharp", "blunt"]);
        assert_eq!(told.figure.series[1].kind, SeriesKind::Dots);
        assert_eq!(told.figure.series[1].points.len(), 2);
    }

    #[test]
    fn a_collapse_says_its_scatter() {
        let asked = ChartRequest { collapse: true, ..request("angle", "drag", Some("depth")) };
        let told = family_figure(&grid(), &asked).unwrap();
        assert!(told.caption.contains("nine in ten"), "{}", told.caption);
        assert_eq!(told.figure.series.last().unwrap().source, "running median");
    }

    #[test]
    fn what_cannot_be_drawn_is_said() {
        assert!(family_figure(&grid(), &request("angle", "lift", None)).unwrap_err().contains("`lift`"));
        assert!(family_figure(&grid(), &request("angle", "tip", None)).unwrap_err().contains("words"));
    }
}
