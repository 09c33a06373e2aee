//! What a run leaves behind: histories, fields, pictures, a summary and a report.
//!
//! [`Results`] is the front door: it owns the folder of a run. The other modules are its rooms, usable on their own.

mod canvas;
pub mod chart;
mod chart_marks;
pub mod checkpoint;
mod colour;
pub mod csv;
mod describe;
mod error;
mod fields;
mod folder;
mod forecast_files;
mod frame;
pub mod ledger_plot;
pub mod lock;
pub mod log;
pub mod picture;
pub mod plot;
pub mod progress;
pub mod record;
pub mod reference;
mod report;
mod report_rows;
mod results;
pub mod run_record;
mod rut;
mod scale;
pub mod steady;
pub mod summary;
pub mod surface;
pub mod table;
pub mod validate;
pub mod volume;
mod vtk;

pub use error::OutputError;
pub use folder::{CHECKPOINTS, Holds, look};
pub use forecast_files::{Sheets, write_forecast};
pub use lock::Lock;
pub use progress::Progress;
pub use results::{Results, rebuild_report};
pub use run_record::{Outcome, Overlay, PlotKind, RunRecord, RunStatistics};
pub use summary::Summary;
