//! Line charts as SVG text: one look for every plot of a report. Text and frame take the colour of the page around
//! them, so that a chart is at home on light and dark pages and on paper.

use super::colour::CURVES;
use super::scale::{padded_range, tick_label, ticks};
use std::fmt::Write as _;

/// A curve has at most so many points when drawn; more could not be seen.
const MOST_POINTS: usize = 1600;
const WIDTH: f64 = 560.0;
const LEFT: f64 = 66.0;
const RIGHT: f64 = 16.0;
const BOTTOM: f64 = 46.0;

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A strong line.
    Solid,
    /// A thin pale line: raw data behind a smoothed curve.
    Faint,
    /// A dashed line: a forecast or another source.
    Dashed,
    /// Dots: a measurement.
    Dots,
}

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name in the legend; nothing for no entry.
    pub name: String,
    /// Points; a gap where one is not a number.
    pub points: Vec<[f64; 2]>,
    /// Number of its colour.
    pub colour: usize,
    /// How it is drawn.
    pub stroke: Stroke,
}

/// A level with its name, drawn over a part of the x axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// What it says at its end.
    pub label: String,
    /// Height on the y axis.
    pub value: f64,
    /// Where it begins on the x axis.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Number of its colour.
    pub colour: usize,
}

/// A chart of curves over two linear axes. Labels may hold subscripts: `F_H`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// Title above it.
    pub title: String,
    /// Label of the x axis, with symbol and unit.
    pub x_label: String,
    /// Label of the y axis, with symbol and unit.
    pub y_label: String,
    /// Whether y grows downwards (depths).
    pub y_down: bool,
    /// Whether one unit is as long on both axes.
    pub true_scale: bool,
    /// Height of the picture in pixels; 0 for the usual one.
    pub height: f64,
    /// Whether y = 0 has to be in view.
    pub with_zero: bool,
    /// The curves, first below.
    pub curves: Vec<Curve>,
    /// Shaded part of the x axis.
    pub shaded: Option<[f64; 2]>,
    /// Levels.
    pub levels: Vec<Level>,
}

impl Curve {
    /// A strong line.
    #[must_use]
    pub fn solid(name: &str, colour: usize, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.to_owned(), points, colour, stroke: Stroke::Solid }
    }
}

/// Where the axes lie in the picture.
struct Frame {
    x: [f64; 2],
    y: [f64; 2],
    top: f64,
    bottom: f64,
    y_down: bool,
}

impl Frame {
    fn x_at(&self, x: f64) -> f64 {
        LEFT + (WIDTH - LEFT - RIGHT) * (x - self.x[0]) / (self.x[1] - self.x[0])
    }

    fn y_at(&self, y: f64) -> f64 {
        let share = (y - self.y[0]) / (self.y[1] - self.y[0]);
        let up = if self.y_down { 1.0 - share } else { share };
        self.bottom - (self.bottom - self.top) * up
    }
}

