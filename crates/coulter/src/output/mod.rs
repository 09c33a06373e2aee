//! The output of a run, by format.
//!
//! [`Results`] is the facade: it owns the folder of a run and what writes into it. Each format has a folder of modules that
//! states its contract; they depend on each other along the arrows that `tests/structure.rs` lists, and nothing on the report.

pub mod checkpoint;
pub mod fields;
mod files;
pub mod folder;
mod forecast;
pub mod pictures;
pub mod plots;
pub mod progress;
mod report;
mod results;
pub mod tables;
mod units;
pub mod vtk;

pub use files::OutputError;
pub use forecast::{ForecastFiles, overlays, write_forecast};
pub use progress::Progress;
pub use report::{BodySummary, EnergySummary, MeshSummary, RimSummary, SoilSummary, Summary};
pub use results::{Results, rebuild_report};
