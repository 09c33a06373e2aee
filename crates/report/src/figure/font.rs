//! The faces of the text: metrics and outlines.

use super::segment::Segment;
use std::sync::LazyLock;
use ttf_parser::{GlyphId, OutlineBuilder};

/// A face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Face {
    /// Words, numbers, units.
    Upright,
    /// Symbols of quantities.
    Italic,
}

const UPRIGHT: &[u8] = include_bytes!("../../assets/FigureSans-Regular.ttf");
const ITALIC: &[u8] = include_bytes!("../../assets/FigureSans-Italic.ttf");

type Parsed = Option<ttf_parser::Face<'static>>;

static FACES: LazyLock<[Parsed; 2]> =
    LazyLock::new(|| [UPRIGHT, ITALIC].map(|bytes| ttf_parser::Face::parse(bytes, 0).ok()));

impl Face {
    fn parsed(self) -> Option<&'static ttf_parser::Face<'static>> {
        FACES[self as usize].as_ref()
    }

    /// The file of the face.
    pub(super) fn bytes(self) -> &'static [u8] {
        match self {
            Self::Upright => UPRIGHT,
            Self::Italic => ITALIC,
        }
    }

    /// Name of the face in documents; the letters before it say that it is a part of a larger one.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Upright => "CLTRFG+FigureSans",
            Self::Italic => "CLTRFG+FigureSans-Italic",
        }
    }

    /// One unit of the face [em].
    fn unit(self) -> f64 {
        self.parsed().map_or(1.0, |face| 1.0 / f64::from(face.units_per_em()))
    }

    /// Number of the glyph of a letter; of one that the face lacks that of `?`.
    pub(super) fn glyph(self, letter: char) -> u16 {
        let find = |letter: char| self.parsed()?.glyph_index(letter);
        find(letter).or_else(|| find('?')).map_or(0, |glyph| glyph.0)
    }

    /// How far a glyph moves on [em].
    pub(super) fn advance(self, glyph: u16) -> f64 {
        let units = self.parsed().and_then(|face| face.glyph_hor_advance(GlyphId(glyph)));
        self.unit() * f64::from(units.unwrap_or(0))
    }

    /// Left, bottom, right and top of a glyph [em]; `None` of a space.
    pub(super) fn bounds(self, glyph: u16) -> Option<[f64; 4]> {
        let found = self.parsed()?.glyph_bounding_box(GlyphId(glyph))?;
        Some([found.x_min, found.y_min, found.x_max, found.y_max].map(|units| self.unit() * f64::from(units)))
    }

    /// Ascent, descent, height of capitals and slant [em, em, em, deg].
    pub(super) fn metrics(self) -> [f64; 4] {
        let Some(face) = self.parsed() else { return [0.9, -0.2, 0.7, 0.0] };
        let of = |units: i16| self.unit() * f64::from(units);
        let capitals = face.capital_height().map_or(0.7, of);
        [of(face.ascender()), of(face.descender()), capitals, f64::from(face.italic_angle())]
    }

    /// Left, bottom, right and top of all glyphs [em].
    pub(super) fn extent(self) -> [f64; 4] {
        let Some(face) = self.parsed() else { return [0.0, -0.2, 1.0, 1.0] };
        let all = face.global_bounding_box();
        [all.x_min, all.y_min, all.x_max, all.y_max].map(|units| self.unit() * f64::from(units))
    }

    /// The outline of a glyph [em], y upwards.
    pub(super) fn outline(self, glyph: u16) -> Vec<Segment> {
        let mut pen = Pen { unit: self.unit(), segments: Vec::new() };
        if let Some(face) = self.parsed() {
            let _ = face.outline_glyph(GlyphId(glyph), &mut pen);
        }
        pen.segments
    }
}

struct Pen {
    unit: f64,
    segments: Vec<Segment>,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> [f64; 2] {
        [self.unit * f64::from(x), self.unit * f64::from(y)]
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.segments.push(Segment::Move(self.at(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.segments.push(Segment::Line(self.at(x, y)));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.segments.push(Segment::Bend(self.at(x1, y1), self.at(x, y)));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.segments.push(Segment::Curve([self.at(x1, y1), self.at(x2, y2), self.at(x, y)]));
    }

    fn close(&mut self) {
        self.segments.push(Segment::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sign_of_the_labels_is_there() {
        for face in [Face::Upright, Face::Italic] {
            let lacking = face.glyph('?');
            for letter in "Fφψγμηωθτσ°²³−–·×≤≥±°(),.:/=+0123456789éü".chars() {
                assert_ne!(face.glyph(letter), lacking, "{letter}");
                assert!(face.advance(face.glyph(letter)) > 0.1, "{letter}");
            }
            assert!(face.outline(face.glyph('F')).len() > 8 && face.bounds(face.glyph(' ')).is_none());
        }
        // The metrics are those of Arial.
        assert!((Face::Upright.advance(Face::Upright.glyph('H')) - 0.722).abs() < 1e-3);
    }
}