impl Chart {
    /// The chart as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        let height = if self.height > 0.0 { self.height } else { 330.0 };
        let legend = self.legend();
        let top = if self.title.is_empty() { 10.0 } else { 30.0 } + 18.0 * legend.len() as f64;
        let frame = self.frame(top, height - BOTTOM);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
             aria-label=\"{}\" font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif\" font-size=\"12\" \
             fill=\"currentColor\">\n",
            plain(&self.title)
        );
        self.draw_ground(&mut svg, &frame);
        for curve in &self.curves {
            draw_curve(&mut svg, &frame, curve);
        }
        for level in &self.levels {
            draw_level(&mut svg, &frame, level);
        }
        if !self.title.is_empty() {
            let _ = writeln!(
                svg,
                "<text x=\"{LEFT}\" y=\"17\" font-size=\"14\" font-weight=\"600\">{}</text>",
                marked(&self.title)
            );
        }
        svg.push_str(&legend.concat());
        svg.push_str("</svg>\n");
        svg
    }

    fn frame(&self, top: f64, bottom: f64) -> Frame {
        let points =
            || self.curves.iter().flat_map(|c| &c.points).filter(|p| p[0].is_finite() && p[1].is_finite());
        let zero = self.with_zero.then_some(0.0);
        let mut x = padded_range(points().map(|p| p[0]), 0.0);
        let mut y =
            padded_range(points().map(|p| p[1]).chain(self.levels.iter().map(|l| l.value)).chain(zero), 0.06);
        if self.true_scale {
            x = padded_range(points().map(|p| p[0]), 0.02);
            let per_pixel = ((x[1] - x[0]) / (WIDTH - LEFT - RIGHT)).max((y[1] - y[0]) / (bottom - top));
            x = widened(x, per_pixel * (WIDTH - LEFT - RIGHT));
            y = widened(y, per_pixel * (bottom - top));
        }
        Frame { x, y, top, bottom, y_down: self.y_down }
    }

    fn draw_ground(&self, svg: &mut String, frame: &Frame) {
        let (right, top, bottom) = (WIDTH - RIGHT, frame.top, frame.bottom);
        if let Some([from, to]) = self.shaded.filter(|s| s.iter().all(|x| x.is_finite())) {
            let (a, b) = (frame.x_at(from).clamp(LEFT, right), frame.x_at(to).clamp(LEFT, right));
            let _ = writeln!(
                svg,
                "<rect x=\"{:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\" opacity=\"0.07\"/>",
                a.min(b),
                (b - a).abs(),
                bottom - top
            );
        }
        let (x_ticks, x_decimals) = ticks(frame.x[0], frame.x[1], 6);
        for tick in x_ticks {
            let x = frame.x_at(tick);
            let _ = write!(
                svg,
                "<path d=\"M{x:.1} {top:.1}V{bottom:.1}\" stroke=\"currentColor\" stroke-opacity=\"0.13\"/>"
            );
            let _ = writeln!(
                svg,
                "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" opacity=\"0.8\">{}</text>",
                bottom + 16.0,
                tick_label(tick, x_decimals)
            );
        }
        let (y_ticks, y_decimals) = ticks(frame.y[0], frame.y[1], if self.true_scale { 3 } else { 6 });
        for tick in y_ticks {
            let y = frame.y_at(tick);
            let strength = if tick == 0.0 { 0.45 } else { 0.13 };
            let _ = write!(
                svg,
                "<path d=\"M{LEFT} {y:.1}H{right}\" stroke=\"currentColor\" stroke-opacity=\"{strength}\"/>"
            );
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" opacity=\"0.8\">{}</text>",
                LEFT - 7.0,
                y + 4.0,
                tick_label(tick, y_decimals)
            );
        }
        let _ = writeln!(
            svg,
            "<rect x=\"{LEFT}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.5\"/>",
            right - LEFT,
            bottom - top
        );
        self.draw_labels(svg, frame);
    }

    fn draw_labels(&self, svg: &mut String, frame: &Frame) {
        let middle = 0.5 * (LEFT + WIDTH - RIGHT);
        let _ = writeln!(
            svg,
            "<text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            frame.bottom + 36.0,
            marked(&self.x_label)
        );
        let _ = writeln!(
            svg,
            "<text transform=\"translate(15 {:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            0.5 * (frame.top + frame.bottom),
            marked(&self.y_label)
        );
    }

    /// The legend's entries, line by line.
    fn legend(&self) -> Vec<String> {
        let named: Vec<&Curve> = self.curves.iter().filter(|c| !c.name.is_empty()).collect();
        let base = if self.title.is_empty() { 14.0 } else { 35.0 };
        let (mut lines, mut x): (Vec<String>, f64) = (Vec::new(), f64::INFINITY);
        for curve in named {
            let wide = 34.0 + 6.6 * plain(&curve.name).chars().count() as f64;
            if x + wide > WIDTH - RIGHT {
                x = LEFT;
                lines.push(String::new());
            }
            let y = base + 18.0 * (lines.len() as f64 - 1.0);
            if let Some(line) = lines.last_mut() {
                let _ = write!(line, "{}", key(curve, x, y));
                let _ = writeln!(
                    line,
                    "<text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                    x + 22.0,
                    y + 4.0,
                    marked(&curve.name)
                );
            }
            x += wide;
        }
        lines
    }
}

fn widened([low, high]: [f64; 2], span: f64) -> [f64; 2] {
    let middle = 0.5 * (low + high);
    [middle - 0.5 * span, middle + 0.5 * span]
}

fn colour(number: usize) -> &'static str {
    CURVES[number % CURVES.len()]
}

fn pen(curve: &Curve) -> String {
    let (width, more) = match curve.stroke {
        Stroke::Solid | Stroke::Dots => (2.0, ""),
        Stroke::Faint => (0.8, " stroke-opacity=\"0.45\""),
        Stroke::Dashed => (2.0, " stroke-dasharray=\"6 4\""),
    };
    format!("stroke=\"{}\" stroke-width=\"{width}\"{more}", colour(curve.colour))
}

fn key(curve: &Curve, x: f64, y: f64) -> String {
    match curve.stroke {
        Stroke::Dots => {
            format!("<circle cx=\"{:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{}\"/>", x + 9.0, colour(curve.colour))
        }
        _ => format!("<path d=\"M{x:.1} {y:.1}h18\" {}/>", pen(curve)),
    }
}

