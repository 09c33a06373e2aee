//! The frame of a picture: a region of space at true scale, axes with units, and the bar that explains the
//! colours.

use super::canvas::{Anchor, Canvas, INK, Tone};
use crate::plots::{ColourMap, tick_label, ticks};

const LEFT: f64 = 84.0;
const TOP: f64 = 62.0;
const BOTTOM: f64 = 64.0;
const BAR_ROOM: f64 = 120.0;
const BAR_WIDTH: f64 = 18.0;
/// Largest extent of the drawn region [pixels].
const MOST: [f64; 2] = [1240.0, 760.0];
/// A flat view is given at least this height [pixels], so that the colour bar can be read.
const LEAST_BAR: f64 = 190.0;

/// How values become colours.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scale {
    /// The colours.
    pub(super) map: ColourMap,
    /// Value at the low end, in the unit shown.
    pub(super) low: f64,
    /// Value at the high end, in the unit shown.
    pub(super) high: f64,
    /// Whether equal ratios, not equal differences, are equally far apart.
    pub(super) logarithmic: bool,
    /// What the bar says: quantity, unit, and how the ends were chosen.
    pub(super) label: String,
}

impl Scale {
    /// A linear scale; widened when it has no extent.
    pub(super) fn linear(map: ColourMap, low: f64, high: f64, label: String) -> Self {
        let high = if high > low { high } else { low + 1.0 };
        Self { map, low, high, logarithmic: false, label }
    }

    /// The colour of a value in the unit shown.
    pub(super) fn colour(&self, value: f64) -> Tone {
        let position = if self.logarithmic {
            (value.max(self.low) / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        };
        self.tone(position)
    }

    /// The colour at a fraction of the scale.
    fn tone(&self, position: f64) -> Tone {
        [self.map.at(position), self.map.for_dark().at(position)]
    }

    fn marks(&self) -> Vec<(f64, String)> {
        if self.logarithmic {
            let decades = (self.low.log10().round() as i32)..=(self.high.log10().round() as i32);
            let span = (self.high / self.low).log10();
            let position = |n: i32| (f64::from(n) - self.low.log10()) / span;
            return decades.map(|n| (position(n), power_of_ten(n))).collect();
        }
        let (values, decimals) = ticks(self.low, self.high, 5);
        let position = |v: f64| (v - self.low) / (self.high - self.low);
        values.into_iter().map(|v| (position(v), tick_label(v, decimals))).collect()
    }
}

/// A power of ten as people write it.
fn power_of_ten(n: i32) -> String {
    if (-2..4).contains(&n) {
        return format!("{}", 10f64.powi(n));
    }
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32(0x2070 + c.to_digit(10).unwrap_or(0)).unwrap_or(c),
    };
    format!("10{}", n.to_string().chars().map(raised).collect::<String>())
}

/// A view of a region of space on a canvas.
pub(super) struct View {
    /// The picture.
    pub(super) canvas: Canvas,
    across: [f64; 2],
    upward: [f64; 2],
    scale: f64,
    height: f64,
    width: f64,
}

impl View {
    /// An empty view of `across` by `upward` [m].
    pub(super) fn new(across: [f64; 2], upward: [f64; 2]) -> Self {
        let span = |r: [f64; 2]| (r[1] - r[0]).abs().max(1e-9);
        let scale = (MOST[0] / span(across)).min(MOST[1] / span(upward));
        let (width, height) = (span(across) * scale, span(upward) * scale);
        let (width, height) = (width.clamp(60.0, MOST[0]), height.clamp(40.0, MOST[1]));
        let canvas =
            Canvas::new((LEFT + width + BAR_ROOM) as usize, (TOP + height.max(LEAST_BAR) + BOTTOM) as usize);
        Self { canvas, across, upward, scale, height, width }
    }

    fn top(&self) -> f64 {
        TOP + 0.5 * (self.height.max(LEAST_BAR) - self.height)
    }

    /// Position of a point of space in the picture [pixels].
    pub(super) fn to_pixels(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [LEFT + (x - self.across[0]) * self.scale, self.top() + (self.upward[1] - y) * self.scale]
    }

