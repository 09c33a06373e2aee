//! The content of a chart: curves and levels.

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A solid line.
    Solid,
    /// A thin, pale line: raw data behind a smoothed curve.
    Faint,
    /// A dashed line: a forecast or another source.
    Dashed,
    /// A dotted line: another source, when the colours repeat.
    Dotted,
    /// Dots: a measurement.
    Dots,
    /// A line with marks, one of several series: the numbers of its dashes and of the shape of its marks, so
    /// that it differs from the others without colour, too.
    Marked {
        /// Number of the pattern of dashes; 0 is solid.
        dash: usize,
        /// Number of the shape.
        mark: usize,
    },
    /// Marks alone, one of several series: the number of their shape; 0 are dots.
    Marks(usize),
}

/// Patterns of dashes, the first of which is solid, and shapes of marks, the first of which is a dot.
pub(super) const DASHES: usize = 8;
pub(super) const MARKS: usize = 8;

impl Stroke {
    /// Numbers of the dashes of the stroke (none of marks alone) and of its mark.
    pub(super) fn look(self) -> (Option<usize>, Option<usize>) {
        match self {
            Self::Solid | Self::Faint => (Some(0), None),
            Self::Dashed => (Some(1), None),
            Self::Dotted => (Some(2), None),
            Self::Dots => (None, Some(0)),
            Self::Marked { dash, mark } => (Some(dash % DASHES), Some(mark % MARKS)),
            Self::Marks(mark) => (None, Some(mark % MARKS)),
        }
    }

    /// Strokes of the same kind with other marks, and then of other dashes.
    pub(super) fn others(self) -> impl Iterator<Item = Self> {
        let dash = self.look().0;
        (0..DASHES * MARKS).map(move |n| match dash {
            Some(dash) => Self::Marked { dash: (dash + n / MARKS) % DASHES, mark: n % MARKS },
            None => Self::Marks(n % MARKS),
        })
    }
}

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name in the legend; empty for no entry.
    pub name: String,
    /// Points; a gap where one is not a number.
    pub points: Vec<[f64; 2]>,
    /// Number of the colour of the curve.
    pub colour: usize,
    /// How the curve is drawn.
    pub stroke: Stroke,
}

/// A level with its label, drawn over a range of the x axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Label at the end of the level.
    pub label: String,
    /// Value on the y axis.
    pub value: f64,
    /// Start on the x axis.
    pub from: f64,
    /// End on the x axis.
    pub to: f64,
    /// Number of the colour of the level.
    pub colour: usize,
}

impl Curve {
    /// A solid curve.
    #[must_use]
    pub fn solid(name: &str, colour: usize, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.to_owned(), points, colour, stroke: Stroke::Solid }
    }
}