fn draw_curve(svg: &mut String, frame: &Frame, curve: &Curve) {
    if curve.stroke == Stroke::Dots {
        for [x, y] in thinned(&curve.points) {
            if x.is_finite() && y.is_finite() {
                let (cx, cy) = (frame.x_at(x), frame.y_at(y));
                let _ = writeln!(
                    svg,
                    "<circle cx=\"{cx:.1}\" cy=\"{cy:.1}\" r=\"2.5\" fill=\"{}\"/>",
                    colour(curve.colour)
                );
            }
        }
        return;
    }
    let mut path = String::new();
    let mut pen_up = true;
    for [x, y] in thinned(&curve.points) {
        if x.is_finite() && y.is_finite() {
            let _ =
                write!(path, "{}{:.1} {:.1}", if pen_up { 'M' } else { 'L' }, frame.x_at(x), frame.y_at(y));
            pen_up = false;
        } else {
            pen_up = true;
        }
    }
    if !path.is_empty() {
        let _ = writeln!(svg, "<path d=\"{path}\" fill=\"none\" stroke-linejoin=\"round\" {}/>", pen(curve));
    }
}

fn draw_level(svg: &mut String, frame: &Frame, level: &Level) {
    if ![level.value, level.from, level.to].iter().all(|v| v.is_finite()) {
        return;
    }
    let (a, b, y) = (frame.x_at(level.from), frame.x_at(level.to), frame.y_at(level.value));
    let _ = writeln!(
        svg,
        "<path d=\"M{a:.1} {y:.1}H{b:.1}\" stroke=\"{0}\" stroke-width=\"1.4\" stroke-dasharray=\"2 3\"/>\
         <text x=\"{1:.1}\" y=\"{2:.1}\" text-anchor=\"end\" font-size=\"11\" fill=\"{0}\" stroke=\"none\">{3}</text>",
        colour(level.colour),
        b.max(a) - 4.0,
        y - 5.0,
        marked(&level.label)
    );
}

/// At most about [`MOST_POINTS`] points that keep every peak: of each run of neighbours the first, the lowest and the
/// highest. Gaps stay gaps.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() <= MOST_POINTS {
        return points.to_vec();
    }
    let run = (4 * points.len()).div_ceil(MOST_POINTS);
    let mut kept = Vec::new();
    for (n, part) in points.chunks(run).enumerate() {
        let by_height = |&a: &usize, &b: &usize| part[a][1].total_cmp(&part[b][1]);
        let finite = || (0..part.len()).filter(|&m| part[m][1].is_finite());
        let mut places = vec![0];
        places.extend(finite().min_by(by_height));
        places.extend(finite().max_by(by_height));
        places.extend((0..part.len()).find(|&m| !part[m][1].is_finite()));
        if (n + 1) * run >= points.len() {
            places.push(part.len() - 1);
        }
        places.sort_unstable();
        places.dedup();
        kept.extend(places.into_iter().map(|m| part[m]));
    }
    kept
}

/// Text with the letters that XML keeps for itself spelled out.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn plain(text: &str) -> String {
    escaped(&text.replace('_', ""))
}

/// Text with subscripts: letters and digits behind `_` are lowered.
fn marked(text: &str) -> String {
    let mut result = String::new();
    let mut parts = text.split('_');
    result.push_str(&escaped(parts.next().unwrap_or_default()));
    for part in parts {
        let end = part.find(|c: char| !c.is_alphanumeric()).unwrap_or(part.len());
        let (low, rest) = part.split_at(end);
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
    fn strange_series_are_drawn() {
        let odd: [Vec<[f64; 2]>; 6] = [
            vec![],
            vec![[0.0, 0.0]],
            vec![[1.0, 5.0]; 9],
            vec![[f64::NAN, f64::NAN]; 9],
            vec![[0.0, 1.0], [1.0, f64::NAN], [2.0, f64::INFINITY], [3.0, -1e300]],
            vec![[0.0, 1e-320], [1e-320, 0.0]],
        ];
        for points in odd {
            for stroke in [Stroke::Solid, Stroke::Dots] {
                let curve = Curve { name: "a_b <c>".into(), points: points.clone(), colour: 99, stroke };
                let level = Level { label: "m".into(), value: f64::NAN, from: 0.0, to: 1.0, colour: 0 };
                for true_scale in [false, true] {
                    let chart = Chart {
                        curves: vec![curve.clone()],
                        levels: vec![level.clone()],
                        shaded: Some([f64::NAN, 1.0]),
                        true_scale,
                        ..Chart::default()
                    };
                    let svg = chart.svg();
                    assert!(
                        svg.ends_with("</svg>\n") && !svg.contains("NaN") && !svg.contains("inf"),
                        "{svg}"
                    );
                }
            }
        }
    }

    #[test]
    fn long_series_are_thinned_and_keep_their_peak() {
        let mut points: Vec<[f64; 2]> =
            (0..50_000).map(|n| [f64::from(n), (f64::from(n) * 0.7).sin()]).collect();
        points[31_234][1] = 9.0;
        let few = thinned(&points);
        assert!(few.len() <= MOST_POINTS + 4, "{}", few.len());
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
