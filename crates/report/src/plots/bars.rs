//! Charts of horizontal bars as SVG text, in the style of the others: a line for each bar or for each group
//! of bars.

use super::chart::{LINE, legend_name};
use super::chart_marks::{BOTTOM, RIGHT, WIDTH, colour, marked, plain};
use super::scale::{labelled_ticks, padded_range};
use std::fmt::Write as _;

/// Height of a bar and space between two groups [pixels].
const BAR: f64 = 15.0;
const SPACE: f64 = 9.0;
/// Distance of the stripes of a bar [pixels].
const STRIPE: f64 = 4.0;
/// Width of a letter [pixels], on average.
const LETTER: f64 = 6.4;

/// A bar.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bar {
    /// Where the bar ends; one that is not a number is left out.
    pub value: f64,
    /// An interval, drawn as a thin line.
    pub interval: Option<[f64; 2]>,
    /// Number of the colour of the bar.
    pub colour: usize,
    /// Text at the end of the bar; may be empty.
    pub note: String,
}

/// Bars with one label.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BarGroup {
    /// Label to the left of the bars.
    pub label: String,
    /// The bars.
    pub bars: Vec<Bar>,
}

/// A chart of horizontal bars. Labels may contain subscripts: `F_H`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bars {
    /// Title above the chart.
    pub title: String,
    /// Label of the x axis, with symbol and unit.
    pub x_label: String,
    /// Where all bars begin.
    pub base: f64,
    /// Whether the bars of a group share a line: they should then lie on both sides of the base.
    pub shared: bool,
    /// Names in the legend, with the numbers of their colours.
    pub names: Vec<(String, usize)>,
    /// The bars, from top to bottom.
    pub groups: Vec<BarGroup>,
}

/// Where the axis stands in the picture, and its range.
struct Axis {
    left: f64,
    range: [f64; 2],
}

impl Axis {
    fn at(&self, x: f64) -> f64 {
        self.left + (WIDTH - RIGHT - self.left) * (x - self.range[0]) / (self.range[1] - self.range[0])
    }
}

impl Bars {
    /// The chart as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        let axis = self.axis();
        let title = if self.title.is_empty() { 10.0 } else { 30.0 };
        let legend = self.legend(axis.left, title + 5.0);
        let top = title + LINE * legend.len() as f64;
        let bottom =
            top + SPACE + self.groups.iter().map(|group| self.lines(group) * BAR + SPACE).sum::<f64>();
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {:.0}\" role=\"img\" \
             aria-label=\"{}\" font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif\" font-size=\"12\" \
             fill=\"currentColor\">\n",
            bottom + BOTTOM,
            plain(&self.title)
        );
        self.draw_ground(&mut svg, &axis, top, bottom);
        let mut y = top + SPACE;
        for group in &self.groups {
            self.draw_group(&mut svg, &axis, y, group);
            y += self.lines(group) * BAR + SPACE;
        }
        if !self.title.is_empty() {
            let text = marked(&self.title);
            let _ =
                writeln!(svg, "<text x=\"8\" y=\"17\" font-size=\"14\" font-weight=\"600\">{text}</text>");
        }
        svg.push_str(&legend.concat());
        svg.push_str("</svg>\n");
        svg
    }

    /// Lines that a group takes.
    fn lines(&self, group: &BarGroup) -> f64 {
        if self.shared { 1.0 } else { group.bars.len().max(1) as f64 }
    }

    fn axis(&self) -> Axis {
        let longest = self.groups.iter().map(|group| plain(&group.label).chars().count()).max().unwrap_or(0);
        let left = (LETTER * longest as f64 + 18.0).clamp(66.0, 250.0);
        let bars = || self.groups.iter().flat_map(|group| &group.bars).filter(|bar| bar.value.is_finite());
        let ends = bars().map(|bar| bar.value).chain(bars().filter_map(|bar| bar.interval).flatten());
        let [low, high] = padded_range(ends.chain([self.base]), 0.0);
        // Room for what is written at the ends.
        let written = bars().map(|bar| bar.note.chars().count()).max().unwrap_or(0) as f64;
        let room = (0.04 + LETTER * written / (WIDTH - RIGHT - left)) * (high - low);
        let below = bars().any(|bar| bar.value < self.base);
        Axis { left, range: [if below { low - room } else { low }, high + room] }
    }

    fn draw_ground(&self, svg: &mut String, axis: &Axis, top: f64, bottom: f64) {
        let (left, right) = (axis.left, WIDTH - RIGHT);
        for (tick, label) in labelled_ticks(axis.range, 6, false) {
            let x = axis.at(tick);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {top:.1}V{bottom:.1}\" stroke=\"currentColor\" stroke-opacity=\"0.13\"/>\
                 <text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" opacity=\"0.8\">{label}</text>",
                bottom + 16.0
            );
        }
        let _ = writeln!(
            svg,
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.5\"/>\
             <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            right - left,
            bottom - top,
            0.5 * (left + right),
            bottom + 36.0,
            marked(&self.x_label)
        );
        if self.base.is_finite() {
            let x = axis.at(self.base);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {top:.1}V{bottom:.1}\" stroke=\"currentColor\" stroke-opacity=\"0.6\"/>"
            );
        }
    }

    fn draw_group(&self, svg: &mut String, axis: &Axis, top: f64, group: &BarGroup) {
        let middle = top + 0.5 * self.lines(group) * BAR;
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            axis.left - 7.0,
            middle + 4.0,
            marked(&group.label)
        );
        for (n, bar) in group.bars.iter().enumerate().filter(|(_, bar)| bar.value.is_finite()) {
            let y = if self.shared { top } else { top + BAR * n as f64 };
            draw_bar(svg, axis, y, bar, self.base);
        }
    }

    /// The legend's entries, line by line.
    fn legend(&self, left: f64, top: f64) -> Vec<String> {
        let (mut lines, mut x): (Vec<String>, f64) = (Vec::new(), f64::INFINITY);
        for (name, number) in &self.names {
            let (name, wide) = legend_name(name, left);
            if x + wide > WIDTH - RIGHT {
                x = left;
                lines.push(String::new());
            }
            let y = top + LINE * (lines.len() as f64 - 1.0);
            if let Some(line) = lines.last_mut() {
                fill(line, *number, [x, y - 4.5, 14.0, 9.0]);
                let _ = writeln!(
                    line,
                    "<text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                    x + 20.0,
                    y + 4.0,
                    marked(&name)
                );
            }
            x += wide;
        }
        lines
    }
}

