//! The legend: its entries, and where it hides no data.

use super::axes::Frame;
use super::content::{Figure, FigureSeries, LegendPlace, SeriesKind};
use super::drawing::Drawing;
use super::label::{Piece, pieces, plain};
use super::look::{Look, Mark, draw_mark, names};
use super::segment::Segment;
use super::text::LaidText;

/// Length of a line in the legend, the gap behind it and between columns [em].
const KEY: f64 = 3.0;
const GAP: f64 = 0.5;
const BETWEEN: f64 = 1.1;
/// Distance between two lines [em].
const ROW: f64 = 1.3;
/// Distance of the legend from the axes [em].
const INSET: f64 = 0.7;

/// A name and what is drawn before it.
pub(super) struct NamedLook {
    pub(super) name: Vec<Piece>,
    pub(super) line: Option<Look>,
    pub(super) mark: Option<Look>,
    pub(super) is_hollow: bool,
}

impl NamedLook {
    /// A look with the name of what it stands for.
    fn of(name: Vec<Piece>, look: Look) -> Self {
        let (line, mark) = if look.dash.is_some() { (Some(look), None) } else { (None, Some(look)) };
        Self { name, line, mark, is_hollow: false }
    }
}

/// An entry that is set.
struct Entry {
    looked: NamedLook,
    text: LaidText,
}

/// A legend that is set, and has no place yet.
pub(super) struct Legend {
    entries: Vec<Entry>,
    /// Size of text [pt].
    em: f64,
    line_width: f64,
    mark_size: f64,
}

/// Entries in columns.
pub(super) struct Block {
    /// Widths of the columns [pt].
    widths: Vec<f64>,
    rows: usize,
    /// Width and height [pt].
    pub(super) size: [f64; 2],
}

impl Legend {
    /// The legend of a figure; without entries where nothing needs a name.
    pub(super) fn of(figure: &Figure, looks: &[Look]) -> Self {
        let style = &figure.style;
        let laid = |looked: NamedLook| Entry { text: LaidText::of(&looked.name, style.font_size), looked };
        let entries = if figure.legend == LegendPlace::None {
            Vec::new()
        } else {
            entries(figure, looks).into_iter().map(laid).collect()
        };
        Self { entries, em: style.font_size, line_width: style.line_width, mark_size: style.mark_size }
    }

    /// Whether there is nothing to be said.
    pub(super) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The entries in a number of columns.
    pub(super) fn block(&self, columns: usize) -> Block {
        let rows = self.entries.len().div_ceil(columns.max(1)).max(1);
        let width = |part: &[Entry]| {
            (KEY + GAP) * self.em + part.iter().map(|entry| entry.text.width).fold(0.0, f64::max)
        };
        let widths: Vec<f64> = self.entries.chunks(rows).map(width).collect();
        let between = BETWEEN * self.em * widths.len().saturating_sub(1) as f64;
        let size = [widths.iter().sum::<f64>() + between, ROW * self.em * rows as f64];
        Block { widths, rows, size }
    }

    /// The entries in as many columns as a width holds [pt].
    pub(super) fn block_within(&self, width: f64) -> Block {
        let fits = |columns: &usize| self.block(*columns).size[0] <= width;
        self.block((1..=self.entries.len()).rev().find(fits).unwrap_or(1))
    }

    /// Top left corner of a block at a place inside of the axes: from left and from the top, 0 to 2 each.
    fn corner(&self, block: &Block, frame: &Frame, place: [usize; 2]) -> [f64; 2] {
        let inset = INSET * self.em;
        let [left, top, right, bottom] = frame.rectangle;
        let along = |low: f64, high: f64, size: f64, third: usize| match third {
            0 => low + inset,
            1 => 0.5 * (low + high - size),
            _ => high - inset - size,
        };
        [along(left, right, block.size[0], place[0]), along(top, bottom, block.size[1], place[1])]
    }

    /// The block and its corner at a given place.
    pub(super) fn at(&self, frame: &Frame, place: [usize; 2]) -> (Block, [f64; 2]) {
        let block = self.block(1);
        let corner = self.corner(&block, frame, place);
        (block, corner)
    }

    /// A block and its corner where it hides none of the places; `None` where there is no room.
    pub(super) fn free(&self, frame: &Frame, occupied: &[[f64; 2]]) -> Option<(Block, [f64; 2])> {
        /// Corners first, then sides.
        const PLACES: [[usize; 2]; 8] = [[2, 0], [0, 0], [2, 2], [0, 2], [2, 1], [0, 1], [1, 0], [1, 2]];
        let [left, top, right, bottom] = frame.rectangle;
        let clear = 0.5 * self.mark_size + 0.25 * self.em;
        for columns in 1..=self.entries.len().min(3) {
            let block = self.block(columns);
            let [width, height] = block.size;
            // A legend that fills the axes is no ornament.
            if width > 0.75 * (right - left) || height > 0.6 * (bottom - top) {
                continue;
            }
            for place in PLACES {
                let corner = self.corner(&block, frame, place);
                let hides = |at: &[f64; 2]| {
                    (corner[0] - clear..=corner[0] + width + clear).contains(&at[0])
                        && (corner[1] - clear..=corner[1] + height + clear).contains(&at[1])
                };
                if !occupied.iter().any(hides) {
                    return Some((block, corner));
                }
            }
        }
        None
    }

