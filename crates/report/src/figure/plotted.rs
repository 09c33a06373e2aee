//! The series on the page: lines within the axes, error bars, marks.

use super::axes::Frame;
use super::content::{Figure, FigurePoint, FigureSeries, SeriesKind};
use super::drawing::{Drawing, Pen};
use super::look::{Look, draw_halo, draw_mark};
use super::segment::Segment;

/// Points of a line up to which their intervals are drawn, and how far beside them, over the size of a mark
/// (chosen).
const MOST_BARS: usize = 24;
const BESIDE: f64 = 0.55;
/// Distance on the page below which a point of a line shows nothing new [pt].
const VISIBLE: f64 = 0.12;

/// Draws all series into the axes: dots, lines, error bars, marks, so that none hides a mark.
pub(super) fn draw_series(drawing: &mut Drawing, figure: &Figure, frame: &Frame, looks: &[Look]) {
    let all = || figure.series.iter().zip(looks);
    let of = |kind: SeriesKind| all().filter(move |(series, _)| series.kind == kind);
    for (series, look) in of(SeriesKind::Dots) {
        draw_marks(drawing, figure, frame, series, look);
    }
    for (number, (series, look)) in of(SeriesKind::Line).enumerate() {
        for part in lines(figure, frame, series) {
            let mut segments = vec![Segment::Move(part[0])];
            segments.extend(part[1..].iter().map(|at| Segment::Line(*at)));
            drawing.path("curve", segments, Some(look.pen(figure.style.line_width)), None);
        }
        draw_points_of_a_line(drawing, figure, frame, number, series, look);
    }
    for kind in [SeriesKind::Dots, SeriesKind::Computed, SeriesKind::Measured] {
        for (series, look) in of(kind) {
            for (at, _) in places(figure, frame, series) {
                draw_halo(drawing, look, at, figure.style.mark_size);
            }
            let pen = Pen { colour: look.colour, width: 0.7 * figure.style.line_width, dashes: Vec::new() };
            for bar in series.points.iter().flat_map(|point| bars(figure, frame, point)) {
                draw_bar(drawing, bar, 0.3 * figure.style.mark_size, &pen);
            }
        }
        if kind != SeriesKind::Dots {
            of(kind).for_each(|(series, look)| draw_marks(drawing, figure, frame, series, look));
        }
    }
}

/// Draws what a line does not show: a point that is alone, as a short dash, and the intervals of few points,
/// without caps and beside those of the marks and of lines before it that stand at the same place.
fn draw_points_of_a_line(
    drawing: &mut Drawing,
    figure: &Figure,
    frame: &Frame,
    number: usize,
    series: &FigureSeries,
    look: &Look,
) {
    let pen =
        |part: f64| Pen { colour: look.colour, width: part * figure.style.line_width, dashes: Vec::new() };
    let size = figure.style.mark_size;
    if let [alone] = series.points.as_slice()
        && let Some([x, y]) = frame.at(figure, alone.at).filter(|at| frame.contains(*at))
    {
        let dash = vec![Segment::Move([x - size, y]), Segment::Line([x + size, y])];
        drawing.path("curve", dash, Some(look.pen(figure.style.line_width)), None);
    }
    if series.points.len() > MOST_BARS {
        return;
    }
    let [left, _, right, _] = frame.rectangle;
    let beside = BESIDE * (number + 1) as f64 * size;
    for [from, to] in series.points.iter().flat_map(|point| bars(figure, frame, point)) {
        let aside = if from[0] + beside > right { -beside } else { beside };
        let moved = |[x, y]: [f64; 2]| [(x + aside).clamp(left, right), y];
        let bar = vec![Segment::Move(moved(from)), Segment::Line(moved(to))];
        drawing.path("error", bar, Some(pen(0.6)), None);
    }
}

fn draw_marks(drawing: &mut Drawing, figure: &Figure, frame: &Frame, series: &FigureSeries, look: &Look) {
    for (at, is_hollow) in places(figure, frame, series) {
        draw_mark(drawing, look, at, figure.style.mark_size, is_hollow);
    }
}

/// Where the points of a series lie inside the axes, and whether each is doubtful.
fn places(figure: &Figure, frame: &Frame, series: &FigureSeries) -> Vec<([f64; 2], bool)> {
    let place = |point: &FigurePoint| {
        let at = frame.at(figure, point.at).filter(|at| frame.contains(*at))?;
        Some((at, point.is_doubtful()))
    };
    series.points.iter().filter_map(place).collect()
}

