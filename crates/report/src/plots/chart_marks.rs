//! What is drawn inside the axes of a chart: curves, levels, text with subscripts.

use super::colour::CURVES;
use super::curve::{Curve, DASHES, Level, MARKS, Stroke};
use std::fmt::Write as _;

/// Points of a drawn curve at most; more would not be visible.
const MAX_POINTS: usize = 1600;
/// Width of a chart [pixels], and the margins round its axes.
pub(super) const WIDTH: f64 = 560.0;
pub(super) const LEFT: f64 = 66.0;
pub(super) const RIGHT: f64 = 16.0;
pub(super) const BOTTOM: f64 = 46.0;

/// Position and range of the axes in the picture.
pub(super) struct Axes {
    pub(super) x: [f64; 2],
    pub(super) y: [f64; 2],
    pub(super) top: f64,
    pub(super) bottom: f64,
    pub(super) y_down: bool,
}

impl Axes {
    pub(super) fn x_at(&self, x: f64) -> f64 {
        LEFT + (WIDTH - LEFT - RIGHT) * (x - self.x[0]) / (self.x[1] - self.x[0])
    }

    pub(super) fn y_at(&self, y: f64) -> f64 {
        let fraction = (y - self.y[0]) / (self.y[1] - self.y[0]);
        let up = if self.y_down { 1.0 - fraction } else { fraction };
        self.bottom - (self.bottom - self.top) * up
    }
}

pub(super) fn colour(number: usize) -> &'static str {
    CURVES[number % CURVES.len()]
}

/// Patterns of dashes; the first is solid.
const PATTERNS: [&str; DASHES] =
    ["", "6 4", "1.5 2.5", "10 3 2 3", "14 4", "10 3 2 3 2 3", "4 2", "14 3 4 3"];
/// Shapes of marks about their middle, and whether they are filled; the first is a dot.
const SHAPES: [(&str, bool); MARKS] = [
    ("M-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0z", true),
    ("M-2.9-2.9h5.8v5.8h-5.8z", true),
    ("M0-3.9L3.6 2.7H-3.6z", true),
    ("M0-4.2L3.6 0L0 4.2L-3.6 0z", false),
    ("M-3-3L3 3M3-3L-3 3", false),
    ("M-2.9-2.9h5.8v5.8h-5.8z", false),
    ("M0 3.9L3.6-2.7H-3.6z", false),
    ("M-4 0H4M0-4V4", false),
];
/// Marks along a line at most (chosen): more would hide its dashes.
const MOST_MARKS: usize = 12;

fn pen(curve: &Curve) -> String {
    let (width, more) = match curve.stroke {
        Stroke::Faint => (0.8, " stroke-opacity=\"0.45\""),
        _ => (2.0, ""),
    };
    let dashes = match PATTERNS[curve.stroke.look().0.unwrap_or(0)] {
        "" => String::new(),
        pattern => format!(" stroke-dasharray=\"{pattern}\""),
    };
    format!("stroke=\"{}\" stroke-width=\"{width}\"{dashes}{more}", colour(curve.colour))
}

/// A mark at a place of the picture. The script of a page keeps its size when it stretches the curves.
fn mark(number: usize, colour: &str, x: f64, y: f64) -> String {
    let (shape, is_filled) = SHAPES[number % MARKS];
    let fill = if is_filled { colour } else { "none" };
    format!(
        "<path class=\"mark\" transform=\"translate({x:.2} {y:.2})\" d=\"{shape}\" fill=\"{fill}\" stroke=\"{colour}\" \
         stroke-width=\"1.4\"/>"
    )
}

pub(super) fn key(curve: &Curve, x: f64, y: f64) -> String {
    let line = format!("<path d=\"M{x:.1} {y:.1}h18\" {}/>", pen(curve));
    let shape = |number: usize| mark(number, colour(curve.colour), x + 9.0, y);
    match curve.stroke {
        Stroke::Dots => {
            format!("<circle cx=\"{:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{}\"/>", x + 9.0, colour(curve.colour))
        }
        Stroke::Marks(number) => shape(number),
        Stroke::Marked { mark, .. } => line + &shape(mark),
        _ => line,
    }
}

