//! What a chart shows: curves and levels.

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A strong line.
    Solid,
    /// A thin pale line: raw data behind a smoothed curve.
    Faint,
    /// A dashed line: a forecast or another source.
    Dashed,
    /// A dotted line: one more source, where the colours begin anew.
    Dotted,
    /// Dots: a measurement.
    Dots,
}

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name in the legend; nothing for no entry.
    pub name: String,
    /// Points; a gap where one is not a number.
    pub points: Vec<[f64; 2]>,
    /// Number of its colour.
    pub colour: usize,
    /// How it is drawn.
    pub stroke: Stroke,
}

/// A level with its name, drawn over a part of the x axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// What it says at its end.
    pub label: String,
    /// Height on the y axis.
    pub value: f64,
    /// Where it begins on the x axis.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Number of its colour.
    pub colour: usize,
}

impl Curve {
    /// A strong line.
    #[must_use]
    pub fn solid(name: &str, colour: usize, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.to_owned(), points, colour, stroke: Stroke::Solid }
    }
}