    /// Draws a block with its top left corner at a place.
    pub(super) fn draw(&self, drawing: &mut Drawing, block: &Block, corner: [f64; 2]) {
        let mut left = corner[0];
        for (column, width) in self.entries.chunks(block.rows).zip(&block.widths) {
            for (n, entry) in column.iter().enumerate() {
                let middle = corner[1] + ROW * self.em * (n as f64 + 0.5);
                let [start, end] = [left, left + KEY * self.em];
                if let Some(look) = entry.looked.line {
                    let segments = vec![Segment::Move([start, middle]), Segment::Line([end, middle])];
                    drawing.path("key", segments, Some(look.pen(self.line_width)), None);
                }
                if let Some(look) = &entry.looked.mark {
                    let at = [0.5 * (start + end), middle];
                    draw_mark(drawing, look, at, self.mark_size, entry.looked.is_hollow);
                }
                drawing.text(entry.text.clone(), [end + GAP * self.em, middle + 0.35 * self.em]);
            }
            left += width + BETWEEN * self.em;
        }
    }
}

/// The entries. Where every kind has one source, levels and sources are named apart: a level with its line
/// and its mark, then what lines and marks are.
pub(super) fn entries(figure: &Figure, looks: &[Look]) -> Vec<NamedLook> {
    let all: Vec<(&FigureSeries, &Look)> = figure.series.iter().zip(looks).collect();
    let of = |kind: SeriesKind| all.iter().filter(move |(series, _)| series.kind == kind);
    let is_measured = |series: &FigureSeries| series.kind == SeriesKind::Measured;
    let sources = |kind: SeriesKind| names(of(kind).map(|(series, _)| series.source.as_str()));
    let models = [SeriesKind::Line, SeriesKind::Dots, SeriesKind::Computed];
    let levels = names(all.iter().filter(|(s, _)| !is_measured(s)).map(|(s, _)| s.level.as_str()));
    let mut found: Vec<NamedLook> = Vec::new();
    let has_levels = levels.len() > 1 || levels.iter().any(|level| !level.is_empty());
    let is_factored = has_levels && models.iter().all(|kind| sources(*kind).len() < 2);
    if is_factored {
        for level in &levels {
            let look = |kind: SeriesKind| of(kind).find(|(s, _)| s.level == *level).map(|(_, look)| **look);
            let mark = look(SeriesKind::Computed).or(look(SeriesKind::Dots));
            let line = look(SeriesKind::Line);
            let name = match all.iter().find(|(series, _)| series.level == *level) {
                Some((series, _)) if level.is_empty() => plain(&series.source),
                _ => pieces(level),
            };
            found.push(NamedLook { name, line, mark, is_hollow: false });
        }
    } else {
        let mut seen = Vec::new();
        for (series, look) in all.iter().filter(|(series, _)| !is_measured(series)) {
            let name = [series.level.as_str(), series.source.as_str()];
            if seen.contains(&name) {
                continue;
            }
            seen.push(name);
            found.push(NamedLook::of(full_name(series), **look));
        }
    }
    // What has no level is named already.
    let has_level = |kind: &SeriesKind| of(*kind).any(|(series, _)| !series.level.is_empty());
    let kinds: Vec<SeriesKind> = models.into_iter().filter(has_level).collect();
    if is_factored && kinds.len() > 1 {
        for kind in kinds {
            let look = of(kind).next().map(|(_, look)| black(**look));
            if let Some((look, name)) = look.zip(sources(kind).first()) {
                found.push(NamedLook::of(plain(name), look));
            }
        }
    }
    let doubtful = of(SeriesKind::Computed).find(|(s, _)| s.points.iter().any(|p| p.is_doubtful()));
    if let Some((series, look)) = doubtful {
        let name = plain(&format!("{}, doubtful", series.source));
        found.push(NamedLook { is_hollow: true, ..NamedLook::of(name, black(**look)) });
    }
    // One series alone is told by caption and labels.
    if found.len() == 1 && !has_levels && of(SeriesKind::Measured).next().is_none() {
        found.clear();
    }
    for (series, look) in of(SeriesKind::Measured) {
        found.push(NamedLook::of(plain(&series.source), **look));
    }
    found
}

/// A look that stands for all levels: black, a solid line or a circle.
fn black(look: Look) -> Look {
    let mark = look.mark.map(|mark| match mark {
        Mark::Computed(_) => Mark::Computed(0),
        Mark::Dot(_) => Mark::Dot(0),
        other => other,
    });
    Look { colour: [0; 3], dash: look.dash.map(|_| 0), mark, is_bold: false }
}

/// Level and source of a series.
fn full_name(series: &FigureSeries) -> Vec<Piece> {
    let mut name = pieces(&series.level);
    let gap = if name.is_empty() || series.source.is_empty() { "" } else { ", " };
    name.extend(plain(&format!("{gap}{}", series.source)));
    name
}
