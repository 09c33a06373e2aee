//! The output of a run, by format.
//!
//! [`Results`] is the facade: it owns the folder of a run and what writes into it. Each format has a folder of modules that
//! states its contract; they depend on each other along the arrows that `tests/structure.rs` lists, and nothing on the report but
//! the mesh study and the intervals.

pub mod checkpoint;
mod confidence;
mod element;
pub mod fields;
mod files;
pub mod folder;
mod forecast;
mod meshes;
mod page;
pub mod pictures;
pub mod plots;
pub mod progress;
mod render;
mod report;
mod results;
pub mod tables;
mod view;
pub mod vtk;

pub use crate::readable::digits;
pub(crate) use confidence::{finished, make_variations_folder, variation_folder};
pub use element::write_element_tests;
pub use files::{EntryKind, FileError, Inside, OutputError};
pub use forecast::{ForecastFiles, overlays, write_forecast};
pub(crate) use meshes::make_meshes_folder;
pub use meshes::mesh_folder;
pub use page::{lowered, render_page};
pub use progress::Progress;
pub use render::{Colouring, ImageFormat, RenderOptions, Viewpoint, render};
pub(crate) use report::mean_lines;
pub use report::{
    BodySummary, EnergySummary, RimSummary, SoilSummary, Summary, confidence_lines, study_lines,
};
pub use results::{Results, rebuild_report, rebuild_report_with};
pub(crate) use results::{add_confidence, add_mesh_study, clear_all, require_nothing};