pub(super) fn draw_curve(svg: &mut String, axes: &Axes, curve: &Curve) {
    let is_dots = matches!(curve.stroke, Stroke::Dots | Stroke::Marks(_));
    let mut path = String::new();
    let mut pen_up = true;
    let points = thinned(&curve.points);
    for [x, y] in points.iter().copied() {
        if x.is_finite() && y.is_finite() {
            let (begin, end) = if is_dots { ('M', "h0") } else { (if pen_up { 'M' } else { 'L' }, "") };
            let _ = write!(path, "{begin}{:.2} {:.2}{end}", axes.x_at(x), axes.y_at(y));
            pen_up = false;
        } else {
            pen_up = true;
        }
    }
    if path.is_empty() {
        return;
    }
    // A dot is the round end of a line without length: it stays round however the page stretches its curves.
    let pen = if is_dots {
        // Below other marks it is what the script of a page finds values at.
        let width =
            if matches!(curve.stroke, Stroke::Marks(number) if number % MARKS != 0) { 0.0 } else { 5.0 };
        format!("stroke=\"{}\" stroke-width=\"{width}\" stroke-linecap=\"round\"", colour(curve.colour))
    } else {
        format!("stroke-linejoin=\"round\" {}", pen(curve))
    };
    let name = escaped(&curve.name);
    let _ = writeln!(svg, "<path d=\"{path}\" fill=\"none\" data-name=\"{name}\" {pen}/>");
    let (number, every) = match curve.stroke {
        Stroke::Marks(number) if !number.is_multiple_of(MARKS) => (number, 1),
        Stroke::Marked { mark, .. } => (mark, points.len().div_ceil(MOST_MARKS)),
        _ => return,
    };
    for [x, y] in points.iter().step_by(every).filter(|p| p.iter().all(|x| x.is_finite())) {
        let _ = writeln!(svg, "{}", mark(number, colour(curve.colour), axes.x_at(*x), axes.y_at(*y)));
    }
}

pub(super) fn draw_level(svg: &mut String, axes: &Axes, level: &Level) {
    if ![level.value, level.from, level.to].iter().all(|v| v.is_finite()) {
        return;
    }
    let (a, b, y) = (axes.x_at(level.from), axes.x_at(level.to), axes.y_at(level.value));
    let (low, high) = (a.min(b), a.max(b));
    // At its end, unless the label would then begin before the axis.
    let is_wide = 6.2 * plain(&level.label).chars().count() as f64 > high - LEFT - 8.0;
    let (x, anchor) = if is_wide { (low + 4.0, "start") } else { (high - 4.0, "end") };
    let _ = writeln!(
        svg,
        "<g class=\"level\"><path d=\"M{a:.1} {y:.1}H{b:.1}\" stroke=\"{0}\" stroke-width=\"1.4\" stroke-dasharray=\"2 3\"/>\
         <text x=\"{x:.1}\" y=\"{1:.1}\" text-anchor=\"{anchor}\" font-size=\"11\" fill=\"{0}\" stroke=\"var(--page, #fff)\" \
         stroke-width=\"3.5\" paint-order=\"stroke\" stroke-linejoin=\"round\">{2}</text></g>",
        colour(level.colour),
        y - 8.0,
        marked(&level.label)
    );
}

/// At most about [`MAX_POINTS`] points that preserve every peak: of each group of neighbours the first, the
/// lowest and the highest. Gaps remain gaps.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() <= MAX_POINTS {
        return points.to_vec();
    }
    let size = (4 * points.len()).div_ceil(MAX_POINTS);
    let mut kept = Vec::new();
    for (n, group) in points.chunks(size).enumerate() {
        let by_height = |&a: &usize, &b: &usize| group[a][1].total_cmp(&group[b][1]);
        let finite = || (0..group.len()).filter(|&m| group[m][1].is_finite());
        let mut indices = vec![0];
        indices.extend(finite().min_by(by_height));
        indices.extend(finite().max_by(by_height));
        indices.extend((0..group.len()).find(|&m| !group[m][1].is_finite()));
        if (n + 1) * size >= points.len() {
            indices.push(group.len() - 1);
        }
        indices.sort_unstable();
        indices.dedup();
        kept.extend(indices.into_iter().map(|m| group[m]));
    }
    kept
}

/// Text with the reserved characters of XML escaped.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

pub(super) fn plain(text: &str) -> String {
    escaped(&text.replace('_', ""))
}

/// Text with subscripts: letters and digits after `_` are lowered.
pub(super) fn marked(text: &str) -> String {
    let mut result = String::new();
    let mut pieces = text.split('_');
    result.push_str(&escaped(pieces.next().unwrap_or_default()));
    for piece in pieces {
        let end = piece.find(|c: char| !c.is_alphanumeric()).unwrap_or(piece.len());
        let (low, rest) = piece.split_at(end);
        let _ = write!(result, "<tspan dy=\"3\" font-size=\"75%\">{}</tspan>", escaped(low));
        if !rest.is_empty() {
            let _ = write!(result, "<tspan dy=\"-3\">{}</tspan>", escaped(rest));
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_series_are_thinned_and_keep_their_peak() {
        let mut points: Vec<[f64; 2]> =
            (0..50_000).map(|n| [f64::from(n), (f64::from(n) * 0.7).sin()]).collect();
        points[31_234][1] = 9.0;
        let few = thinned(&points);
        assert!(few.len() <= MAX_POINTS + 4, "{}", few.len());
        assert!(few.contains(&[31_234.0, 9.0]));
        assert_eq!(few.last(), points.last());
    }

    #[test]
    fn subscripts_are_lowered() {
        assert_eq!(
            marked("F_H [N]"),
            "F<tspan dy=\"3\" font-size=\"75%\">H</tspan><tspan dy=\"-3\"> [N]</tspan>"
        );
    }
}
