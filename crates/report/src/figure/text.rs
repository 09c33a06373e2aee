//! Text set in the faces: glyphs at places, and how wide they are.

use super::font::Face;
use super::label::{Piece, Script};

/// Size of indices and exponents, over that of the line (chosen).
const SCRIPT: f64 = 0.72;
/// How far indices are lowered and exponents raised [em].
const LOW: f64 = 0.16;
const HIGH: f64 = 0.36;
/// Thickness of a bar above a letter, and its gap to it [em].
const BAR: f64 = 0.055;
const BAR_GAP: f64 = 0.13;
/// Slant of the italic face: how far a letter leans over its height.
const SLANT: f64 = 0.21;

/// A glyph at a place, y upwards from the baseline [pt].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlacedGlyph {
    pub(super) face: Face,
    pub(super) glyph: u16,
    pub(super) letter: char,
    pub(super) at: [f64; 2],
    /// Size [pt].
    pub(super) size: f64,
}

/// A bar above a letter [pt]: left, bottom, right and top, y upwards from the baseline.
pub(super) type Bar = [f64; 4];

/// Text as it is set.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LaidText {
    pub(super) glyphs: Vec<PlacedGlyph>,
    pub(super) bars: Vec<Bar>,
    /// Width [pt].
    pub(super) width: f64,
}

impl LaidText {
    /// Sets pieces at a size [pt].
    pub(super) fn of(pieces: &[Piece], size: f64) -> Self {
        let mut laid = Self::default();
        for piece in pieces {
            let face = if piece.is_italic { Face::Italic } else { Face::Upright };
            let (own, up) = match piece.script {
                Script::Line => (size, 0.0),
                Script::Low => (SCRIPT * size, -LOW * size),
                Script::High => (SCRIPT * size, HIGH * size),
            };
            for letter in piece.text.chars() {
                let glyph = face.glyph(letter);
                laid.glyphs.push(PlacedGlyph { face, glyph, letter, at: [laid.width, up], size: own });
                if piece.has_bar {
                    laid.bars.push(bar(face, glyph, [laid.width, up], own));
                }
                laid.width += own * face.advance(glyph);
            }
        }
        laid
    }

    /// The text without its form.
    pub(super) fn words(&self) -> String {
        self.glyphs.iter().map(|glyph| glyph.letter).collect()
    }

    /// Highest and lowest place that the text covers [pt], y upwards from the baseline.
    pub(super) fn heights(&self) -> [f64; 2] {
        let glyphs = self.glyphs.iter().filter_map(|glyph| {
            let [_, low, _, high] = glyph.face.bounds(glyph.glyph)?;
            Some([glyph.at[1] + glyph.size * high, glyph.at[1] + glyph.size * low])
        });
        let bars = self.bars.iter().map(|bar| [bar[3], bar[1]]);
        let widest = |all: [f64; 2], one: [f64; 2]| [all[0].max(one[0]), all[1].min(one[1])];
        glyphs.chain(bars).reduce(widest).unwrap_or_default()
    }
}

/// The bar above a letter: as wide as the letter at its top.
fn bar(face: Face, glyph: u16, [x, y]: [f64; 2], size: f64) -> Bar {
    let [left, _, right, top] = face.bounds(glyph).unwrap_or([0.0, 0.0, 0.5, 0.7]);
    let lean = if face == Face::Italic { SLANT * top } else { 0.0 };
    let (left, right) = (left + 0.8 * lean, right.max(left + lean + 0.3));
    let low = y + size * (top + BAR_GAP);
    [x + size * left, low, x + size * right, low + size * BAR]
}

#[cfg(test)]
mod tests {
    use super::super::label::pieces;
    use super::*;

    #[test]
    fn text_is_measured() {
        let width = |label: &str| LaidText::of(&pieces(label), 10.0).width;
        // Two letters of 0.722 em, and an index of 0.72 of that.
        assert!((width("HH") - 14.44).abs() < 0.02, "{}", width("HH"));
        let index = width("F_H") - width("F");
        assert!((index - 0.72 * 7.22).abs() < 0.02, "{index}");
    }

    #[test]
    fn a_bar_stands_above_its_letter() {
        let text = LaidText::of(&pieces("F̄_H"), 10.0);
        let [left, low, right, high] = text.bars[0];
        let [_, _, _, top] = Face::Italic.bounds(Face::Italic.glyph('F')).unwrap();
        assert!(low > 10.0 * top && high > low && left > 0.0 && right < text.width, "{:?}", text.bars);
        assert_eq!((text.glyphs.len(), text.words().as_str()), (2, "FH"));
        assert!(text.heights()[0] >= high && text.heights()[1] < 0.0);
    }
}
