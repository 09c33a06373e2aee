//! How series differ: marks, dashes and colours, so that they are told apart without colour, too.

use super::content::{Figure, FigureSeries, SeriesKind};
use super::drawing::{Colour, Drawing, Pen};
use super::segment::Segment;
use crate::plots::CURVES;

/// Dashes and gaps over the width of the line; the first is solid.
const DASHES: [&[f64]; 8] = [
    &[],
    &[5.0, 2.5],
    &[1.2, 1.8],
    &[7.0, 2.0, 1.2, 2.0],
    &[10.0, 3.0],
    &[7.0, 2.0, 1.2, 2.0, 1.2, 2.0],
    &[2.5, 1.5],
    &[10.0, 2.0, 3.0, 2.0],
];
/// Marks of computed points, by their corners; the first is a circle.
const COMPUTED: usize = 8;
/// Marks of measurements.
const MEASURED: usize = 4;

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Look {
    pub(super) colour: Colour,
    /// Number of the dashes of a line; `None` without a line.
    pub(super) dash: Option<usize>,
    /// Mark of the series; `None` for a line alone.
    pub(super) mark: Option<Mark>,
    /// Whether the line is drawn at twice the width, where the dashes repeat.
    pub(super) is_bold: bool,
}

/// A mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Mark {
    /// A mark of a computed point: circle, square, triangle, …
    Computed(usize),
    /// A mark of a measurement: plus, cross, star, fork.
    Measured(usize),
    /// A small mark of the same shapes: of a closed form at points without an order.
    Dot(usize),
}

impl Look {
    /// The pen of the line, at the width of lines of the figure [pt].
    pub(super) fn pen(&self, width: f64) -> Pen {
        let width = if self.is_bold { 2.0 * width } else { width };
        let pattern = dashes(self.dash.unwrap_or(0));
        Pen { colour: self.colour, width, dashes: pattern.iter().map(|length| length * width).collect() }
    }
}

/// Dashes and gaps of a number of them, over the width of the line.
pub(super) fn dashes(number: usize) -> &'static [f64] {
    DASHES[number % DASHES.len()]
}

/// Names that occur in some series, in their order.
pub(super) fn names<'a>(of: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for name in of {
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}

/// The looks of all series of a figure.
pub(super) fn looks(figure: &Figure) -> Vec<Look> {
    let of_models = || figure.series.iter().filter(|series| series.kind != SeriesKind::Measured);
    let levels = names(of_models().map(|series| series.level.as_str()));
    // Each pair of level and source that a kind has is a look of its own; where there is one source, that is
    // the level.
    let number = |series: &FigureSeries| {
        let same = || figure.series.iter().filter(|other| other.kind == series.kind);
        if names(same().map(|other| other.source.as_str())).len() < 2 {
            let own = names(same().map(|other| other.level.as_str()));
            return own.iter().position(|level| *level == series.level).unwrap_or(0);
        }
        let mut pairs: Vec<[&str; 2]> = Vec::new();
        for other in same() {
            if !pairs.contains(&[&other.level, &other.source]) {
                pairs.push([&other.level, &other.source]);
            }
        }
        pairs.iter().position(|pair| *pair == [&series.level, &series.source]).unwrap_or(0)
    };
    let one = |series: &FigureSeries| {
        let number = number(series);
        let place = levels.iter().position(|level| *level == series.level).unwrap_or(0);
        let colour = match series.kind {
            SeriesKind::Measured => [0; 3],
            _ if !figure.style.is_coloured => [0; 3],
            // What has no level beside what has one is of all of them.
            _ if levels.len() > 1 && series.level.is_empty() => [0; 3],
            _ => rgb(CURVES[if levels.len() > 1 { place } else { number } % CURVES.len()]),
        };
        let is_line = series.kind == SeriesKind::Line;
        Look {
            colour,
            dash: is_line.then_some(number % DASHES.len()),
            mark: match series.kind {
                SeriesKind::Line => None,
                SeriesKind::Dots => Some(Mark::Dot(number % COMPUTED)),
                SeriesKind::Computed => Some(Mark::Computed(number % COMPUTED)),
                SeriesKind::Measured => Some(Mark::Measured(number % MEASURED)),
            },
            is_bold: is_line && (number / DASHES.len()) % 2 == 1,
        }
    };
    figure.series.iter().map(one).collect()
}

/// A colour of the palette of all charts.
fn rgb(text: &str) -> Colour {
    let channel = |at: usize| text.get(at..at + 2).and_then(|two| u8::from_str_radix(two, 16).ok());
    [1, 3, 5].map(|at| channel(at).unwrap_or(0))
}

