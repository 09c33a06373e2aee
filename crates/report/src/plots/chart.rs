//! Line charts as SVG text: the same style for every plot of a report. Text and axes inherit the colour of
//! the page, so that charts suit light and dark pages and paper.

use super::chart_marks::{
    Axes, BOTTOM, LEFT, RIGHT, WIDTH, draw_curve, draw_level, escaped, key, marked, plain,
};
use super::curve::{Curve, Level, Stroke};
use super::scale::{labelled_ticks, logarithm, padded_range};
use std::fmt::Write as _;

/// A chart of curves over two axes, linear by default. Labels may contain subscripts: `F_H`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// Title above the chart.
    pub title: String,
    /// Label of the x axis, with symbol and unit.
    pub x_label: String,
    /// Label of the y axis, with symbol and unit.
    pub y_label: String,
    /// Whether y grows downwards (depths).
    pub y_down: bool,
    /// Whether both axes have the same scale.
    pub true_scale: bool,
    /// Height of the picture in pixels; 0 for the default.
    pub height: f64,
    /// Whether y = 0 must be visible.
    pub with_zero: bool,
    /// Whether both axes are logarithmic; values that are not positive are left out.
    pub logarithmic: bool,
    /// Whether the x axis alone is logarithmic; values that are not positive are left out.
    pub logarithmic_x: bool,
    /// The curves, the first one at the back.
    pub curves: Vec<Curve>,
    /// Shaded range of the x axis.
    pub shaded: Option<[f64; 2]>,
    /// Levels.
    pub levels: Vec<Level>,
}

impl Chart {
    /// The chart as SVG text. No two named curves are alike, whether or not one sees colours: of those that
    /// would be, later ones get marks.
    #[must_use]
    pub fn svg(&self) -> String {
        let chart = Self { curves: told_apart(&self.curves), ..self.clone() };
        match (self.logarithmic, self.logarithmic_x) {
            (true, _) => chart.in_logarithms().drawn(),
            (false, true) => chart.in_logarithms_of_x().drawn(),
            (false, false) => chart.drawn(),
        }
    }

    /// The chart with its abscissae replaced by their logarithms.
    fn in_logarithms_of_x(&self) -> Self {
        let mut chart = self.clone();
        for [x, _] in chart.curves.iter_mut().flat_map(|curve| &mut curve.points) {
            *x = logarithm(*x);
        }
        for level in &mut chart.levels {
            [level.from, level.to] = [level.from, level.to].map(logarithm);
        }
        chart.shaded = chart.shaded.map(|ends| ends.map(logarithm));
        chart
    }

    /// The chart with its numbers replaced by their logarithms.
    fn in_logarithms(&self) -> Self {
        let mut chart = Self { with_zero: false, ..self.clone() };
        for point in chart.curves.iter_mut().flat_map(|curve| &mut curve.points) {
            *point = point.map(logarithm);
        }
        for level in &mut chart.levels {
            [level.value, level.from, level.to] = [level.value, level.from, level.to].map(logarithm);
        }
        chart.shaded = chart.shaded.map(|ends| ends.map(logarithm));
        chart
    }

