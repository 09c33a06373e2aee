//! The data of a figure as CSV text, in the units of the table.

use super::content::{Figure, FigureAxis, FigurePoint};
use input::printed::text_cell;

/// Names of the columns of an axis: value, low and high end of its interval.
fn headers(axis: &FigureAxis) -> [String; 3] {
    let unit = if axis.unit.is_empty() { String::new() } else { format!(" [{}]", axis.unit) };
    ["", "_low", "_high"].map(|end| format!("{}{end}{unit}", axis.name))
}

/// A line for every point: kind, level and source of its series, values with their intervals, grade.
pub(super) fn csv(figure: &Figure) -> String {
    let mut text = "kind,level,source".to_owned();
    for header in headers(&figure.x).into_iter().chain(headers(&figure.y)) {
        text.push(',');
        text.push_str(&text_cell(&header));
    }
    text.push_str(",grade\n");
    for series in &figure.series {
        let start = [series.kind.word().to_owned(), text_cell(&series.level), text_cell(&series.source)];
        for point in &series.points {
            let cells = start.iter().cloned().chain(cells(figure, point)).chain([text_cell(&point.grade)]);
            text.push_str(&cells.collect::<Vec<_>>().join(","));
            text.push('\n');
        }
    }
    text
}

fn cells(figure: &Figure, point: &FigurePoint) -> impl Iterator<Item = String> {
    let of = |axis: &FigureAxis, value: f64, ends: Option<[f64; 2]>| {
        let value = match axis.words.get(value.round().max(0.0) as usize) {
            Some(word) => text_cell(word),
            None => number(value),
        };
        let [low, high] = ends.map_or_else(Default::default, |ends| ends.map(number));
        [value, low, high]
    };
    let x = of(&figure.x, point.at[0], point.x_ends);
    let y = of(&figure.y, point.at[1], point.y_ends);
    x.into_iter().chain(y)
}

/// A number in the fewest digits that bring it back; nothing for what is none.
fn number(value: f64) -> String {
    let size = value.abs();
    if !value.is_finite() {
        String::new()
    } else if size == 0.0 || (1e-5..1e16).contains(&size) {
        format!("{}", value + 0.0)
    } else {
        format!("{value:e}")
    }
}
