//! The axes: their ranges, ticks, and where values lie on the page.

use super::content::{Figure, FigureAxis};
use super::label::{Piece, Script, plain};
use crate::plots::{padded_range, tick_label};

/// Ticks of an axis that are wanted (chosen): one for each of these lengths [pt].
const APART: [f64; 2] = [46.0, 30.0];
/// Part of the largest value below which an axis begins at zero (chosen).
const FROM_ZERO: f64 = 0.4;
/// Decades in which numbers are written out on a logarithmic axis (chosen).
const WRITTEN: std::ops::RangeInclusive<i32> = -3..=4;

/// A tick: position along the axis, and its label, of which small ticks have none.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub(super) position: f64,
    pub(super) label: Vec<Piece>,
}

/// One axis with its range, in positions, and its ticks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ScaledAxis {
    pub(super) range: [f64; 2],
    pub(super) ticks: Vec<Tick>,
}

/// Both axes and the rectangle on the page that they span.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) x: ScaledAxis,
    pub(super) y: ScaledAxis,
    /// Left, top, right and bottom [pt].
    pub(super) rectangle: [f64; 4],
}

impl Frame {
    /// Where a point lies on the page; `None` where it has no place on an axis.
    pub(super) fn at(&self, figure: &Figure, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let [left, top, right, bottom] = self.rectangle;
        let place = |axis: &ScaledAxis, position: f64| {
            let along = (position - axis.range[0]) / (axis.range[1] - axis.range[0]);
            // Far outside is as good as anywhere outside, and drawable.
            along.is_finite().then(|| along.clamp(-100.0, 100.0))
        };
        let x = place(&self.x, figure.x.position(x))?;
        let y = place(&self.y, figure.y.position(y))?;
        Some([left + (right - left) * x, bottom - (bottom - top) * y])
    }

    /// Whether a place on the page lies inside.
    pub(super) fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let [left, top, right, bottom] = self.rectangle;
        let tolerance = 1e-6;
        (left - tolerance..=right + tolerance).contains(&x)
            && (top - tolerance..=bottom + tolerance).contains(&y)
    }
}

/// Both axes of a figure, number 0 and 1, for a rectangle of this size [pt], the y axis with some more room
/// at its top, over its range.
pub(super) fn scaled(figure: &Figure, size: [f64; 2], room: f64) -> [ScaledAxis; 2] {
    [0, 1].map(|number| {
        let axis = if number == 0 { &figure.x } else { &figure.y };
        let room = if number == 1 && axis.range.is_none() { room } else { 0.0 };
        let count = (size[number] / APART[number]).round().clamp(2.0, 9.0) as usize;
        if !axis.words.is_empty() {
            return of_words(&axis.words);
        }
        let range = range(figure, axis, number, room);
        if axis.logarithmic { logarithmic(range, count) } else { linear(range, count, axis.range.is_none()) }
    })
}

/// The range of an axis in positions.
fn range(figure: &Figure, axis: &FigureAxis, number: usize, room: f64) -> [f64; 2] {
    if let Some(given) = axis.range {
        let given = given.map(|end| axis.position(end));
        if given.iter().all(|end| end.is_finite()) && given[0] != given[1] {
            return given;
        }
    }
    let points = figure.series.iter().flat_map(|series| &series.points);
    let values = points.flat_map(|point| {
        let ends = if number == 0 { point.x_ends } else { point.y_ends };
        [point.at[number]].into_iter().chain(ends.into_iter().flatten())
    });
    let [low, high] = padded_range(values.map(|value| axis.position(value)), 0.04);
    let [low, high] = if axis.logarithmic || low * high < 0.0 && low < -0.05 * (high - low) {
        [low, high]
    } else if high > 0.0 && low < FROM_ZERO * high {
        [0.0, high]
    } else if low < 0.0 && high > FROM_ZERO * low {
        [low, 0.0]
    } else {
        [low, high]
    };
    [low, high + room * (high - low)]
}

fn of_words(words: &[String]) -> ScaledAxis {
    let tick = |(n, word): (usize, &String)| Tick { position: n as f64, label: plain(word) };
    ScaledAxis {
        range: [-0.5, words.len() as f64 - 0.5],
        ticks: words.iter().enumerate().map(tick).collect(),
    }
}

/// Distance of the numbers of an axis: one, two or five times a power of ten, nearest to what is wanted.
fn step(span: f64, count: usize) -> f64 {
    let wanted = span / count as f64;
    let decade = 10f64.powf(wanted.log10().floor());
    let off = |step: f64| (step / wanted).ln().abs();
    let steps = [1.0, 2.0, 5.0, 10.0].map(|lead| lead * decade);
    steps.into_iter().min_by(|a, b| off(*a).total_cmp(&off(*b))).unwrap_or(decade)
}

/// A linear axis; where it may move its ends it ends on small ticks.
fn linear([low, high]: [f64; 2], count: usize, is_free: bool) -> ScaledAxis {
    let [least, most] = [low.min(high), low.max(high)];
    let step = step(most - least, count);
    if !(step.is_finite() && step > 0.0) {
        return ScaledAxis { range: [low, high], ticks: Vec::new() };
    }
    let decimals = (-(step * 1.001).log10().floor()).max(0.0) as usize;
    // Quarters of a step of two, fifths of the others.
    let lead = step / 10f64.powf((step * 1.001).log10().floor());
    let parts = if (lead - 2.0).abs() < 0.3 { 4.0 } else { 5.0 };
    let small = step / parts;
    let out = |end: f64, towards: fn(f64) -> f64, nudge: f64| small * towards(end / small + nudge);
    let [least, most] =
        if is_free { [out(least, f64::floor, 1e-6), out(most, f64::ceil, -1e-6)] } else { [least, most] };
    let [first, last] = [(least / small - 1e-6).ceil(), (most / small + 1e-6).floor()];
    let numbers = (0..=200).map(|n| first + f64::from(n)).take_while(|n| *n <= last);
    let tick = |n: f64| {
        let is_large = (n / parts - (n / parts).round()).abs() < 1e-6;
        let label = if is_large { plain(&tick_label(n * small, decimals)) } else { Vec::new() };
        Tick { position: n * small, label }
    };
    let ends = if low <= high { [least, most] } else { [most, least] };
    ScaledAxis { range: ends, ticks: numbers.map(tick).collect() }
}

