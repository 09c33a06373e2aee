//! How well all points fall onto one curve: a response over a dimensionless group, and the scatter about a
//! running median.

use super::classes::classes;
use super::label::{axis_label, class_name, plain_label};
use super::named::{NamedChart, file_name};
use super::request::ChartRequest;
use crate::statistics::collapse::{Collapse, collapse};
use crate::table::Table;
use coulter::output::digits;
use coulter::output::plots::{Chart, Curve, Stroke};

/// Dots of all points, coloured by the classes of the family where there is one, and their running median.
///
/// # Errors
/// A sentence that says which column is missing or holds no numbers, or that there are too few points.
pub fn collapse_chart(table: &Table, request: &ChartRequest) -> Result<NamedChart, String> {
    let find = |name: &str| table.column(name).ok_or(format!("there is no column `{name}`"));
    let numbers = |name: &str| table.numbers(name).ok_or(format!("the column `{name}` holds words"));
    let (x, y) = (find(&request.x)?, find(&request.y)?);
    let (xs, ys) = (numbers(&request.x)?, numbers(&request.y)?);
    let family = request.family.as_deref().map(find).transpose()?;
    let all: Vec<usize> = (0..table.rows()).collect();
    let both = |rows: &[usize]| {
        rows.iter().filter_map(|row| Some([xs[*row]?, ys[*row]?])).collect::<Vec<[f64; 2]>>()
    };
    let found = collapse(&both(&all)).map_err(|error| error.to_string())?;
    let scatter = scatter(&found);
    let mut curves = Vec::new();
    match family {
        None => {
            curves.push(Curve { name: String::new(), points: both(&all), colour: 0, stroke: Stroke::Dots })
        }
        Some(column) => {
            for (colour, class) in classes(column, &all).iter().enumerate() {
                let (name, stroke) = (class_name(column, &class.label), Stroke::Marks(colour));
                curves.push(Curve { name, points: both(&class.rows), colour, stroke });
            }
        }
    }
    let median =
        Curve { name: "running median".into(), points: found.median, colour: 6, stroke: Stroke::Dashed };
    curves.push(median);
    let title = format!("{} over {}", plain_label(y), plain_label(x));
    let chart = Chart {
        title: title.clone(),
        x_label: axis_label(x),
        y_label: axis_label(y),
        height: 360.0,
        logarithmic: request.logarithmic,
        logarithmic_x: request.logarithmic_x,
        curves,
        ..Chart::default()
    };
    let colours =
        family.map(|column| format!(" Colours and marks: {}.", plain_label(column))).unwrap_or_default();
    let caption = format!("{title}{scatter}{colours}");
    let name = match request.name.as_str() {
        "" => file_name(&["collapse", &y.name, &x.name, family.map_or("", |column| &column.name)]),
        given => file_name(&[given]),
    };
    Ok(NamedChart { name, title, caption, svg: chart.svg() })
}

/// How far the points lie from their running median, in words behind a title.
pub(super) fn scatter(found: &Collapse) -> String {
    format!(
        ", all {} points. Half of them lie within {} % of the running median, nine in ten within {} %.",
        found.points,
        digits(100.0 * found.half_within),
        digits(100.0 * found.most_within)
    )
}

#[cfg(test)]
mod tests {
    use super::super::samples::grid;
    use super::*;

    #[test]
    fn the_scatter_is_stated() {
        let request = ChartRequest {
            x: "angle".into(),
            y: "drag".into(),
            family: Some("depth".into()),
            ..ChartRequest::default()
        };
        let chart = collapse_chart(&grid(), &request).unwrap();
        assert!(
            chart.caption.contains("all 39 points") && chart.caption.contains("nine in ten"),
            "{}",
            chart.caption
        );
        assert!(chart.svg.contains("0.2 m") && chart.svg.contains("running median"));
        assert!(
            collapse_chart(&grid(), &ChartRequest { x: "tip".into(), ..request })
                .unwrap_err()
                .contains("words")
        );
    }
}
