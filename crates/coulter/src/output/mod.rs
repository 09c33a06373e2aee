//! The output of a run, by format.

mod element;
mod forecast;

pub use self::element::write_element_tests;
pub use self::forecast::{ForecastFiles, overlays, write_forecast};
pub use input::readable::digits;
pub use report::{
    BodySummary, Colouring, EnergySummary, ImageFormat, RenderOptions, ReportWishes, Results, RimSummary,
    SoilSummary, Summary, Viewpoint, confidence_lines, figure, lowered, pictures, plots, rebuild_report,
    rebuild_report_with, render, render_page, write_case_file,
};
pub use results::overlay::{Overlay, PlotKind};
pub use results::{
    EntryKind, FileError, Inside, OutputError, Progress, checkpoint, fields, folder, progress, tables, vtk,
    vtkhdf,
};
