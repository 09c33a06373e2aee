//! Families of curves: a response over a factor or over another response, a curve for each level of a second
//! factor and each model.

use super::classes::{Class, MOST_CLASSES, classes, models};
use super::label::{axis_label, class_name, plain_label, value_text};
use super::named::{NamedChart, file_name};
use crate::table::{Column, Role, Table, Values};
use coulter::output::plots::{Bar, BarGroup, Bars, Chart, Curve, Stroke};

/// Levels of the x axis up to which points are joined through their means where other factors vary, too
/// (chosen).
const MOST_LEVELS: usize = 12;

/// A chart that a study asks for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChartRequest {
    /// Name of its file; made from the columns where it is empty.
    pub name: String,
    /// Name of the column of the x axis, of numbers or of words.
    pub x: String,
    /// Name of the column of the y axis, of numbers.
    pub y: String,
    /// Name of the column whose levels, or ranges where it has many, have a curve each.
    pub family: Option<String>,
    /// Whether both axes are logarithmic.
    pub logarithmic: bool,
    /// Whether the x axis alone is logarithmic.
    pub logarithmic_x: bool,
    /// Whether to say how well all points fall onto one curve: dots, and their scatter about a running
    /// median.
    pub collapse: bool,
}

/// The points of one curve.
struct Series {
    name: String,
    /// Numbers of its class and its model.
    class: usize,
    model: usize,
    points: Vec<[f64; 2]>,
}