/// A logarithmic axis; positions are logarithms.
fn logarithmic(range: [f64; 2], count: usize) -> ScaledAxis {
    let [low, high] = [range[0].min(range[1]), range[0].max(range[1])];
    let [first, last] = [low.floor().max(-300.0) as i32, high.ceil().min(300.0) as i32];
    let span = high - low;
    let written: &[i32] = if span < 0.8 {
        &[1, 2, 3, 4, 5, 6, 8]
    } else if span < 1.7 {
        &[1, 2, 5]
    } else {
        &[1]
    };
    let stride = (span / count as f64).ceil().max(1.0) as i32;
    let mut ticks = Vec::new();
    for decade in first..=last {
        for lead in 1..10 {
            let position = f64::from(decade) + f64::from(lead).log10();
            if !(low - 1e-9..=high + 1e-9).contains(&position) {
                continue;
            }
            let has_label = written.contains(&lead) && decade.rem_euclid(stride) == 0;
            let label = if has_label { power(lead, decade, [first, last]) } else { Vec::new() };
            ticks.push(Tick { position, label });
        }
    }
    ScaledAxis { range, ticks }
}

/// A number of a logarithmic axis: written out where all of them are short, otherwise as a power of ten.
fn power(lead: i32, decade: i32, ends: [i32; 2]) -> Vec<Piece> {
    if ends.iter().all(|end| WRITTEN.contains(end)) {
        let decimals = usize::try_from(-decade).unwrap_or(0);
        return plain(&tick_label(f64::from(lead) * 10f64.powi(decade), decimals));
    }
    let mut pieces = plain(&if lead == 1 { "10".to_owned() } else { format!("{lead}·10") });
    let exponent = decade.to_string().replace('-', "\u{2212}");
    pieces.push(Piece { text: exponent, script: Script::High, ..Piece::default() });
    pieces
}

#[cfg(test)]
mod tests {
    use super::super::content::{FigurePoint, FigureSeries, SeriesKind};
    use super::*;

    fn figure(points: &[[f64; 2]]) -> Figure {
        let points = points.iter().map(|at| FigurePoint { at: *at, ..FigurePoint::default() }).collect();
        let (level, source) = (String::new(), String::new());
        Figure {
            series: vec![FigureSeries { kind: SeriesKind::Line, level, source, points }],
            ..Figure::default()
        }
    }

    fn labels(axis: &ScaledAxis) -> Vec<String> {
        let text = |tick: &Tick| tick.label.iter().map(|piece| piece.text.as_str()).collect::<String>();
        axis.ticks.iter().map(text).filter(|text| !text.is_empty()).collect()
    }

    #[test]
    fn axes_begin_at_zero_or_on_a_tick() {
        let [x, y] = scaled(&figure(&[[0.02, 100.0], [0.97, 103.0]]), [200.0, 140.0], 0.0);
        assert_eq!(x.range[0], 0.0);
        assert_eq!(labels(&x), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert!(y.range[0] > 99.0 && y.range[1] < 104.0, "{:?}", y.range);
        let on_tick = |end: f64| y.ticks.iter().any(|tick| (tick.position - end).abs() < 1e-9);
        assert!(y.range.iter().all(|end| on_tick(*end)));
    }

    #[test]
    fn logarithmic_axes_have_decades() {
        let mut wide = figure(&[[1e-8, 0.02], [1e4, 30.0]]);
        wide.x.logarithmic = true;
        wide.y.logarithmic = true;
        let [x, y] = scaled(&wide, [200.0, 140.0], 0.0);
        assert!(labels(&x).contains(&"10\u{2212}4".to_owned()), "{:?}", labels(&x));
        assert_eq!(labels(&y), ["0.1", "1", "10"]);
    }

    #[test]
    fn given_ends_are_kept() {
        let mut given = figure(&[[0.0, 0.0], [1.0, 1.0]]);
        given.x.range = Some([0.13, 0.77]);
        given.y.range = Some([2.0, 0.0]);
        let [x, y] = scaled(&given, [200.0, 140.0], 0.3);
        assert_eq!([x.range, y.range], [[0.13, 0.77], [2.0, 0.0]]);
    }

    #[test]
    fn odd_values_have_axes() {
        for points in [
            vec![],
            vec![[f64::NAN, 1.0]],
            vec![[0.0, 0.0]],
            vec![[1e-320, 1e300], [0.0, -1e300]],
            vec![[5.0, 5.0]; 3],
        ] {
            for logarithmic in [false, true] {
                let mut odd = figure(&points);
                odd.x.logarithmic = logarithmic;
                odd.y.logarithmic = logarithmic;
                for axis in scaled(&odd, [200.0, 140.0], 0.0) {
                    assert!(axis.range.iter().all(|end| end.is_finite()) && axis.ticks.len() < 4000);
                }
            }
        }
    }
}
