//! What is made of results: charts, pictures, views, the page of a run, and the facade of its folder.
//!
//! [`Results`] owns the folder of a run and what writes into it. Nothing depends on the report but the mesh
//! study, the intervals and the facade.

mod confidence;
mod meshes;
mod page;
pub mod pictures;
pub mod plots;
mod render;
mod report;
mod run_results;
mod view;

pub use confidence::{finished, make_variations_folder, variation_folder};
pub use meshes::{make_meshes_folder, mesh_folder};
pub use page::{lowered, render_page};
pub use render::{Colouring, ImageFormat, RenderOptions, Viewpoint, render};
pub use report::{
    BodySummary, EnergySummary, RimSummary, SoilSummary, Summary, confidence_lines, mean_lines, study_lines,
};
pub use run_results::{
    Results, add_confidence, add_mesh_study, clear_all, rebuild_report, rebuild_report_with, require_nothing,
};
