//! From a figure to a page: where axes, labels, series and legend stand.

use super::axes::{Frame, ScaledAxis, scaled};
use super::content::{Figure, FigureAxis, LegendPlace};
use super::drawing::{Drawing, Item, Pen};
use super::label::{capitalised, pieces, plain};
use super::legend::{Block, Legend};
use super::look::looks;
use super::plotted::{draw_series, occupied};
use super::segment::Segment;
use super::svg::POINTS;
use super::text::LaidText;

/// Lengths of large and small ticks [em].
const TICK: f64 = 0.45;
const SMALL_TICK: f64 = 0.25;
/// Gap between axis and numbers, numbers and label, and round the page [em].
const NUMBER_GAP: f64 = 0.4;
const LABEL_GAP: f64 = 0.45;
const EDGE: f64 = 0.25;
/// Height of digits, and of a line of a label [em].
const DIGITS: f64 = 0.72;
const LINE: f64 = 1.2;
/// Part of the height of the page that a legend above the axes may take (chosen).
const MOST_LEGEND: f64 = 0.25;
/// Width of the frame and its ticks [pt].
const FRAME: f64 = 0.6;
/// Rooms above the data, over their range, that are tried for a legend (chosen).
const ROOMS: [f64; 4] = [0.0, 0.12, 0.25, 0.4];

/// Places for everything but the series.
struct Layout {
    /// Width and height of the page [pt].
    size: [f64; 2],
    frame: Frame,
    legend: Option<(Block, [f64; 2])>,
    y_label: Vec<LaidText>,
}

/// The page of a figure.
pub(super) fn compose(figure: &Figure) -> Drawing {
    let width = figure.style.width * POINTS;
    let looks = looks(figure);
    let legend = Legend::of(figure, &looks);
    let layout = layout(figure, &legend, [width, width * figure.style.aspect]);
    let mut drawing = Drawing { size: layout.size, items: Vec::new() };
    draw_series(&mut drawing, figure, &layout.frame, &looks);
    draw_frame(&mut drawing, &layout.frame);
    draw_numbers(&mut drawing, figure, &layout.frame);
    draw_labels(&mut drawing, figure, &layout);
    if let Some((block, corner)) = &layout.legend {
        legend.draw(&mut drawing, block, *corner);
    }
    drawing
}

/// The ends of both axes as they are drawn, as values.
pub(super) fn ends(figure: &Figure) -> [[f64; 2]; 2] {
    let width = figure.style.width * POINTS;
    let legend = Legend::of(figure, &looks(figure));
    let frame = layout(figure, &legend, [width, width * figure.style.aspect]).frame;
    [(frame.x, &figure.x), (frame.y, &figure.y)].map(|(scaled, axis)| {
        scaled.range.map(|end| if axis.logarithmic { 10f64.powf(end.clamp(-307.0, 307.0)) } else { end })
    })
}

fn layout(figure: &Figure, legend: &Legend, size: [f64; 2]) -> Layout {
    let place = if legend.is_empty() { LegendPlace::None } else { figure.legend };
    match place {
        LegendPlace::None => framed(figure, size, 0.0, 0.0),
        LegendPlace::Outside => outside(figure, legend, size),
        LegendPlace::Inside(place) => {
            let mut layout = framed(figure, size, 0.0, 0.0);
            layout.legend = Some(legend.at(&layout.frame, place));
            layout
        }
        LegendPlace::Automatic => {
            for room in ROOMS {
                let mut layout = framed(figure, size, room, 0.0);
                layout.legend = legend.free(&layout.frame, &occupied(figure, &layout.frame, 2.0));
                if layout.legend.is_some() {
                    return layout;
                }
                if figure.y.logarithmic || figure.y.range.is_some() {
                    break;
                }
            }
            outside(figure, legend, size)
        }
    }
}