/// Draws a mark about a place, of a size [pt]; hollow, or filled with its colour.
pub(super) fn draw_mark(drawing: &mut Drawing, look: &Look, at: [f64; 2], size: f64, is_hollow: bool) {
    let pen = Pen { colour: look.colour, width: 0.18 * size, dashes: Vec::new() };
    match look.mark {
        None => {}
        Some(Mark::Dot(number)) => {
            drawing.path("dot", outline(number, at, 0.25 * size), None, Some(look.colour));
        }
        Some(Mark::Computed(number)) => {
            let fill = if is_hollow { [255; 3] } else { look.colour };
            drawing.path("mark", outline(number, at, 0.5 * size), Some(pen), Some(fill));
        }
        Some(Mark::Measured(number)) => {
            drawing.path("cross", strokes(number, at, 0.6 * size), Some(pen), None);
        }
    }
}

/// Draws white below the mark of a measurement, so that it is seen on a filled mark, too.
pub(super) fn draw_halo(drawing: &mut Drawing, look: &Look, at: [f64; 2], size: f64) {
    if let Some(Mark::Measured(number)) = look.mark {
        let pen = Pen { colour: [255; 3], width: 0.45 * size, dashes: Vec::new() };
        drawing.path("halo", strokes(number, at, 0.6 * size), Some(pen), None);
    }
}

fn circle([x, y]: [f64; 2], r: f64) -> Vec<Segment> {
    // Control points of a quarter of a circle.
    let k = 0.552_285 * r;
    vec![
        Segment::Move([x + r, y]),
        Segment::Curve([[x + r, y + k], [x + k, y + r], [x, y + r]]),
        Segment::Curve([[x - k, y + r], [x - r, y + k], [x - r, y]]),
        Segment::Curve([[x - r, y - k], [x - k, y - r], [x, y - r]]),
        Segment::Curve([[x + k, y - r], [x + r, y - k], [x + r, y]]),
        Segment::Close,
    ]
}

/// Outline of the mark of a computed point: all have about the same area.
fn outline(number: usize, at: [f64; 2], r: f64) -> Vec<Segment> {
    /// Corners, angle of the first one from the right [quarter turns, anticlockwise], radius over that of the
    /// circle.
    const POLYGONS: [(usize, f64, f64); COMPUTED - 1] = [
        (4, 0.5, 1.25),
        (3, 1.0, 1.4),
        (4, 0.0, 1.3),
        (3, 3.0, 1.4),
        (5, 1.0, 1.15),
        (3, 2.0, 1.4),
        (3, 0.0, 1.4),
    ];
    let Some((corners, start, size)) = number.checked_sub(1).and_then(|n| POLYGONS.get(n)) else {
        return circle(at, r);
    };
    let corner = |n: usize| {
        let angle = std::f64::consts::FRAC_PI_2 * (start + 4.0 * n as f64 / *corners as f64);
        [at[0] + size * r * angle.cos(), at[1] - size * r * angle.sin()]
    };
    let mut segments = vec![Segment::Move(corner(0))];
    segments.extend((1..*corners).map(|n| Segment::Line(corner(n))));
    segments.push(Segment::Close);
    segments
}

/// Strokes of the mark of a measurement.
fn strokes(number: usize, [x, y]: [f64; 2], r: f64) -> Vec<Segment> {
    let d = std::f64::consts::FRAC_1_SQRT_2 * r;
    let stroke = |from: [f64; 2], to: [f64; 2]| {
        [Segment::Move([x + from[0], y + from[1]]), Segment::Line([x + to[0], y + to[1]])]
    };
    let plus = [stroke([-r, 0.0], [r, 0.0]), stroke([0.0, -r], [0.0, r])];
    let cross = [stroke([-d, -d], [d, d]), stroke([-d, d], [d, -d])];
    match number {
        0 => plus.concat(),
        1 => cross.concat(),
        2 => [plus, cross].concat().concat(),
        _ => {
            [stroke([0.0, 0.0], [0.0, r]), stroke([0.0, 0.0], [-d, -d]), stroke([0.0, 0.0], [d, -d])].concat()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn no_two_series_are_alike_in_black() {
        let mut figure = Figure::default();
        figure.style.is_coloured = false;
        for level in 0..7 {
            for (kind, source) in [
                (SeriesKind::Computed, "solver"),
                (SeriesKind::Line, "one form"),
                (SeriesKind::Line, "another"),
            ] {
                let (level, source) = (format!("φ = {level} deg"), source.to_owned());
                figure.series.push(FigureSeries { kind, level, source, points: Vec::new() });
            }
        }
        for source in ["a", "b", "c"] {
            let (kind, level) = (SeriesKind::Measured, String::new());
            figure.series.push(FigureSeries { kind, level, source: source.into(), points: Vec::new() });
        }
        let looks: BTreeSet<Look> = looks(&figure).into_iter().collect();
        assert_eq!(looks.len(), figure.series.len());
        assert!(looks.iter().all(|look| look.colour == [0; 3]));
        let shapes: BTreeSet<String> =
            (0..COMPUTED).map(|n| format!("{:?}", outline(n, [0.0, 0.0], 3.0))).collect();
        let crosses: BTreeSet<String> =
            (0..MEASURED).map(|n| format!("{:?}", strokes(n, [0.0, 0.0], 3.0))).collect();
        assert_eq!([shapes.len(), crosses.len()], [COMPUTED, MEASURED]);
    }
}
