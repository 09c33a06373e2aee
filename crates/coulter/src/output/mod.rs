//! The output of a run: histories, fields, pictures, a summary and a report.
//!
//! [`Results`] is the facade: it owns the folder of a run. The other modules can also be used on their own.

mod canvas;
pub mod chart;
mod chart_marks;
pub mod checkpoint;
mod colour;
pub mod csv;
pub mod curve;
mod describe;
pub mod energy_plot;
mod error;
mod fields;
mod folder;
mod forecast_files;
mod forecast_overlay;
mod frame;
pub mod lock;
pub mod log;
mod names;
mod overlay;
pub mod picture;
pub mod plot;
pub mod progress;
mod report;
mod report_rows;
mod results;
pub mod run_record;
mod rut;
mod scale;
mod scene;
pub mod summary;
pub mod surface;
pub mod table;
pub mod validate;
mod vtk;

pub use error::OutputError;
pub use folder::{CHECKPOINTS, Contents, inspect};
pub use forecast_files::{ForecastFiles, write_forecast};
pub use forecast_overlay::overlays;
pub use lock::Lock;
pub use overlay::{Overlay, PlotKind};
pub use progress::Progress;
pub use results::{Results, rebuild_report};
pub use run_record::{Outcome, RunRecord, RunStatistics};
pub use summary::Summary;

#[cfg(test)]
mod tests {
    #[test]
    fn the_memory_of_a_cell_view_is_what_the_estimate_assumes() {
        assert_eq!(size_of::<super::fields::CellView>(), crate::case::output_size::SHOWN_CELL);
    }
}