    fn drawn(&self) -> String {
        let legend = self.legend();
        // A long legend makes the chart higher, not its axes lower.
        let height = if self.height > 0.0 { self.height } else { 330.0 }
            + LINE * legend.len().saturating_sub(2) as f64;
        let top = if self.title.is_empty() { 10.0 } else { 30.0 } + LINE * legend.len() as f64;
        let axes = self.axes(top, height - BOTTOM);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
             aria-label=\"{}\" font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif\" font-size=\"12\" \
             fill=\"currentColor\"{}>\n",
            plain(&self.title),
            self.attributes(&axes)
        );
        self.draw_ground(&mut svg, &axes);
        svg.push_str("<g class=\"curves\">\n");
        self.draw_shaded(&mut svg, &axes);
        for curve in &self.curves {
            draw_curve(&mut svg, &axes, curve);
        }
        svg.push_str("</g>\n");
        for level in &self.levels {
            draw_level(&mut svg, &axes, level);
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

    /// Attributes with which the script of a page tells values from positions: ranges of the axes, where they
    /// stand, their labels. On a logarithmic axis ranges are logarithms.
    fn attributes(&self, axes: &Axes) -> String {
        let ([x0, x1], [y0, y1]) = (axes.x, axes.y);
        let logarithmic = match (self.logarithmic, self.logarithmic_x) {
            (true, _) => "xy",
            (false, true) => "x",
            (false, false) => "",
        };
        let down = if self.y_down { " data-down=\"\"" } else { "" };
        format!(
            " class=\"chart\" data-range=\"{x0:.6e} {x1:.6e} {y0:.6e} {y1:.6e}\" data-box=\"{LEFT} {} {:.1} {:.1}\" \
             data-logarithmic=\"{logarithmic}\"{down} data-x=\"{}\" data-y=\"{}\"",
            WIDTH - RIGHT,
            axes.top,
            axes.bottom,
            escaped(&self.x_label),
            escaped(&self.y_label)
        )
    }

    fn axes(&self, top: f64, bottom: f64) -> Axes {
        let points =
            || self.curves.iter().flat_map(|c| &c.points).filter(|p| p[0].is_finite() && p[1].is_finite());
        let zero = self.with_zero.then_some(0.0);
        let mut x = padded_range(points().map(|p| p[0]), 0.0);
        let mut y =
            padded_range(points().map(|p| p[1]).chain(self.levels.iter().map(|l| l.value)).chain(zero), 0.06);
        if self.true_scale {
            x = padded_range(points().map(|p| p[0]), 0.02);
            let per_pixel = ((x[1] - x[0]) / (WIDTH - LEFT - RIGHT)).max((y[1] - y[0]) / (bottom - top));
            x = extended(x, per_pixel * (WIDTH - LEFT - RIGHT));
            y = extended(y, per_pixel * (bottom - top));
        }
        Axes { x, y, top, bottom, y_down: self.y_down }
    }

    fn draw_ground(&self, svg: &mut String, axes: &Axes) {
        let (right, top, bottom) = (WIDTH - RIGHT, axes.top, axes.bottom);
        svg.push_str("<g class=\"ticks\">\n");
        for (tick, label) in labelled_ticks(axes.x, 6, self.logarithmic || self.logarithmic_x) {
            let x = axes.x_at(tick);
            let _ = write!(
                svg,
                "<path d=\"M{x:.1} {top:.1}V{bottom:.1}\" stroke=\"currentColor\" stroke-opacity=\"0.13\"/>"
            );
            let _ = writeln!(
                svg,
                "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" opacity=\"0.8\">{}</text>",
                bottom + 16.0,
                label
            );
        }
        let count = if self.true_scale { 5 } else { 6 };
        for (tick, label) in labelled_ticks(axes.y, count, self.logarithmic) {
            let y = axes.y_at(tick);
            let opacity = if tick == 0.0 && !self.logarithmic { 0.45 } else { 0.13 };
            let _ = write!(
                svg,
                "<path d=\"M{LEFT} {y:.1}H{right}\" stroke=\"currentColor\" stroke-opacity=\"{opacity}\"/>"
            );
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" opacity=\"0.8\">{}</text>",
                LEFT - 7.0,
                y + 4.0,
                label
            );
        }
        svg.push_str("</g>\n");
        let _ = writeln!(
            svg,
            "<rect x=\"{LEFT}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.5\"/>",
            right - LEFT,
            bottom - top
        );
        self.draw_labels(svg, axes);
    }

    fn draw_shaded(&self, svg: &mut String, axes: &Axes) {
        let Some([from, to]) = self.shaded.filter(|s| s.iter().all(|x| x.is_finite())) else { return };
        let [a, b] = [from, to].map(|x| axes.x_at(x).clamp(LEFT, WIDTH - RIGHT));
        let _ = writeln!(
            svg,
            "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" opacity=\"0.07\"/>",
            a.min(b),
            axes.top,
            (b - a).abs(),
            axes.bottom - axes.top
        );
    }

    fn draw_labels(&self, svg: &mut String, axes: &Axes) {
        let middle = 0.5 * (LEFT + WIDTH - RIGHT);
        let _ = writeln!(
            svg,
            "<text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            axes.bottom + 36.0,
            marked(&self.x_label)
        );
        let _ = writeln!(
            svg,
            "<text transform=\"translate(15 {:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            0.5 * (axes.top + axes.bottom),
            marked(&self.y_label)
        );
    }

    /// The legend's entries, line by line.
    fn legend(&self) -> Vec<String> {
        let named: Vec<&Curve> = self.curves.iter().filter(|c| !c.name.is_empty()).collect();
        let base = if self.title.is_empty() { 14.0 } else { 35.0 };
        let (mut lines, mut x): (Vec<String>, f64) = (Vec::new(), f64::INFINITY);
        for curve in named {
            let (name, wide) = legend_name(&curve.name, LEFT);
            if x + wide > WIDTH - RIGHT {
                x = LEFT;
                lines.push(String::new());
            }
            let y = base + LINE * (lines.len() as f64 - 1.0);
            if let Some(line) = lines.last_mut() {
                let _ = write!(line, "{}", key(curve, x, y));
                let _ = writeln!(
                    line,
                    "<text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                    x + 22.0,
                    y + 4.0,
                    marked(&name)
                );
            }
            x += wide;
        }
        lines
    }
}

/// The curves with strokes that differ in dashes or marks, as far as there are any.
fn told_apart(curves: &[Curve]) -> Vec<Curve> {
    let mut used = std::collections::BTreeSet::new();
    let apart = |curve: &Curve| {
        let mut stroke = curve.stroke;
        if !curve.name.is_empty() && stroke != Stroke::Faint && !used.insert(stroke.look()) {
            stroke = stroke.others().find(|other| used.insert(other.look())).unwrap_or(stroke);
        }
        Curve { stroke, ..curve.clone() }
    };
    curves.iter().map(apart).collect()
}

