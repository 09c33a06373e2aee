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
}

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name in the legend; empty for no entry.
    pub name: String,
    /// Points; a gap where one is not a number.
    pub points: Vec<[f64; 2]>,
    /// Number of its colour.
    pub colour: usize,
    /// How it is drawn.
    pub stroke: Stroke,
}

/// A level with its label, drawn over a range of the x axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Label at its end.
    pub label: String,
    /// Value on the y axis.
    pub value: f64,
    /// Start on the x axis.
    pub from: f64,
    /// End on the x axis.
    pub to: f64,
    /// Number of its colour.
    pub colour: usize,
}

impl Curve {
    /// A solid curve.
    #[must_use]
    pub fn solid(name: &str, colour: usize, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.to_owned(), points, colour, stroke: Stroke::Solid }
    }
}