/// Places on the page that a legend must not hide: no two neighbours on a line are farther apart than `step`
/// [pt].
pub(super) fn occupied(figure: &Figure, frame: &Frame, step: f64) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    let mut along = |from: [f64; 2], to: [f64; 2]| {
        let count = ((to[0] - from[0]).hypot(to[1] - from[1]) / step).ceil().max(1.0);
        found.extend((0..=count as usize).map(|n| {
            let part = n as f64 / count;
            [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]
        }));
    };
    for series in &figure.series {
        if series.kind == SeriesKind::Line {
            for part in lines(figure, frame, series) {
                part.windows(2).for_each(|pair| along(pair[0], pair[1]));
            }
        }
        if series.kind == SeriesKind::Line && series.points.len() > MOST_BARS {
            continue;
        }
        for point in &series.points {
            for [from, to] in bars(figure, frame, point) {
                along(from, to);
            }
        }
        places(figure, frame, series).into_iter().for_each(|(at, _)| along(at, at));
    }
    found
}

/// The lines of a series on the page, cut where they leave the axes and where a point has no place.
fn lines(figure: &Figure, frame: &Frame, series: &FigureSeries) -> Vec<Vec<[f64; 2]>> {
    let mut parts: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut last: Option<[f64; 2]> = None;
    let count = series.points.len();
    for (n, point) in series.points.iter().enumerate() {
        let Some(at) = frame.at(figure, point.at) else {
            last = None;
            continue;
        };
        if let Some(from) = last {
            let is_near = (at[0] - from[0]).abs() < VISIBLE && (at[1] - from[1]).abs() < VISIBLE;
            if is_near && n + 1 < count {
                continue;
            }
            if let Some([start, end]) = clipped([from, at], frame.rectangle) {
                match parts.last_mut() {
                    Some(part) if part.last() == Some(&start) => part.push(end),
                    _ => parts.push(vec![start, end]),
                }
            }
        }
        last = Some(at);
    }
    parts
}

/// The part of a straight line inside a rectangle: left, top, right, bottom.
fn clipped([from, to]: [[f64; 2]; 2], [left, top, right, bottom]: [f64; 4]) -> Option<[[f64; 2]; 2]> {
    let (mut start, mut end) = (0.0_f64, 1.0_f64);
    for (k, [low, high]) in [[left, right], [top, bottom]].into_iter().enumerate() {
        let way = to[k] - from[k];
        if way == 0.0 {
            if from[k] < low || from[k] > high {
                return None;
            }
            continue;
        }
        let [a, b] = [(low - from[k]) / way, (high - from[k]) / way];
        start = start.max(a.min(b));
        end = end.min(a.max(b));
    }
    let at = |part: f64| {
        if part <= 0.0 {
            from
        } else if part >= 1.0 {
            to
        } else {
            [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]
        }
    };
    (start <= end).then(|| [at(start), at(end)])
}

/// The error bars of a point on the page, as far as they are inside.
fn bars(figure: &Figure, frame: &Frame, point: &FigurePoint) -> Vec<[[f64; 2]; 2]> {
    let bar = |ends: [[f64; 2]; 2]| {
        let [from, to] = ends.map(|end| frame.at(figure, end));
        clipped([from?, to?], frame.rectangle)
    };
    let [x, y] = point.at;
    let along_x = point.x_ends.and_then(|[low, high]| bar([[low, y], [high, y]]));
    let along_y = point.y_ends.and_then(|[low, high]| bar([[x, low], [x, high]]));
    along_x.into_iter().chain(along_y).collect()
}

/// A bar with caps of a half-width [pt].
fn draw_bar(drawing: &mut Drawing, [from, to]: [[f64; 2]; 2], cap: f64, pen: &Pen) {
    let across = if from[0] == to[0] { [cap, 0.0] } else { [0.0, cap] };
    let mut segments = vec![Segment::Move(from), Segment::Line(to)];
    for end in [from, to] {
        segments.push(Segment::Move([end[0] - across[0], end[1] - across[1]]));
        segments.push(Segment::Line([end[0] + across[0], end[1] + across[1]]));
    }
    drawing.path("error", segments, Some(pen.clone()), None);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_at_the_axes() {
        let frame = [0.0, 0.0, 10.0, 10.0];
        assert_eq!(clipped([[-5.0, 5.0], [5.0, 5.0]], frame), Some([[0.0, 5.0], [5.0, 5.0]]));
        assert_eq!(clipped([[-5.0, 5.0], [5.0, 15.0]], frame), Some([[0.0, 10.0], [0.0, 10.0]]));
        assert_eq!(clipped([[-5.0, 6.0], [5.0, 17.0]], frame), None);
        assert_eq!(clipped([[11.0, 1.0], [11.0, 2.0]], frame), None);
        assert_eq!(clipped([[1.0, 1.0], [2.0, 2.0]], frame), Some([[1.0, 1.0], [2.0, 2.0]]));
    }
}