/// Height of a line of a legend [pixels].
pub(super) const LINE: f64 = 18.0;

/// A name in a legend whose lines begin at `left`, shortened to what one line holds, and the width of its
/// entry [pixels].
pub(super) fn legend_name(name: &str, left: f64) -> (String, f64) {
    const KEY: f64 = 34.0;
    const LETTER: f64 = 6.6;
    let letters = |name: &str| name.chars().filter(|c| *c != '_').count();
    let most = ((WIDTH - RIGHT - left - KEY) / LETTER) as usize;
    let shown = if letters(name) > most {
        format!("{}…", name.chars().take(most.saturating_sub(1)).collect::<String>())
    } else {
        name.to_owned()
    };
    let wide = KEY + LETTER * letters(&shown) as f64;
    (shown, wide)
}

fn extended([low, high]: [f64; 2], span: f64) -> [f64; 2] {
    let middle = 0.5 * (low + high);
    [middle - 0.5 * span, middle + 0.5 * span]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_curves_are_alike_without_colour() {
        for stroke in [Stroke::Solid, Stroke::Dashed, Stroke::Dotted, Stroke::Marked { dash: 3, mark: 2 }] {
            let curve =
                |n: usize| Curve { stroke, ..Curve::solid(&format!("{n}"), 0, vec![[0.0, n as f64]]) };
            let looks: std::collections::BTreeSet<_> = told_apart(&(0..60).map(curve).collect::<Vec<_>>())
                .iter()
                .map(|curve| curve.stroke.look())
                .collect();
            assert_eq!(looks.len(), 60, "{stroke:?}");
        }
        let pair = |stroke| [0, 1].map(|n| Curve { stroke, ..Curve::solid("a", n, Vec::new()) });
        let dots = told_apart(&pair(Stroke::Dots));
        assert_eq!([dots[0].stroke, dots[1].stroke], [Stroke::Dots, Stroke::Marks(1)]);
        // What has no name in the legend stays as it is.
        let unnamed = pair(Stroke::Solid).map(|curve| Curve { name: String::new(), ..curve });
        assert_eq!(told_apart(&unnamed), unnamed);
    }

    #[test]
    fn a_legend_of_many_entries_stands_above_the_axes_and_within_the_picture() {
        let curve = |n: usize| Curve {
            name: format!(
                "friction angle φ = {n} deg, a model with a long name of its own, {}",
                "x".repeat(n)
            ),
            points: vec![[0.0, n as f64], [1.0, 2.0]],
            colour: n,
            stroke: Stroke::Marked { dash: n / 7, mark: n % 7 },
        };
        let svg = Chart { title: "t".into(), curves: (0..30).map(curve).collect(), ..Chart::default() }.svg();
        let number = |text: &str, name: &str| -> f64 {
            let rest = text.split(&format!("{name}=\"")).nth(1).unwrap_or_default();
            rest.split('"').next().unwrap_or_default().parse().unwrap_or(f64::NAN)
        };
        let (_, after) = svg.split_once("<rect x=\"66\"").unwrap();
        let (top, tall) = (number(after, " y"), number(after, " height"));
        assert!(tall > 200.0, "the axes are {tall} high");
        let texts = svg.split("<text").skip(1).filter_map(|text| text.split("</text>").next());
        let legend: Vec<&str> = texts.filter(|text| text.contains("deg,")).collect();
        assert_eq!(legend.len(), 30);
        for text in legend {
            let (x, y) = (number(text, " x"), number(text, " y"));
            let letters = text.split('>').nth(1).unwrap_or_default().chars().count() as f64;
            assert!(y < top && x + 6.0 * letters < WIDTH, "{text}");
        }
    }

    #[test]
    fn unusual_series_are_drawn() {
        let odd: [Vec<[f64; 2]>; 6] = [
            vec![],
            vec![[0.0, 0.0]],
            vec![[1.0, 5.0]; 9],
            vec![[f64::NAN, f64::NAN]; 9],
            vec![[0.0, 1.0], [1.0, f64::NAN], [2.0, f64::INFINITY], [3.0, -1e300]],
            vec![[0.0, 1e-320], [1e-320, 0.0]],
        ];
        for points in odd {
            for stroke in [Stroke::Solid, Stroke::Dots, Stroke::Marks(3), Stroke::Marked { dash: 9, mark: 9 }]
            {
                let curve = Curve { name: "a_b <c>".into(), points: points.clone(), colour: 99, stroke };
                let level = Level { label: "m".into(), value: f64::NAN, from: 0.0, to: 1.0, colour: 0 };
                for (true_scale, logarithmic, logarithmic_x) in
                    [(false, false, false), (true, false, false), (false, true, false), (false, false, true)]
                {
                    let chart = Chart {
                        curves: vec![curve.clone()],
                        levels: vec![level.clone()],
                        shaded: Some([f64::NAN, 1.0]),
                        true_scale,
                        logarithmic,
                        logarithmic_x,
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
}
