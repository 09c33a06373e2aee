//! What is made of results: charts, figures for print, pictures, views, the page of a run, and the facade of
//! its folder.
//!
//! [`Results`] owns the folder of a run and what writes into it. Nothing depends on the report but the mesh
//! study, the intervals and the facade.

mod confidence;
pub mod figure;
mod page;
pub mod pictures;
pub mod plots;
mod render;
mod report;
mod run_results;
mod view;

pub use confidence::{explored, finished, make_variations_folder, run_of, variation_folder};
pub use page::{lowered, render_page};
pub use render::{Colouring, ImageFormat, RenderOptions, Viewpoint, render};
pub use report::{
    BodySummary, EnergySummary, ReportWishes, RimSummary, SoilSummary, Summary, confidence_lines, mean_lines,
};
pub use run_results::{
    Results, add_confidence, clear_all, rebuild_report, rebuild_report_with, require_nothing, write_case_file,
};
