//! Charts of a study as SVG text, in the style of the report of a run, and figures for print.

mod classes;
mod collapse;
mod effects;
mod family;
mod history;
mod label;
mod named;
mod portions;
mod request;
#[cfg(test)]
pub(crate) mod samples;
mod surrogate;

pub(crate) use classes::models;
pub use collapse::collapse_chart;
pub use effects::{FactorEffect, main_effects_chart, tornado_chart};
pub use family::{ToldFigure, family_figure};
pub use history::{RunCurve, history_figure};
pub use label::{axis_label, level_name, plain_label};
pub use named::NamedChart;
pub use portions::sobol_chart;
pub use request::ChartRequest;
pub use surrogate::surrogate_chart;
