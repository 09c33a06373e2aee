//! Plots of numbers over numbers as SVG text, in one style: charts in general, and those of a run.
//!
//! Nothing here reads a state or writes a file. Units are chosen so that axes are easy to read.

mod bars;
mod chart;
mod chart_marks;
mod colour;
mod curve;
mod energy_plot;
mod mesh_plot;
mod plot;
mod rim_plot;
mod scale;

pub use bars::{Bar, BarGroup, Bars};
pub use chart::Chart;
pub(crate) use colour::{CURVES, ColourMap, Rgb};
pub use curve::{Curve, Level, Stroke};
pub use energy_plot::{closure_plot, energy_plot};
pub(crate) use mesh_plot::MeshPlot;
pub use plot::{BodyHistory, Plot, Units};
pub use rim_plot::rim_plots;
pub(crate) use scale::{padded_range, tick_label, ticks};