/// The layout with the legend above the axes; the page grows where it would take the room of the axes.
fn outside(figure: &Figure, legend: &Legend, [width, height]: [f64; 2]) -> Layout {
    let em = figure.style.font_size;
    let block = legend.block_within(width - 2.0 * EDGE * em);
    let grown = (block.size[1] - MOST_LEGEND * height).max(0.0);
    let mut layout = framed(figure, [width, height + grown], 0.0, block.size[1] + 0.4 * em);
    let [left, top, right, _] = layout.frame.rectangle;
    // In the middle of the axes, unless it is wider than they are.
    let start = (0.5 * (left + right - block.size[0])).min(width - EDGE * em - block.size[0]);
    let corner = [start.max(EDGE * em), top - 0.4 * em - block.size[1]];
    layout.legend = Some((block, corner));
    layout
}

/// The axes with `room` above the data, over their range, and `above` [pt] above the axes.
fn framed(figure: &Figure, size: [f64; 2], room: f64, above: f64) -> Layout {
    let em = figure.style.font_size;
    let [width, height] = size;
    let x_label = LaidText::of(&pieces(&capitalised(&figure.x.label)), em);
    let mut rectangle = [5.0 * em, em, width - em, height - 4.0 * em];
    let mut y_label = Vec::new();
    let mut axes = scaled(figure, [width - 6.0 * em, height - 5.0 * em], room);
    // Margins follow from numbers, and numbers from the size that the margins leave.
    for _ in 0..3 {
        let numbers = |axis: &ScaledAxis| {
            axis.ticks.iter().map(|tick| LaidText::of(&tick.label, em).width).fold(0.0, f64::max)
        };
        y_label = wrapped(&figure.y.label, em, rectangle[3] - rectangle[1]);
        let label_height = LINE * em * y_label.len() as f64;
        // Half of the last number may stand beyond the axis.
        let last = axes[0].ticks.iter().rfind(|tick| !tick.label.is_empty());
        let beyond = last.map_or(0.0, |tick| 0.5 * LaidText::of(&tick.label, em).width);
        let beyond = if figure.x.words.is_empty() { beyond } else { 0.0 };
        let heights = x_label.heights();
        let below = (NUMBER_GAP + DIGITS + LABEL_GAP + EDGE) * em + heights[0] - heights[1];
        rectangle = [
            EDGE * em + label_height + (LABEL_GAP + NUMBER_GAP) * em + numbers(&axes[1]),
            above + (EDGE + 0.5 * DIGITS) * em,
            width - EDGE * em - beyond,
            height - below,
        ];
        axes = scaled(figure, [rectangle[2] - rectangle[0], rectangle[3] - rectangle[1]], room);
    }
    let [x, y] = axes;
    Layout { size, frame: Frame { x, y, rectangle }, legend: None, y_label }
}

/// A label in one line, or in two where one is too long.
fn wrapped(label: &str, em: f64, most: f64) -> Vec<LaidText> {
    let label = capitalised(label);
    let whole = LaidText::of(&pieces(&label), em);
    if whole.width <= most {
        return vec![whole];
    }
    let spaces = label.match_indices(' ').map(|(at, _)| at);
    let halves = spaces.map(|at| {
        let (first, second) = label.split_at(at);
        [first, second.trim_start()].map(|half| LaidText::of(&pieces(half), em))
    });
    let width = |halves: &[LaidText; 2]| halves[0].width.max(halves[1].width);
    halves.min_by(|a, b| width(a).total_cmp(&width(b))).map_or_else(|| vec![whole], Vec::from)
}

