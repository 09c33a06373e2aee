//! Figures for print, in the style of journals: one or two columns wide, text in faces that come along, told
//! apart in black and white.
//!
//! A [`Figure`] says what is shown; [`figure_files`] makes the picture, as SVG and as PDF, and its data.
//! [`script`] is a program that draws the same from the data, for whoever wants to change them.

mod axes;
mod compose;
mod content;
mod data;
mod drawing;
mod font;
mod label;
mod legend;
mod look;
mod pdf;
mod plotted;
mod python;
mod segment;
mod svg;
#[cfg(test)]
mod tests;
mod text;

pub use content::{Figure, FigureAxis, FigurePoint, FigureSeries, FigureStyle, LegendPlace, SeriesKind};
pub use python::script;

/// The files of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureFiles {
    /// The picture as SVG text; letters are outlines.
    pub svg: String,
    /// The picture as a PDF document.
    pub pdf: Vec<u8>,
    /// The data as CSV text.
    pub csv: String,
}

/// The files of a figure: the same bytes for the same figure.
#[must_use]
pub fn figure_files(figure: &Figure) -> FigureFiles {
    let drawing = compose::compose(figure);
    let about = format!("{} over {}", figure.y.label, figure.x.label);
    FigureFiles { svg: svg::svg(&drawing, &about), pdf: pdf::pdf(&drawing), csv: data::csv(figure) }
}
