//! What a page consists of: paths and text at places, from which SVG and PDF are written.

use super::segment::Segment;
use super::text::LaidText;

/// A colour: red, green, blue.
pub(super) type Colour = [u8; 3];

/// How a line is drawn.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pen {
    pub(super) colour: Colour,
    /// Width [pt].
    pub(super) width: f64,
    /// Lengths of dashes and gaps [pt]; empty for a solid line.
    pub(super) dashes: Vec<f64>,
}

impl Pen {
    /// A solid black line.
    pub(super) fn black(width: f64) -> Self {
        Self { colour: [0; 3], width, dashes: Vec::new() }
    }
}

/// A path or a text.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    /// A path, drawn and filled.
    Path {
        /// Class of the path, for tests and for those who edit the file: `mark`, `error`, `curve`.
        class: &'static str,
        segments: Vec<Segment>,
        pen: Option<Pen>,
        fill: Option<Colour>,
    },
    /// A text.
    Text {
        text: LaidText,
        /// Where the baseline of the text begins.
        at: [f64; 2],
        /// Whether the text runs upwards.
        is_turned: bool,
    },
}

/// A page [pt], y downwards from its top left corner.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Drawing {
    pub(super) size: [f64; 2],
    pub(super) items: Vec<Item>,
}

impl Drawing {
    /// Adds a path.
    pub(super) fn path(
        &mut self,
        class: &'static str,
        segments: Vec<Segment>,
        pen: Option<Pen>,
        fill: Option<Colour>,
    ) {
        self.items.push(Item::Path { class, segments, pen, fill });
    }

    /// Adds a text whose baseline begins at a place.
    pub(super) fn text(&mut self, text: LaidText, at: [f64; 2]) {
        self.items.push(Item::Text { text, at, is_turned: false });
    }
}