/// The chart of a request.
///
/// # Errors
/// A sentence that says which column is missing or holds no numbers, or that no row has both values.
pub fn family_chart(table: &Table, request: &ChartRequest) -> Result<NamedChart, String> {
    let find = |name: &str| table.column(name).ok_or(format!("there is no column `{name}`"));
    let (x, y) = (find(&request.x)?, find(&request.y)?);
    let family = request.family.as_deref().map(find).transpose()?;
    let Values::Numbers(ys) = &y.values else { return Err(format!("the column `{}` holds words", y.name)) };
    let title = title(x, y, family);
    let varied = others(table, &[Some(x), family]);
    let joined = are_curves(x, family, varied.len());
    let made = match &x.values {
        Values::Words(_) => bars(table, x, y, family, &title),
        Values::Numbers(xs) => curves(table, (x, xs), (y, ys), (family, joined), request),
    };
    let svg = made.ok_or(format!("no row has both `{}` and `{}`", x.name, y.name))?;
    let name = match request.name.as_str() {
        "" => file_name(&[&y.name, "over", &x.name, family.map_or("", |column| &column.name)]),
        given => file_name(&[given]),
    };
    let means = if joined { ": lines run through the means" } else { "" };
    let caption = if varied.is_empty() {
        format!("{title}.")
    } else if joined && x.role != Role::Factor {
        format!("{title}. Along each curve {} varies.", varied.join(", "))
    } else {
        format!("{title}. Other factors vary, too ({}){means}.", varied.join(", "))
    };
    Ok(NamedChart { name, title, caption, svg })
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

fn curves(
    table: &Table,
    (x, xs): (&Column, &[Option<f64>]),
    (y, ys): (&Column, &[Option<f64>]),
    (family, joined): (Option<&Column>, bool),
    request: &ChartRequest,
) -> Option<String> {
    let (by_family, by_model) = groups(table, family);
    let several = by_model.len() > 1;
    let mut list = Vec::new();
    for (class, members) in by_family.iter().enumerate() {
        for (model, rows) in by_model.iter().enumerate() {
            let both = members.rows.iter().filter(|row| rows.rows.binary_search(row).is_ok());
            let mut points: Vec<[f64; 2]> = both.filter_map(|row| Some([xs[*row]?, ys[*row]?])).collect();
            points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
            if !points.is_empty() {
                list.push(Series {
                    name: series_name(family, members, several.then_some(rows)),
                    class,
                    model,
                    points,
                });
            }
        }
    }
    let mut drawn = Vec::new();
    for (n, series) in list.iter().enumerate() {
        drawn.extend(strokes(series, n, joined, family.is_some()));
    }
    let chart = Chart {
        title: title(x, y, family),
        x_label: axis_label(x),
        y_label: axis_label(y),
        height: 360.0,
        logarithmic: request.logarithmic,
        logarithmic_x: request.logarithmic_x,
        curves: drawn,
        ..Chart::default()
    };
    (!list.is_empty()).then(|| chart.svg())
}

/// The class of the family and the model: `φ = 30 deg, solver`.
fn series_name(family: Option<&Column>, class: &Class, model: Option<&Class>) -> String {
    let class = family.map(|column| class_name(column, &class.label));
    let model = model.map(|model| model.label.replace('_', " "));
    class.into_iter().chain(model).collect::<Vec<_>>().join(", ")
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

/// What is drawn of a series: a line through the means at each place with dots, or dots alone.
fn strokes(series: &Series, number: usize, joined: bool, has_family: bool) -> Vec<Curve> {
    if !joined {
        let (name, points) = (series.name.clone(), series.points.clone());
        return vec![Curve { name, points, colour: number, stroke: Stroke::Marks(number) }];
    }
    // Colour and marks tell the levels apart, dashes the models; without levels all three are free for the
    // models.
    let (colour, stroke) = if has_family {
        (series.class, Stroke::Marked { dash: series.model, mark: series.class })
    } else {
        (series.model, Stroke::Marked { dash: series.model, mark: series.model })
    };
    let mean = |part: &[[f64; 2]]| [part[0][0], part.iter().map(|p| p[1]).sum::<f64>() / part.len() as f64];
    let means: Vec<[f64; 2]> = series.points.chunk_by(|a, b| a[0] == b[0]).map(mean).collect();
    let mut drawn = Vec::new();
    if means.len() < series.points.len() {
        drawn.push(Curve {
            name: String::new(),
            points: series.points.clone(),
            colour,
            stroke: Stroke::Dots,
        });
    }
    drawn.push(Curve { name: series.name.clone(), points: means, colour, stroke });
    drawn
}

/// A group of bars for each word of the x axis, a bar of the mean for each class and model.
fn bars(table: &Table, x: &Column, y: &Column, family: Option<&Column>, title: &str) -> Option<String> {
    let Values::Numbers(ys) = &y.values else { return None };
    let (by_family, by_model) = groups(table, family);
    let all: Vec<usize> = (0..table.rows()).collect();
    let (mut names, mut groups) = (Vec::new(), Vec::new());
    for place in classes(x, &all) {
        let mut bars = Vec::new();
        for (class, members) in by_family.iter().enumerate() {
            for (model, rows) in by_model.iter().enumerate() {
                let inside =
                    |row: &&usize| [members, rows].iter().all(|of| of.rows.binary_search(row).is_ok());
                let values: Vec<f64> = place.rows.iter().filter(inside).filter_map(|row| ys[*row]).collect();
                if values.is_empty() {
                    continue;
                }
                let colour = class * by_model.len() + model;
                let name = series_name(family, members, (by_model.len() > 1).then_some(rows));
                if !name.is_empty() && !names.contains(&(name.clone(), colour)) {
                    names.push((name, colour));
                }
                bars.push(Bar {
                    value: values.iter().sum::<f64>() / values.len() as f64,
                    colour,
                    ..Bar::default()
                });
            }
        }
        let label =
            place.rows.first().and_then(|row| value_text(x, *row)).unwrap_or_default().replace('_', " ");
        groups.push(BarGroup { label, bars });
    }
    let filled = groups.iter().any(|group| !group.bars.is_empty());
    let chart = Bars { title: title.to_owned(), x_label: axis_label(y), names, groups, ..Bars::default() };
    filled.then(|| chart.svg())
}

#[cfg(test)]
mod tests {
    use super::super::samples::{column, grid};
    use super::*;
    use crate::statistics::design::latin_hypercube;

    fn request(x: &str, y: &str, family: Option<&str>) -> ChartRequest {
        ChartRequest {
            x: x.into(),
            y: y.into(),
            family: family.map(str::to_owned),
            ..ChartRequest::default()
        }
    }

    #[test]
    fn a_grid_gives_a_curve_for_each_level_and_model() {
        let chart = family_chart(&grid(), &request("angle", "drag", Some("depth"))).unwrap();
        assert_eq!(chart.name, "drag_over_angle_depth");
        assert!(
            chart.svg.contains(">depth = 0.1 m, solver<")
                && chart.svg.contains(">depth = 0.2 m, plain model<"),
            "{}",
            chart.svg
        );
        assert!(chart.svg.contains("stroke-dasharray") && chart.svg.contains("[deg]"));
        assert!(chart.caption.contains("tip"), "{}", chart.caption);
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
        let chart = family_chart(&Table { columns }, &request("a", "drag", Some("b"))).unwrap();
        // The points, of which those of the first range are dots, and those of the legend.
        assert_eq!(
            [chart.svg.matches("h0").count(), chart.svg.matches("class=\"mark\"").count()],
            [40, 32 + 5]
        );
        assert!(!chart.svg.contains("stroke-linejoin"), "{}", chart.svg);
    }

    #[test]
    fn models_that_are_the_family_are_named_once() {
        let chart = family_chart(&grid(), &request("angle", "drag", Some("model"))).unwrap();
        assert!(chart.svg.contains(">solver<") && chart.svg.contains(">plain model<"), "{}", chart.svg);
    }

    #[test]
    fn no_two_series_are_alike_without_colour() {
        let chart = family_chart(&grid(), &request("angle", "drag", Some("depth"))).unwrap();
        fn value<'a>(line: &'a str, name: &str) -> Option<&'a str> {
            line.split(name).nth(1)?.split('"').nth(1)
        }
        // The model by its dashes, the level by its marks, which follow the line.
        let lines: Vec<&str> = chart.svg.lines().collect();
        let looks: std::collections::BTreeSet<[&str; 2]> = lines
            .windows(2)
            .filter(|pair| pair[0].contains("data-name=\"depth ="))
            .map(|pair| [value(pair[0], "dasharray="), value(pair[1], " d=")].map(Option::unwrap_or_default))
            .collect();
        assert_eq!(looks.len(), 4, "{looks:?}");
    }

    #[test]
    fn words_on_the_axis_give_bars() {
        let chart = family_chart(&grid(), &request("tip", "drag", None)).unwrap();
        assert!(chart.svg.contains("blunt") && chart.svg.contains("<rect"));
    }

    #[test]
    fn what_cannot_be_drawn_is_said() {
        assert!(family_chart(&grid(), &request("angle", "lift", None)).unwrap_err().contains("`lift`"));
        assert!(family_chart(&grid(), &request("angle", "tip", None)).unwrap_err().contains("words"));
    }
}