    /// Metres per pixel.
    pub(super) fn pixel(&self) -> f64 {
        1.0 / self.scale
    }

    /// Colours the view by a function of the point of space.
    pub(super) fn paint(&mut self, colour: impl Fn(f64, f64) -> Option<Tone>) {
        let (top, scale) = (self.top(), self.scale);
        let (across, upward) = (self.across, self.upward);
        let area = [LEFT, top, LEFT + self.width, top + self.height];
        self.canvas
            .paint(area, |px, py| colour(across[0] + (px - LEFT) / scale, upward[1] - (py - top) / scale));
    }

    /// Draws a line through points of space.
    pub(super) fn line(&mut self, points: &[[f64; 2]], colour: Tone, width: f64) {
        let pixels: Vec<[f64; 2]> = points.iter().map(|p| self.to_pixels(*p)).collect();
        self.canvas.line(&pixels, colour, width);
    }

    /// Draws a dashed level across the view, if it is inside.
    pub(super) fn level(&mut self, height: f64, colour: Tone) {
        if height > self.upward[0] && height < self.upward[1] {
            let y = self.to_pixels([self.across[0], height])[1];
            self.canvas.dashes([LEFT, LEFT + self.width], y, colour);
        }
    }

    /// Draws frame, axes, title and colour bar.
    pub(super) fn finish(&mut self, title: &str, axes: [&str; 2], scale: &Scale) {
        self.axes(axes);
        self.bar(scale);
        self.canvas.text(title, [LEFT, 24.0], 21.0, Anchor::Left);
    }

    fn axes(&mut self, labels: [&str; 2]) {
        let (top, bottom, right) = (self.top(), self.top() + self.height, LEFT + self.width);
        self.canvas.line(
            &[[LEFT, top], [right, top], [right, bottom], [LEFT, bottom], [LEFT, top]],
            INK,
            1.0,
        );
        let (values, decimals) = ticks(self.across[0], self.across[1], (self.width / 120.0).ceil() as usize);
        for tick in values {
            let x = self.to_pixels([tick, 0.0])[0];
            self.canvas.line(&[[x, bottom], [x, bottom + 5.0]], INK, 1.0);
            self.canvas.text(&tick_label(tick, decimals), [x, bottom + 17.0], 16.0, Anchor::Centre);
        }
        let (values, decimals) = ticks(self.upward[0], self.upward[1], (self.height / 70.0).ceil() as usize);
        for tick in values {
            let y = self.to_pixels([0.0, tick])[1];
            self.canvas.line(&[[LEFT - 5.0, y], [LEFT, y]], INK, 1.0);
            self.canvas.text(&tick_label(tick, decimals), [LEFT - 9.0, y], 16.0, Anchor::Right);
        }
        self.canvas.text(labels[0], [LEFT + 0.5 * self.width, bottom + 42.0], 18.0, Anchor::Centre);
        self.canvas.text(labels[1], [18.0, 0.5 * (top + bottom)], 18.0, Anchor::Upwards);
    }

    fn bar(&mut self, scale: &Scale) {
        let left = LEFT + self.width + 22.0;
        let (top, height) = (TOP, self.height.max(LEAST_BAR));
        let area = [left, top, left + BAR_WIDTH, top + height];
        self.canvas.paint(area, |_, y| Some(scale.tone(1.0 - (y - top) / height)));
        let corners = [
            [area[0], area[1]],
            [area[2], area[1]],
            [area[2], area[3]],
            [area[0], area[3]],
            [area[0], area[1]],
        ];
        self.canvas.line(&corners, INK, 1.0);
        for (position, label) in scale.marks() {
            let y = top + height * (1.0 - position);
            self.canvas.line(&[[area[2], y], [area[2] + 5.0, y]], INK, 1.0);
            self.canvas.text(&label, [area[2] + 9.0, y], 16.0, Anchor::Left);
        }
        let right = LEFT + self.width + BAR_ROOM - 6.0;
        self.canvas.text(&scale.label, [right, 42.0], 16.0, Anchor::Right);
    }
}