/// The frame, with ticks inwards on all four sides.
fn draw_frame(drawing: &mut Drawing, frame: &Frame) {
    let [left, top, right, bottom] = frame.rectangle;
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
    let mut segments = vec![Segment::Move(corners[0])];
    segments.extend(corners[1..].iter().map(|corner| Segment::Line(*corner)));
    segments.push(Segment::Close);
    drawing.path("frame", segments, Some(Pen::black(FRAME)), None);
    let em = 8.0;
    let mut ticks = Vec::new();
    let mut tick = |from: [f64; 2], to: [f64; 2]| ticks.extend([Segment::Move(from), Segment::Line(to)]);
    for (number, axis) in [&frame.x, &frame.y].into_iter().enumerate() {
        for one in &axis.ticks {
            let along = (one.position - axis.range[0]) / (axis.range[1] - axis.range[0]);
            let length = em * if one.label.is_empty() { SMALL_TICK } else { TICK };
            // On a corner it would only thicken the frame.
            if !(1e-6..=1.0 - 1e-6).contains(&along) {
                continue;
            }
            if number == 0 {
                let x = left + along * (right - left);
                tick([x, bottom], [x, bottom - length]);
                tick([x, top], [x, top + length]);
            } else {
                let y = bottom - along * (bottom - top);
                tick([left, y], [left + length, y]);
                tick([right, y], [right - length, y]);
            }
        }
    }
    drawing.path("ticks", ticks, Some(Pen::black(FRAME)), None);
}

/// The numbers at the ticks; those that would touch the one before are left out.
fn draw_numbers(drawing: &mut Drawing, figure: &Figure, frame: &Frame) {
    let em = figure.style.font_size;
    let [left, top, right, bottom] = frame.rectangle;
    let slot = (right - left) / figure.x.words.len().max(1) as f64;
    let mut end = f64::NEG_INFINITY;
    for tick in frame.x.ticks.iter().filter(|tick| !tick.label.is_empty()) {
        let mut text = LaidText::of(&tick.label, em);
        if !figure.x.words.is_empty() && text.width > 0.95 * slot {
            text = shortened(&text.words(), em, 0.95 * slot);
        }
        let along = (tick.position - frame.x.range[0]) / (frame.x.range[1] - frame.x.range[0]);
        let start = left + along * (right - left) - 0.5 * text.width;
        if (-1e-6..=1.0 + 1e-6).contains(&along) && start > end {
            end = start + text.width + 0.3 * em;
            drawing.text(text, [start, bottom + (NUMBER_GAP + DIGITS) * em]);
        }
    }
    for tick in frame.y.ticks.iter().filter(|tick| !tick.label.is_empty()) {
        let text = LaidText::of(&tick.label, em);
        let along = (tick.position - frame.y.range[0]) / (frame.y.range[1] - frame.y.range[0]);
        let y = bottom - along * (bottom - top);
        if (-1e-6..=1.0 + 1e-6).contains(&along) {
            let start = left - NUMBER_GAP * em - text.width;
            drawing.text(text, [start, y + 0.5 * DIGITS * em]);
        }
    }
}

/// A word with as many letters as a width holds [pt].
fn shortened(word: &str, em: f64, most: f64) -> LaidText {
    let letters: Vec<char> = word.chars().collect();
    let with = |count: usize| {
        let text: String = letters[..count].iter().collect();
        LaidText::of(&plain(&format!("{text}…")), em)
    };
    (0..letters.len()).rev().map(with).find(|text| text.width <= most).unwrap_or_default()
}

fn draw_labels(drawing: &mut Drawing, figure: &Figure, layout: &Layout) {
    let em = figure.style.font_size;
    let [left, top, right, bottom] = layout.frame.rectangle;
    let text = LaidText::of(&pieces(&label_of(&figure.x)), em);
    let start = (0.5 * (left + right - text.width)).max(0.0);
    let y = bottom + (NUMBER_GAP + DIGITS + LABEL_GAP) * em + text.heights()[0];
    drawing.text(text, [start, y]);
    for (n, text) in layout.y_label.iter().enumerate() {
        let x = EDGE * em + em * (LINE * n as f64 + 0.95);
        let middle = 0.5 * (top + bottom) + 0.5 * text.width;
        let at = [x, middle.min(drawing.size[1])];
        drawing.items.push(Item::Text { text: text.clone(), at, is_turned: true });
    }
}

fn label_of(axis: &FigureAxis) -> String {
    capitalised(&axis.label)
}