/// A rectangle in the colour of a number, with stripes of its own, so that bars differ without colour, too:
/// x, y, width, height.
fn fill(svg: &mut String, number: usize, [x, y, wide, tall]: [f64; 4]) {
    let is_pale = number / 4 % 2 == 1;
    let _ = writeln!(
        svg,
        "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{wide:.1}\" height=\"{tall}\" fill=\"{0}\" fill-opacity=\"{1}\" stroke=\"{0}\"/>",
        colour(number),
        if is_pale { 0.3 } else { 0.85 }
    );
    let mut stripes = String::new();
    if number % 2 == 1 {
        for n in 1..=(wide / STRIPE) as usize {
            let _ = write!(stripes, "M{:.1} {y:.1}v{tall}", x + STRIPE * n as f64);
        }
    }
    if number / 2 % 2 == 1 {
        let _ = write!(stripes, "M{x:.1} {:.1}h{wide:.1}", y + 0.5 * tall);
    }
    if !stripes.is_empty() {
        let ink = if is_pale { colour(number) } else { "var(--page, #fff)" };
        let _ = writeln!(svg, "<path d=\"{stripes}\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"1.2\"/>");
    }
}

fn draw_bar(svg: &mut String, axis: &Axis, y: f64, bar: &Bar, base: f64) {
    let (from, to) = (axis.at(base), axis.at(bar.value));
    let height = BAR - 3.0;
    fill(svg, bar.colour, [from.min(to), y + 1.5, (to - from).abs(), height]);
    let mut end = to;
    if let Some(ends) = bar.interval.filter(|ends| ends.iter().all(|x| x.is_finite())) {
        let [low, high] = ends.map(|x| axis.at(x));
        let centre = y + 0.5 * BAR;
        let _ = writeln!(
            svg,
            "<path d=\"M{low:.1} {centre:.1}H{high:.1}M{low:.1} {0:.1}v6M{high:.1} {0:.1}v6\" stroke=\"currentColor\" stroke-opacity=\"0.8\"/>",
            centre - 3.0
        );
        end = end.max(high);
    }
    if !bar.note.is_empty() {
        let (x, anchor) = if to < from { (to - 5.0, "end") } else { (end + 5.0, "start") };
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\" font-size=\"11\" opacity=\"0.8\">{}</text>",
            y + 0.5 * BAR + 4.0,
            marked(&bar.note)
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unusual_bars_are_drawn() {
        for value in [0.0, -1.0, 5.0, f64::NAN, f64::INFINITY, 1e-300] {
            for (shared, base) in [(true, 2.0), (false, 0.0)] {
                let bar = Bar {
                    value,
                    interval: Some([value - 1.0, f64::NAN]),
                    colour: 99,
                    note: "a_b <c>".into(),
                };
                let whole = Bar { interval: Some([0.0, 1.0]), ..bar.clone() };
                let group = BarGroup { label: "soil & \"x\"".into(), bars: vec![bar, whole] };
                let names = vec![("first".to_owned(), 0)];
                let chart =
                    Bars { base, shared, names, groups: vec![group, BarGroup::default()], ..Bars::default() };
                let svg = chart.svg();
                assert!(
                    svg.ends_with("</svg>\n") && !svg.contains("inf\"") && !svg.contains("\"inf"),
                    "{svg}"
                );
                assert!(!svg.contains("NaN"), "{svg}");
            }
        }
    }
}
